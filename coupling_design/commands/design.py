"""`design CASE`: the main job."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from coupling_design.commands.options import CaseFile, Overrides

if TYPE_CHECKING:
    from coupling_design.flow.outcome import DesignOutcome

EXAMPLES = (
    "design cases/16v280.yaml",
    "cases/16v280.yaml --output elsewhere",
    "cases/16v280.yaml --set connection.gap=0.1mm --set reading=combined_load",
)
_NO_DESIGN = 1


def run(
    case: CaseFile,
    output: Annotated[
        Path | None,
        typer.Option(
            metavar="DIR",
            show_default=False,
            help="where the results go (reports/<name of the case file>)",
        ),
    ] = None,
    overrides: Overrides = None,
) -> int:
    """Design the coupling of a machine: five steps, a report and its files."""
    from coupling_design.case import load_case
    from coupling_design.flow.design import run_design
    from coupling_design.flow.speed_map import evaluate_speed_map
    from coupling_design.report.console.console import make_report_console, print_report
    from coupling_design.report.console.progress import show_progress
    from coupling_design.report.console.report import render_outcome
    from coupling_design.report.files.write import prepare_directory, write_files
    from coupling_design.report.page.library import HOW_TO_GET, can_write_html

    directory = output or Path("reports", Path(case).stem)
    loaded = load_case(case, overrides or ())
    prepare_directory(directory)
    with show_progress() as progress:
        outcome = run_design(loaded, progress)
    console = make_report_console()
    report = print_report(console, render_outcome(outcome))
    # Nothing but the figures wants the speed range.
    draws = bool(outcome.histories)
    speed_map = evaluate_speed_map(loaded, outcome.chosen) if draws else None
    written = (
        *write_files(outcome, directory, speed_map, report),
        *_write_chosen(outcome, directory),
    )
    console.print(*(f"Written: {path}" for path in written), sep="\n", soft_wrap=True)
    if draws and not can_write_html():
        console.print(HOW_TO_GET, soft_wrap=True)
    return _NO_DESIGN if outcome.chosen is None else 0


def _write_chosen(outcome: DesignOutcome, directory: Path) -> tuple[Path, ...]:
    """Write the chosen design as a case; take an old one away where there is none."""
    from coupling_design.errors import DesignError
    from coupling_design.report.console.console import make_error_console
    from coupling_design.report.files.chosen_case import chosen_case_text
    from coupling_design.report.files.write import write_atomically

    file = directory / "chosen.yaml"
    if outcome.chosen is None:
        file.unlink(missing_ok=True)
        return ()
    try:
        write_atomically(file, chosen_case_text(outcome, directory))
    except DesignError as error:
        make_error_console().print(f"Not written: {file}: {error}", soft_wrap=True)
        file.unlink(missing_ok=True)
        return ()
    return (file,)

"""`check CASE`: is the file right, and was it understood as it was meant?"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import groupby
from typing import TYPE_CHECKING, Annotated

import typer

from coupling_design.commands.options import CaseFile, Overrides

if TYPE_CHECKING:
    from rich.console import RenderableType

    from coupling_design.case.echo import EchoedValue
    from coupling_design.machine.machine import Case

EXAMPLES = (
    "check cases/16v280.yaml",
    "check cases/16v280.yaml --notes",
    "check cases/16v280.yaml --set connection.gap=0.1mm",
)
_RIGHT = (2, 5)  # columns: SI value, line
_WIDEST = 26
_JUDGED = ("assumed", "fitted", "invented")


def run(
    case: CaseFile,
    *,
    overrides: Overrides = None,
    notes: Annotated[
        bool, typer.Option("--notes", help="show the note of each value too")
    ] = False,
) -> int:
    """Validate a case and echo every value in SI, with its source and line.

    All problems of the file are reported at once. What the file leaves to a default
    is listed at the end.
    """
    from coupling_design.case.echo import echo
    from coupling_design.case.edit.overrides import override
    from coupling_design.case.load import case_of, read_document
    from coupling_design.checks.time_step import check_time_step
    from coupling_design.report.console.console import make_report_console

    document = override(read_document(case), overrides or ())
    loaded = case_of(document)
    check_time_step(loaded)
    values = echo(document)
    console = make_report_console()
    for part in _parts(loaded, values, show_notes=notes):
        console.print(part)
    return 0


def _parts(
    case: Case, values: Sequence[EchoedValue], *, show_notes: bool
) -> Iterator[RenderableType]:
    from rich.text import Text

    from coupling_design.checks.warnings import case_warnings
    from coupling_design.report.console.blocks import bullets, facts

    given = [value for value in values if not value.is_default]
    widths = [max(map(len, column)) for column in zip(*map(_cells, given), strict=True)]
    for section, inside in groupby(given, key=lambda value: _split(value.path)[0]):
        yield Text(section or "top level", style="bold")
        yield _rows(list(inside), widths, show_notes=show_notes)
    derived = _derived(case, given)
    if derived:
        yield Text("Worked out from these", style="bold")
        yield facts(derived)
    defaults = [value for value in values if value.is_default]
    if defaults:
        yield Text("Not given", style="bold")
        yield facts((f"  {value.path}", _default(value)) for value in defaults)
    warned = bullets("Read first", case_warnings(case))
    if warned is not None:
        yield warned
    yield Text()
    yield facts(_conclusion(case, given, defaults))


def _rows(
    values: Sequence[EchoedValue], widths: Sequence[int], *, show_notes: bool
) -> RenderableType:
    """Return lines of one section; equal widths keep all sections in line."""
    from rich.console import Group
    from rich.padding import Padding
    from rich.table import Table
    from rich.text import Text

    parts: list[RenderableType] = []
    for value in values:
        row = Table.grid(padding=(0, 2, 0, 0))
        for index, width in enumerate(widths):
            if index in _RIGHT:
                row.add_column(width=width, justify="right")
            else:
                row.add_column(width=min(width, _WIDEST), overflow="fold")
        row.add_row(*map(Text, _cells(value)))
        parts.append(row)
        if show_notes and value.note:
            parts.append(Padding(Text(value.note, style="dim"), (0, 0, 0, 4)))
    return Group(*parts)


def _cells(value: EchoedValue) -> tuple[str, ...]:
    """Return key, as written, SI value, SI unit, source and line."""
    is_number = isinstance(value.value, float)
    return (
        f"  {_split(value.path)[1]}",
        value.text,
        f"{value.value:.6g}" if is_number else "",
        (value.unit or "-") if is_number else "",
        value.source,
        "--set" if value.is_override else f"{value.line}",
    )


def _split(path: str) -> tuple[str, str]:
    section, _, key = path.rpartition(".")
    return section, key


def _derived(case: Case, given: Sequence[EchoedValue]) -> list[tuple[str, str]]:
    """Return what the case worked out for itself, such as an engine's orders."""
    written = {value.path for value in given}
    return [
        (f"  {value.path}", value.text)
        for value in case.provenance
        if value.path not in written and value.source == "derived"
    ]


def _default(value: EchoedValue) -> str:
    if value.value is None:
        return "left out"
    shown = f"{value.value} {value.unit}".strip()
    return f"default: {shown or 'empty'}"


def _conclusion(
    case: Case, given: Sequence[EchoedValue], defaults: Sequence[EchoedValue]
) -> Iterator[tuple[str, str]]:
    from coupling_design.checks.time_step import candidates, stable_step
    from coupling_design.line.modes import natural_angular_frequency

    judged = sum(value.source in _JUDGED for value in given)
    frequency = float(natural_angular_frequency(case.driveline)) / (2 * math.pi)
    step = case.shutdown.time_step
    largest = min(stable_step(case, candidate) for candidate in candidates(case))
    yield "case file", f"{case.file}: no problem found"
    yield from (("--set", each) for each in case.overrides)
    yield (
        "values",
        f"{len(given)} given, {judged} of them assumed, fitted or invented; "
        f"{len(defaults)} not given",
    )
    yield "present coupling", f"natural frequency {frequency:.4g} Hz, gap closed"
    yield (
        "time step",
        f"{step:g} s makes {case.shutdown.n_steps} steps; stable with every coupling "
        f"are up to {largest:.3g} s",
    )

"""`simulate CASE`: one run-down."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from coupling_design.commands.options import CaseFile, Overrides, Size

if TYPE_CHECKING:
    from collections.abc import Iterator

    from rich.console import RenderableType

    from coupling_design.explore.grid import Grid, Quantity
    from coupling_design.explore.simulation import Simulation
    from coupling_design.machine.machine import Case
    from coupling_design.wear.performance import Performance

EXAMPLES = (
    "simulate cases/16v280.yaml",
    "simulate cases/16v280.yaml --out run.csv",
    "simulate cases/16v280.yaml --stiffness 0.5x --gap 0.1mm --out run.parquet",
    "simulate cases/16v280.yaml --type diaphragm --stiffness 193MN*m/rad "
    "--connection tight_fit",
)


def _option(help: str, metavar: str = "VALUE", *names: str) -> Any:  # noqa: A002  typer's word
    return typer.Option(*names, metavar=metavar, show_default=False, help=help)


_Stiffness = Annotated[
    str | None,
    _option("dynamic stiffness C_Tdyn, 12kN*m/rad or 0.5x the present one"),
]
_Gap = Annotated[str | None, _option("key gap, 0.1mm or 0.5x the present one")]
_Type = Annotated[
    str | None, _option("coupling type of the case (the present one)", "NAME", "--type")
]
_Connection = Annotated[
    str | None, _option("key, spline or tight_fit (the present one)", "KIND")
]
_Out = Annotated[
    Path | None, _option("write the signals: .csv, .parquet or .nc", "FILE")
]
_Every = Annotated[
    int, typer.Option(metavar="N", min=1, help="write every Nth step only")
]


def run(
    case: CaseFile,
    stiffness: _Stiffness = None,
    gap: _Gap = None,
    coupling_type: _Type = None,
    connection: _Connection = None,
    size: Size = None,
    out: _Out = None,
    every: _Every = 1,
    overrides: Overrides = None,
) -> int:
    """Roll out one coupling's run-down: speeds, forces, loads and damage over time.

    The present coupling, unless said otherwise; another type at the stiffness of its
    range nearest to the present one, a size with all that its sheet states. Totals are
    judged over all crank angles, signals are those of the one whose peak decides.
    """
    from coupling_design.case import load_case
    from coupling_design.explore.files import check_file, write_grid
    from coupling_design.explore.points import find_point
    from coupling_design.explore.simulation import simulate_point
    from coupling_design.report.console.blocks import bullets
    from coupling_design.report.console.console import make_report_console
    from coupling_design.report.console.performances import render_design
    from coupling_design.report.console.progress import show_progress

    loaded = load_case(case, overrides or ())
    point = find_point(loaded, stiffness, gap, coupling_type, connection, size)
    if out is not None:
        check_file(out)
    with show_progress() as progress:
        progress("run-down")
        simulation = simulate_point(loaded, point)
    console = make_report_console()
    label = point.candidate.label
    warned = bullets("Read first", _warnings(loaded, simulation.performance))
    if warned is not None:
        console.print(warned, "")
    console.print(render_design(label, simulation.performance, None), "")
    for sentence in _sentences(simulation):
        console.print(sentence, "", sep="\n")
    console.print(_render(simulation.signals))
    if out is not None:
        write_grid(simulation.signals.every(every), out)
        console.print(f"Written: {out}", soft_wrap=True)
    return 0


def _warnings(case: Case, performance: Performance) -> tuple[str, ...]:
    from coupling_design.checks.warnings import case_warnings, run_down_warnings

    return (*case_warnings(case), *run_down_warnings(case, performance, "Run-down"))


def _sentences(simulation: Simulation) -> Iterator[str]:
    """Yield over what the totals are judged, of which run-down the signals are."""
    from coupling_design.checks.warnings import stop_remark
    from coupling_design.report.words.chances import CHAOTIC, describe_chances

    facts = simulation.signals.facts
    remark = stop_remark(simulation.case, simulation.performance)
    if remark is not None:
        yield f"Note: {remark}."
    yield f"Judged over {describe_chances(simulation.performance)}"
    yield (
        f"Signals: of the run-down whose peak decides, crank angle "
        f"{facts['crank_angle']}, gravity at {facts['gravity_angle']}."
    )
    if simulation.is_chaotic:
        yield CHAOTIC


def _render(signals: Grid) -> RenderableType:
    """Return a line per signal: at the start, at the end, its extremes and when."""
    from rich.text import Text

    from coupling_design.report.console.blocks import table
    from coupling_design.report.words.units import display_unit

    rows = table(
        ["signal"],
        ["start", "end", "least", "at\ns", "largest", "at\ns"],
        ["unit"],
    )
    for signal in signals.quantities:
        unit = display_unit("" if signal.unit == "1" else signal.unit)
        rows.add_row(Text(signal.name), *_numbers(signal, signals), Text(unit))
    return rows


def _numbers(signal: Quantity, signals: Grid) -> tuple[str, ...]:
    from coupling_design.report.words.numbers import significant
    from coupling_design.report.words.units import quantity

    values, time = signal.values, signals.values("time")
    least, largest = int(values.argmin()), int(values.argmax())

    def shown(index: int) -> str:
        return quantity(float(values[index]), signal.unit)

    return (
        shown(0),
        shown(-1),
        shown(least),
        significant(float(time[least])),
        shown(largest),
        significant(float(time[largest])),
    )

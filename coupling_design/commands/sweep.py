"""`sweep CASE WHAT...`: a run-down at every point of a grid."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from coupling_design.commands.group import INTERRUPTED
from coupling_design.commands.options import CaseFile, Overrides, Size, complete_place

if TYPE_CHECKING:
    from rich.console import RenderableType

    from coupling_design.explore.grid import Grid, Quantity

EXAMPLES = (
    "sweep cases/16v280.yaml stiffness=0.5..2x:31 gap=0..0.3mm:7 --out map.nc",
    "sweep cases/16v280.yaml lubrication.viscosity=20..60mm^2/s:5",
    "sweep cases/16v280.yaml cleanliness=high,normal,severe --out oil.csv",
    "sweep cases/16v280.yaml stiffness=0.1..1MN*m/rad:21log --set gap=0.1mm",
)
_MOST_ROWS = 40
_SHOWN = ("natural_frequency", "peak_transmission_force", "damage")
_RESULTS = (*_SHOWN, "peak_combined_load_1", "peak_combined_load_2")
_SHORT = {
    "stiffness": "C_Tdyn",
    "natural_frequency": "f_n",
    "damage": "D",
    "peak_transmission_force": "peak F_c",
    "peak_combined_load_1": "peak load 1",
    "peak_combined_load_2": "peak load 2",
}

_What = Annotated[
    list[str],
    typer.Argument(
        metavar="PATH=VALUES...",
        show_default=False,
        autocompletion=complete_place,
        help="what varies: stiffness, gap, or any value by its path in the case; "
        "LOW..HIGH:COUNT, with a unit or x for times the present value, log after the "
        "count for equal ratios; or values between commas",
    ),
]
_Out = Annotated[
    Path | None,
    typer.Option(
        metavar="FILE",
        show_default=False,
        help="write all points: .nc, .csv or .parquet",
    ),
]


def run(
    case: CaseFile,
    what: _What,
    out: _Out = None,
    size: Size = None,
    overrides: Overrides = None,
) -> int:
    """Roll out a run-down at every point of a grid of any values of the case.

    The present coupling, or a size, in the order written, the first varying slowest.
    Each point is judged over all crank angles. Interrupted with Ctrl-C, it leaves the
    points that are finished.
    """
    from coupling_design.case.edit.overrides import override
    from coupling_design.case.load import case_of, read_document
    from coupling_design.checks.warnings import case_warnings
    from coupling_design.commands.progress import count_progress
    from coupling_design.explore.axes import parse_axes
    from coupling_design.explore.files import check_file, write_grid
    from coupling_design.explore.sweep import COMPLETE, plan_sweep, run_sweep
    from coupling_design.report.console.blocks import bullets
    from coupling_design.report.console.console import make_report_console

    document = override(read_document(case), overrides or ())
    loaded = case_of(document)
    axes = parse_axes(document, loaded, what)
    plan = plan_sweep(document, loaded, axes, size)
    if out is not None:
        check_file(out)
    with count_progress("run-downs", plan.size) as advance:
        grid = run_sweep(plan, advance)
    console = make_report_console()
    warned = bullets("Read first", case_warnings(loaded))
    if warned is not None:
        console.print(warned, "")
    for part in _parts(grid):
        console.print(part)
    if out is not None:
        write_grid(grid, out)
        console.print(f"Written: {out}", soft_wrap=True)
    return 0 if grid.facts["status"] == COMPLETE else INTERRUPTED


def _parts(grid: Grid) -> Sequence[RenderableType]:
    import numpy as np
    from rich.text import Text

    from coupling_design.explore.sweep import COMPLETE
    from coupling_design.report.words.chances import CHAOTIC

    columns = {column.name: column for column in grid.columns()}
    known = np.flatnonzero(np.isfinite(columns["damage"].values))
    axes = [axis.name for axis in grid.axes]
    parts: list[RenderableType] = [Text(f"{grid.facts['coupling']}")]
    if len(known) <= _MOST_ROWS:
        parts.append(_points(columns, axes, known.tolist()))
    parts += [Text(), _extremes(columns, axes, known.tolist())]
    ends = {
        name: columns[name].values[known] for name in ("above_resonance", "final_speed")
    }
    parts += _endings(ends, float(grid.facts["rest_speed"])) if len(known) else []
    chaotic = int((columns["chaotic"].values[known] > 0).sum())
    if chaotic:
        parts.append(Text(f"{chaotic} of {len(known)} points. {CHAOTIC}"))
    missing = columns["damage"].values.size - len(known)
    if grid.facts["status"] != COMPLETE:
        parts.append(Text(f"Sweep {grid.facts['status']}."))
    elif missing:
        parts.append(
            Text(f"{missing} run-downs left finite numbers; their results are NaN.")
        )
    return parts


def _endings(ends: dict[str, Any], rest_speed: float) -> list[RenderableType]:
    """Return how many run-downs end too soon to show the passage, and any too soon."""
    from rich.text import Text

    from coupling_design.report.words.units import quantity

    told: list[RenderableType] = []
    above, points = int((ends["above_resonance"] > 0).sum()), len(ends["final_speed"])
    if above:
        told.append(
            Text(
                f"{above} of {points} points end above the resonance with the largest "
                "order: the passage is in neither peaks nor damage. Write a longer "
                "shutdown.duration."
            )
        )
    turning = float(ends["final_speed"].max())
    if turning > rest_speed:
        told.append(
            Text(
                f"Cut off: at some points the set turns at "
                f"{quantity(turning, 'rad/s')} rpm when the run-down ends; what "
                "follows is not in the damage."
            )
        )
    return told


def _points(
    columns: dict[str, Quantity], axes: Sequence[str], rows: Sequence[int]
) -> RenderableType:
    """Return a line per point."""
    from coupling_design.report.console.blocks import table

    shown = [columns[name] for name in (*axes, *_SHOWN)]
    lines = table([], [_heading(column) for column in shown], [])
    for row in rows:
        lines.add_row(*(_number(column, row) for column in shown))
    return lines


def _extremes(
    columns: dict[str, Quantity], axes: Sequence[str], rows: Sequence[int]
) -> RenderableType:
    """Return where each result is least and where it is largest."""
    from rich.text import Text

    from coupling_design.report.console.blocks import table

    at = [_heading(columns[name]) for name in axes]
    lines = table(["result", ""], ["value", *(f"at {each}" for each in at)], [])
    for name in _RESULTS if rows else ():
        values = columns[name].values
        for word, row in (
            ("least", min(rows, key=lambda row: values[row])),
            ("largest", max(rows, key=lambda row: values[row])),
        ):
            place = (_number(columns[axis], row) for axis in axes)
            heading = Text(_heading(columns[name]).replace("\n", ", "))
            lines.add_row(heading, word, _number(columns[name], row), *place)
    return lines


def _heading(column: Quantity) -> str:
    from coupling_design.report.words.units import display_unit

    name = _SHORT.get(column.name, column.name.rpartition(".")[2])
    unit = display_unit("" if column.unit == "1" else column.unit)
    return f"{name}\n{unit}" if column.unit else name


def _number(column: Quantity, row: int) -> str:
    from coupling_design.report.words.damages import damage
    from coupling_design.report.words.units import quantity

    value = column.values[row]
    if isinstance(value, str):
        return str(value)
    if column.name.startswith("damage"):
        return damage(float(value))
    return quantity(float(value), column.unit)

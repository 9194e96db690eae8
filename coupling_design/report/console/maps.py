"""The map of damage and peak force over stiffness and gap, thinned to fit a page."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from rich.console import Group
from rich.table import Table
from rich.text import Text

from coupling_design.report.console.blocks import table, titled
from coupling_design.report.words.damages import damage_e6
from coupling_design.report.words.units import quantity
from coupling_design.search.design_map import DesignMap

_COLUMNS, _ROWS = 6, 5
_SMALL_DIGITS = 3


def render_map(map_: DesignMap) -> Group:
    """Return a map as two small tables: a row for each gap, a column each stiffness."""
    columns = spread(len(map_.torsional_stiffness), _COLUMNS)
    rows = spread(len(map_.key_gap), _ROWS)
    points = len(map_.torsional_stiffness) * len(map_.key_gap)
    return titled(
        f"Map of {map_.name}: {points} rollouts, {len(rows) * len(columns)} of them "
        "shown, all in design.json",
        Group(
            Text("damage in the paper's unit (D x 1e6) over gap and C_Tdyn [MN*m/rad]"),
            _grid(map_, map_.damage, rows, columns, _damage),
            Text(),
            Text("peak F_c [kN]"),
            _grid(map_, map_.peak_transmission_force, rows, columns, _force),
            Text(),
            Text(time_step_note(map_)),
        ),
    )


def time_step_note(map_: DesignMap) -> str:
    """Return in words which time step a map was rolled out with, and its error."""
    coarse = map_.coarse
    if coarse is None:
        return "All at the case's own time step."
    return (
        f"Between the first and the last gap the time step is {coarse.time_step:.3g} "
        f"s, {coarse.times} times the case's own. At {coarse.checked} points rolled "
        f"out with both, damage differs by at most {coarse.damage_error * 100:.1g} %, "
        f"peak F_c by at most {coarse.peak_error * 100:.1g} %. No decision rests on it."
    )


def spread(count: int, shown: int) -> tuple[int, ...]:
    """Return at most `shown` indices spread over `count`, both ends among them."""
    if count <= shown:
        return tuple(range(count))
    return tuple(round(i * (count - 1) / (shown - 1)) for i in range(shown))


def _damage(value: float) -> str:
    return damage_e6(value, _SMALL_DIGITS)


def _force(value: float) -> str:
    return quantity(value, "N")


def _grid(
    map_: DesignMap,
    values: Sequence[Sequence[float]],
    rows: Sequence[int],
    columns: Sequence[int],
    show: Callable[[float], str],
) -> Table:
    stiffnesses = [quantity(map_.torsional_stiffness[j], "N*m/rad") for j in columns]
    grid = table([], ["gap mm", *stiffnesses], [])
    for i in rows:
        shown = [show(values[i][j]) for j in columns]
        grid.add_row(quantity(map_.key_gap[i], "m"), *shown)
    return grid

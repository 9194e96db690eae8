"""What couplings do, as tables: designs in rows, or quantities in rows."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from rich.console import Group, RenderableType
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from coupling_design.report.console.blocks import table, titled
from coupling_design.report.words.damages import damage, damage_e6
from coupling_design.report.words.names import verdict
from coupling_design.report.words.numbers import significant
from coupling_design.report.words.units import quantity
from coupling_design.steps.step_result import Alternative
from coupling_design.wear.performance import Performance
from coupling_design.wear.signals import Rundown

DESIGN_HEADERS = ("C_Tdyn\nMN*m/rad", "gap\nmm", "f_n\nHz", "peak F_c\nkN", "D\n-")

_RANGE_DIGITS = 3


@dataclass(frozen=True)
class Measured:
    """One design as a column: its heading, what it does, its run-down, its digits."""

    heading: str
    performance: Performance
    rundown: Rundown | None
    digits: int | None


def render_alternatives(alternatives: Sequence[Alternative]) -> RenderableType | None:
    """Return what was examined, the remark under each name; None if nothing was."""
    if not alternatives:
        return None
    measured = any(a.performance is not None for a in alternatives)
    headers = DESIGN_HEADERS if measured else ()
    rows = table(["candidate"], headers, ["verdict"])
    for alternative in alternatives:
        numbers = ("-",) * len(headers)
        if alternative.performance is not None:
            numbers = design_numbers(alternative.performance, None)
        rows.add_row(Group(*_lines(alternative)), *numbers, verdict(alternative.passes))
    return titled("Candidates", rows)


def render_design(name: str, performance: Performance, digits: int | None) -> Table:
    """Return one design as a table of one row."""
    row = table(["design"], DESIGN_HEADERS, [])
    row.add_row(Text(name), *design_numbers(performance, digits))
    return row


def render_quantities(columns: Sequence[Measured], bearings: tuple[str, str]) -> Table:
    """Return a table of one row per quantity and one column per design."""
    rows = table(["quantity"], [column.heading for column in columns], ["unit"])
    lines = [list(quantity_rows(column, bearings)) for column in columns]
    for same in zip(*lines, strict=True):
        label, unit, _ = same[0]
        rows.add_row(Text(label), *(text for _, _, text in same), Text(unit))
    return rows


def _lines(alternative: Alternative) -> Iterable[RenderableType]:
    yield Text(alternative.name)
    if alternative.remark:
        yield Padding(Text(alternative.remark), (0, 0, 0, 2))


def design_numbers(performance: Performance, digits: int | None) -> tuple[str, ...]:
    """Return the numbers of a design under `DESIGN_HEADERS`."""
    return (
        quantity(performance.torsional_stiffness, "N*m/rad"),
        quantity(performance.key_gap, "m"),
        quantity(performance.natural_frequency, "Hz"),
        quantity(performance.peak_transmission_force, "N"),
        damage(performance.damage, digits),
    )


def quantity_rows(
    column: Measured, bearings: tuple[str, str]
) -> Iterable[tuple[str, str, str]]:
    """Yield label, unit and number of each quantity of a design."""
    design, digits = column.performance, column.digits
    yield (
        "dynamic torsional stiffness C_Tdyn",
        "MN*m/rad",
        quantity(design.torsional_stiffness, "N*m/rad"),
    )
    yield "total key gap", "mm", quantity(design.key_gap, "m")
    yield "natural frequency f_n", "Hz", quantity(design.natural_frequency, "Hz")
    spread = design.spread if digits is not None else None
    peak = quantity(design.peak_transmission_force, "N")
    yield "peak transmission force F_c", "kN", peak
    if spread is not None:
        reach = (quantity(end, "N") for end in spread.peak_transmission_force)
        yield "  over the crank angle", "kN", " to ".join(reach)
    for name, load in zip(bearings, design.peak_combined_load, strict=True):
        yield f"peak combined load, {name}", "kN", quantity(load, "N")
    for k, (name, one) in enumerate(zip(bearings, design.damages, strict=True)):
        yield f"damage D, {name}, mean", "-", damage(one, digits)
        if spread is not None:
            ends = (damage(end, _RANGE_DIGITS) for end in spread.damages[k])
            yield "  over crank angle and gravity", "-", " to ".join(ends)
    yield "damage, the paper's unit (D x 1e6)", "-", damage_e6(design.damage, digits)
    if column.rundown is not None:
        yield from _rundown(column.rundown)


def _rundown(rundown: Rundown) -> Iterable[tuple[str, str, str]]:
    rest = "no rest" if rundown.rest_time is None else significant(rundown.rest_time)
    speed = quantity(rundown.resonance_speed, "rad/s")
    yield "speed at the largest swing of F_c", "rpm", speed
    swing = quantity(rundown.resonance_swing, "N")
    yield "that swing, half peak to peak", "kN", swing
    yield "engine at rest after", "s", rest
    yield "turns of the generator shaft", "-", significant(rundown.revolutions)
    yield "generator speed at the end", "rpm", quantity(rundown.final_speed, "rad/s")
    below = significant(rundown.out_of_range_time)
    yield "time with viscosity ratio below ISO 281", "s", below

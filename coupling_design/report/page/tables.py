"""The rows of the report's tables, as the console words and rounds them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import groupby

from coupling_design.flow.outcome import DesignOutcome
from coupling_design.flow.speed_map import CouplingSpeeds
from coupling_design.machine.machine import Case
from coupling_design.machine.sourced_value import SourcedValue
from coupling_design.parts.criterion import Criterion
from coupling_design.report.console.assumptions import section_of, section_title
from coupling_design.report.console.maps import spread
from coupling_design.report.console.performances import (
    DESIGN_HEADERS,
    Measured,
    design_numbers,
    quantity_rows,
)
from coupling_design.report.words.damages import damage_e6
from coupling_design.report.words.names import words
from coupling_design.report.words.numbers import percent, significant
from coupling_design.report.words.units import display_unit, quantity, value_and_limit
from coupling_design.search.design_map import DesignMap
from coupling_design.search.optimum import Optimum
from coupling_design.steps.step_result import Alternative

_MAP_COLUMNS, _MAP_ROWS, _MAP_DIGITS = 7, 5, 3
_PLACES = 6  # digits of an input in SI, which is echoed and not a result


@dataclass(frozen=True)
class Table:
    """A table of text: headings, rows, and how many columns at the left are words.

    `verdicts` is the column of PASS and FAIL, None if there is none.
    """

    headings: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    words: int = 1
    verdicts: int | None = None


def criteria_table(criteria: Sequence[Criterion]) -> Table:
    """Return values against their limits."""
    rows = []
    for criterion in criteria:
        value, limit = value_and_limit(criterion)
        unit = display_unit(criterion.unit)
        margin = "-" if criterion.margin is None else percent(criterion.margin)
        verdict = criterion.verdict.upper()
        name, source = criterion.name, criterion.source
        rows.append((name, value, limit, margin, unit, verdict, source))
    headings = (
        "criterion",
        "value",
        "limit",
        "margin %",
        "unit",
        "verdict",
        "limit from",
    )
    return Table(headings, tuple(rows), verdicts=5)


def alternatives_table(alternatives: Sequence[Alternative]) -> Table:
    """Return what a step examined."""
    measured = any(a.performance is not None for a in alternatives)
    headers = _one_line(DESIGN_HEADERS) if measured else ()
    rows = []
    for each in alternatives:
        numbers = ("-",) * len(headers)
        if each.performance is not None:
            numbers = design_numbers(each.performance, None)
        rows.append((each.name, each.remark, *numbers, _verdict(each.passes)))
    headings = ("candidate", "remark", *headers, "verdict")
    return Table(headings, tuple(rows), words=2, verdicts=len(headings) - 1)


def optimum_table(optimum: Optimum) -> Table:
    """Return an optimum as a table of one row."""
    digits = None if optimum.conditioning is None else optimum.conditioning.digits
    name = f"{optimum.coupling_type}, {words(optimum.connection)}"
    row = (name, *design_numbers(optimum.performance, digits))
    return Table(("design", *_one_line(DESIGN_HEADERS)), (row,))


def compared_designs(outcome: DesignOutcome) -> Iterator[Measured]:
    """Yield the present design, and the chosen or the nearest one beside it."""
    baseline, chosen, nearest = outcome.baseline, outcome.chosen, outcome.nearest
    digits = baseline.digits
    if chosen is not None:
        yield Measured("present", baseline.performance, baseline.rundown, digits)
        own = chosen.digits
        yield Measured("chosen", chosen.performance, chosen.rundown, own)
        return
    run_down = None if nearest else baseline.rundown
    yield Measured("present", baseline.performance, run_down, digits)
    if nearest is not None:
        firm = nearest.conditioning
        own = digits if firm is None else firm.digits
        yield Measured("nearest", nearest.performance, None, own)


def comparison_table(outcome: DesignOutcome) -> Table:
    """Return the present design and the chosen or nearest one, quantity by quantity."""
    first, second = outcome.case.bearings
    lines = [
        list(quantity_rows(design, (first.name, second.name)))
        for design in compared_designs(outcome)
    ]
    rows = [
        (same[0][0], *(text for _, _, text in same), same[0][1])
        for same in zip(*lines, strict=True)
    ]
    roles = (design.heading for design in compared_designs(outcome))
    return Table(("quantity", *roles, "unit"), tuple(rows))


def map_table(map_: DesignMap) -> Table:
    """Return a map thinned to fit a page: damage and peak, a row for each gap."""
    columns = spread(len(map_.torsional_stiffness), _MAP_COLUMNS)
    rows = []
    for i in spread(len(map_.key_gap), _MAP_ROWS):
        gap = quantity(map_.key_gap[i], "m")
        damages = (damage_e6(map_.damage[i][j], _MAP_DIGITS) for j in columns)
        forces = (quantity(map_.peak_transmission_force[i][j], "N") for j in columns)
        rows += [("D x 1e6 [-]", gap, *damages), ("peak F_c [kN]", gap, *forces)]
    at = (f"{quantity(map_.torsional_stiffness[j], 'N*m/rad')}" for j in columns)
    return Table(("quantity at C_Tdyn [MN*m/rad]", "gap mm", *at), tuple(sorted(rows)))


def critical_speed_table(coupling: CouplingSpeeds) -> Table:
    """Return where orders meet natural frequencies, and how far off they lie."""
    rows = tuple(
        (
            words(critical.position),
            f"{critical.order:g}",
            f"{critical.mode}",
            significant(critical.natural_frequency),
            quantity(critical.speed, "rad/s"),
            percent(critical.separation_margin),
            _verdict(critical.passes),
        )
        for critical in coupling.critical_speeds
    )
    headings = (
        "working range",
        "order",
        "mode",
        "f_n Hz",
        "speed rpm",
        "margin %",
        "verdict",
    )
    return Table(headings, rows, verdicts=6)


def input_rows(case: Case) -> Iterator[tuple[str, tuple[tuple[str, ...], ...]]]:
    """Yield each section of the case file: key, as written, in SI, source, note."""
    for section, values in groupby(case.provenance, key=section_of):
        yield section_title(case, section), tuple(map(_input, values))


def _input(value: SourcedValue) -> tuple[str, ...]:
    key = value.path.rpartition(".")[2]
    si = value.value
    if not isinstance(si, str):
        si = f"{si:.{_PLACES}g} {value.unit}".strip()
    return key, value.text, si, value.source or "not stated", value.note


def _one_line(headers: Sequence[str]) -> tuple[str, ...]:
    """Return headers of two lines, quantity and unit, in one."""
    parted = (header.partition("\n") for header in headers)
    return tuple(f"{name} [{unit}]" for name, _, unit in parted)


def _verdict(passes: bool) -> str:
    return "PASS" if passes else "FAIL"

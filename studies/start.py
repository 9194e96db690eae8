"""What a run-down's start does to its results: settled, unsettled, fuel cut; chance.

The paper starts from even turning, by its silence; a set does not.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

from coupling_design.bearing.damage import PAPER_UNIT
from coupling_design.case.case import Case
from coupling_design.design.evaluation import Evaluator
from coupling_design.design.performance import Performance
from coupling_design.design.sensitivity import (
    Sensitivity,
    reduction_range,
    sensitivity,
)
from coupling_design.driveline.parameters import (
    FuelCutStart,
    QuasiSteadyStart,
    SettledStart,
    Start,
)
from coupling_design.report.numbers import significant
from studies.machine import (
    high_stiffness,
    present,
    present_point,
    required_stiffness,
)

TITLE = "The start of the run-down"
_ANGLES = 24
MOVED = (
    "What moved and why: the shafts no longer start turning evenly, which put the "
    "orders' own vibration into the line as a step and left its ringing in the peak; "
    "and damage is the mean over crank angle and gravity's direction, no longer that "
    "of angle 0."
)


@dataclass(frozen=True)
class Started:
    """One way to start, and what both couplings do from it over the crank angle."""

    name: str
    present: Performance
    stiff: Performance


@dataclass(frozen=True)
class StartStudy:
    """Every start, and what moves the answer."""

    starts: tuple[Started, ...]
    moved: tuple[Sensitivity, Sensitivity]


def examine(case: Case, n_angles: int = _ANGLES) -> StartStudy:
    """Return what each start does to the present and the high-stiffness coupling."""
    cycle = 4 * math.pi / float(case.shutdown.initial_speed)
    laws: dict[str, Start] = {
        "settled": SettledStart(),
        "even turning (before)": QuasiSteadyStart(),
        "fuel cut over one cycle": FuelCutStart(cycle),
        "fuel cut at once": FuelCutStart(0.0),
    }
    couplings = (
        (present(case), present_point(case)),
        (high_stiffness(case), (required_stiffness(case), 0.0)),
    )
    starts = []
    for name, law in laws.items():
        shutdown = replace(case.shutdown, start=law, crank_angles=n_angles)
        other = replace(case, shutdown=shutdown)
        built, stiff = (
            Evaluator(other, each.candidate).performance(*point)
            for each, point in couplings
        )
        starts.append(Started(name, built, stiff))
    first, second = (
        sensitivity(each, each.performance(*point)) for each, point in couplings
    )
    return StartStudy(tuple(starts), (first, second))


def fragment(found: StartStudy) -> str:
    """Return the part's Markdown: starts, what moved and why, what moves the answer."""
    return "\n\n".join(
        (
            MOVED,
            f"Over {_ANGLES} crank angles, least to most (mean); D in 1e-6:",
            _table(
                (
                    "start",
                    "present: peak F_c, kN",
                    "present: D",
                    "stiff: peak F_c, kN",
                    "stiff: D",
                ),
                map(_row, found.starts),
            ),
            "When one input moves, the others kept (judged as the program does):",
            _table(
                ("input", "by", "present: D, %", "stiff: D, %", "stiff: peak, %"),
                _moves(found),
            ),
            _reduction(found),
        )
    )


def _row(started: Started) -> tuple[str, ...]:
    cells = [started.name]
    for performance in (started.present, started.stiff):
        spread = performance.spread
        if spread is None:
            raise TypeError("a start is judged over crank angles")
        low, high = (significant(end / 1e3) for end in spread.peak_transmission_force)
        cells.append(f"{low} to {high} ({significant(spread.mean_peak / 1e3)})")
        low, high = (significant(end * PAPER_UNIT) for end in spread.damages[0])
        mean = significant(float(performance.damages[0]) * PAPER_UNIT)
        cells.append(f"{low} to {high} ({mean})")
    return tuple(cells)


def _moves(found: StartStudy) -> Iterator[tuple[str, ...]]:
    built, stiff = found.moved
    for name in built.names:
        low, high, *_ = built.reach(name)
        cells = [name, built.span(name), f"{100 * low:+.1f} to {100 * high:+.1f}"]
        if name in stiff.names:
            reach = [100 * each for each in stiff.reach(name)]
            cells += [f"{a:+.1f} to {b:+.1f}" for a, b in (reach[:2], reach[2:])]
        else:
            cells += ["has none", "has none"]
        yield tuple(cells)


def _reduction(found: StartStudy) -> str:
    built, stiff = found.moved
    low, high = (100 * end for end in reduction_range(built, stiff))
    nominal = 100 * (1 - stiff.damage / built.damage)
    return (
        f"The reduction of damage is {nominal:.1f} %, and lies between {low:.1f} and "
        f"{high:.1f} % when any of these moves for both couplings."
    )


def _table(headings: tuple[str, ...], rows: Iterator[tuple[str, ...]]) -> str:
    lines = [headings, tuple("---" for _ in headings), *rows]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)

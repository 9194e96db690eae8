"""What a run-down's start does to its results: settled, unsettled, fuel cut; chance.

The paper starts from even turning, by its silence; a set does not.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

from coupling_design.arithmetic import Scalar
from coupling_design.case import load_case
from coupling_design.line.parameters import (
    FuelCutStart,
    QuasiSteadyStart,
    SettledStart,
    Start,
)
from coupling_design.machine.machine import Case
from coupling_design.parts.bearing.damage import PAPER_UNIT
from coupling_design.report.words.numbers import significant
from coupling_design.wear.chance import Spread
from coupling_design.wear.evaluator import Evaluator
from coupling_design.wear.performance import Performance
from coupling_design.wear.sensitivity import (
    Sensitivity,
    reduction_range,
    sensitivity,
)
from studies.initial_speed import (
    INVENTED,
    SpeedReach,
    couplings,
    reaches,
    until_rest,
)

TITLE = "The start of the run-down"
SETTLED, EVENLY = "settled", "even turning (before)"
_ANGLES = 24
_SENTENCE = (
    "What moved and why: the shafts no longer start turning evenly, which put the "
    "orders' own vibration into the line as a step and left its ringing in the peak; "
    "and damage is the mean over crank angle and gravity's direction, peaks the "
    "largest, no longer those of angle 0. "
)


@dataclass(frozen=True)
class Started:
    """One way to start, and what both couplings do from it over the crank angle."""

    name: str
    present: Performance
    stiff: Performance


@dataclass(frozen=True)
class StartStudy:
    """Every start; what moves the answer; what the initial speed does to a set's D."""

    starts: tuple[Started, ...]
    moved: tuple[Sensitivity, Sensitivity]
    speeds: tuple[SpeedReach, ...]


def examine(case: Case, n_angles: int = _ANGLES) -> StartStudy:
    """Return what each start does to the present and the high-stiffness coupling."""
    cycle = 4 * math.pi / float(case.shutdown.initial_speed)
    laws: dict[str, Start] = {
        SETTLED: SettledStart(),
        EVENLY: QuasiSteadyStart(),
        "fuel cut over one cycle": FuelCutStart(cycle),
        "fuel cut at once": FuelCutStart(0.0),
    }
    starts = []
    for name, law in laws.items():
        shutdown = replace(case.shutdown, start=law, crank_angles=n_angles)
        other = replace(case, shutdown=shutdown)
        built, stiff = (
            Evaluator(other, each.candidate).performance(*point)
            for each, point in couplings(case)
        )
        starts.append(Started(name, built, stiff))
    first, second = (
        sensitivity(each, each.performance(*point))
        for each, point in couplings(until_rest(case))
    )
    sets = (case, load_case(INVENTED))
    speeds = tuple(reach for each in sets for reach in reaches(each))
    return StartStudy(tuple(starts), (first, second), speeds)


def fragment(found: StartStudy) -> str:
    """Return the part's Markdown: starts, what moved and why, what moves the answer."""
    return "\n\n".join(
        (
            f"Over {_ANGLES} crank angles, least to most (mean); D of bearing 1, 1e-6:",
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
            _two_starts(found),
            "When one input moves, the others kept, judged over crank angle and "
            "gravity; lowest to highest change in %. Run-downs are a quarter longer "
            "than the case's here, so that the faster ones come to rest too:",
            _table(
                (
                    "input",
                    "by",
                    "present: D",
                    "present: peak",
                    "stiff: D",
                    "stiff: peak",
                    "reduction of D",
                ),
                _moves(found),
            ),
            _reduction(found),
            "What the initial speed does to D within 3 % of itself, in 25 steps: from "
            "one crank angle and direction of gravity, and judged over them. A "
            "run-down that begins a little faster meets the resonance with gravity "
            "elsewhere: what one run-down shows of the speed is chance.",
            _table(
                ("set", "coupling", "one run-down, %", "judged, %"),
                map(_reach, found.speeds),
            ),
        )
    )


def _two_starts(found: StartStudy) -> str:
    by_name = {started.name: started.stiff for started in found.starts}
    ends = {name: _ends(by_name[name]) for name in (SETTLED, EVENLY)}
    return (
        f"The stiff coupling's peak is {ends[SETTLED]} from the settled start, the "
        f"same at every crank angle, and {ends[EVENLY]} from even turning: what swung "
        "with the crank angle was the start's own ringing. Its D still moves with the "
        "direction of gravity, whichever the start."
    )


def _ends(performance: Performance) -> str:
    spread = _spread(performance)
    low, high = (significant(end / 1e3) for end in spread.peak_transmission_force)
    mean = significant(spread.mean_peak / 1e3)
    return f"{low} kN" if low == high else f"{low} to {high} kN (mean {mean} kN)"


def moved(case: Case) -> str:
    """Return what the settled start and the mean over chance moved, and why."""
    evenly = replace(case.shutdown, start=QuasiSteadyStart(), crank_angles=1)
    other = replace(case, shutdown=evenly)
    told = []
    for name, (each, point) in zip(("present", "stiff"), couplings(case), strict=True):
        before = Evaluator(other, each.candidate).performance(*point)
        now = each.performance(*point)
        told += [
            f"D {name} {_pair(before.damage, now.damage, PAPER_UNIT)}e-6",
            "peak F_c "
            + _pair(before.peak_transmission_force, now.peak_transmission_force, 1e-3)
            + " kN",
        ]
    return f"{_SENTENCE}From the old start to this one: {', '.join(told)}."


def _pair(before: Scalar, now: Scalar, unit: float) -> str:
    return " to ".join(significant(float(each) * unit) for each in (before, now))


def _row(started: Started) -> tuple[str, ...]:
    cells = [started.name]
    for performance in (started.present, started.stiff):
        spread = _spread(performance)
        low, high = (significant(end / 1e3) for end in spread.peak_transmission_force)
        cells.append(f"{low} to {high} ({significant(spread.mean_peak / 1e3)})")
        low, high = (significant(end * PAPER_UNIT) for end in spread.damages[0])
        mean = significant(float(performance.damages[0]) * PAPER_UNIT)
        cells.append(f"{low} to {high} ({mean})")
    return tuple(cells)


def _spread(performance: Performance) -> Spread:
    if performance.spread is None:
        raise TypeError("a start is judged over crank angles")
    return performance.spread


def _moves(found: StartStudy) -> Iterator[tuple[str, ...]]:
    built, stiff = found.moved
    for name in built.names:
        cells = [name, built.span(name)]
        for each in (built, stiff):
            if name in each.names:
                reach = [100 * end for end in each.reach(name)]
                cells += [f"{a:+.1f} to {b:+.1f}" for a, b in (reach[:2], reach[2:])]
            else:
                cells += ["has none", "has none"]
        low, high = (100 * end for end in reduction_range(*_only(name, built, stiff)))
        yield (*cells, f"{low:.1f} to {high:.1f}")


def _only(name: str, *found: Sensitivity) -> tuple[Sensitivity, Sensitivity]:
    """Return the same as if one input alone moved."""
    built, stiff = (
        replace(each, moves=tuple(m for m in each.moves if m.name == name))
        for each in found
    )
    return built, stiff


def _reach(reach: SpeedReach) -> tuple[str, ...]:
    ends = (reach.one_run_down, reach.judged)
    return (
        reach.case,
        reach.coupling,
        *(f"{100 * low:+.1f} to {100 * high:+.1f}" for low, high in ends),
    )


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

"""Where the paper contradicts itself: both readings in numbers.

The load limit with and without the lever of the overhang; damage below the load at
which it says there is none; its smoothing factor without a unit; the unit of its D.
"""

from __future__ import annotations

import dataclasses
import functools
from collections.abc import Mapping, Sequence

from matplotlib.figure import Figure
from rich.table import Table

from coupling_design.line.parameters import KeyedConnection
from coupling_design.machine.machine import Case
from coupling_design.parts.bearing.contact_stress import (
    minimum_load,
    permissible_transmission_force,
    strict_transmission_force,
)
from coupling_design.parts.bearing.damage import PAPER_UNIT, miner_damage
from coupling_design.report.words.numbers import significant
from coupling_design.signals.history import History
from studies.command import Study, leave, table
from studies.judgement import Contrast
from studies.lubrication import bearing_loads
from studies.machine import (
    high_stiffness_history,
    high_stiffness_performance,
    present_history,
    present_performance,
)
from studies.smoothing import draw, keys, smoothing_unit

# With its high-stiffness coupling [N].
PAPER_PEAK = 33926.07


@dataclasses.dataclass(frozen=True)
class Honesty:
    """The contrasts, and the present key under each reading of sigma, by its name."""

    contrasts: tuple[Contrast, ...]
    keys: Mapping[str, KeyedConnection]


@functools.cache
def examine(case: Case) -> Honesty:
    """Return every contradiction in numbers."""
    return Honesty(
        contrasts=(
            *load_limit(case),
            *cut_off(case),
            *smoothing_unit(case),
            *damage_unit(case),
        ),
        keys=keys(case),
    )


def load_limit(case: Case) -> list[Contrast]:
    """Return the limit on Fc without and with the lever, and who keeps it."""
    loose = float(permissible_transmission_force(case.shaft, case.bearings))
    strict = float(strict_transmission_force(case.shaft, case.bearings))
    stiff = high_stiffness_performance(case)
    peak, load = (
        float(stiff.peak_transmission_force),
        float(stiff.peak_combined_load[0]),
    )
    f_min = float(minimum_load(case.bearings[0]))
    ours = f"{case.reading.value.replace('_', ' ')} is the reading of the case"
    readings = ("Fc itself against F_min - G", "load at bearing 1 against F_min")
    return [
        Contrast(
            "Which Fc does the load limit permit?",
            readings[0],
            loose,
            readings[1],
            strict,
            "N",
            ours,
            f"The paper's own final peak of {PAPER_PEAK:.2f} N is "
            f"{_side(PAPER_PEAK, loose)} the first limit and "
            f"{_side(PAPER_PEAK, strict)} the second.",
        ),
        Contrast(
            "What of its limit does the high-stiffness coupling take?",
            readings[0],
            100 * peak / loose,
            readings[1],
            100 * load / f_min,
            "%",
            ours,
            f"Fc peaks at {peak:.0f} N, the load of bearing 1 at {load:.0f} N, not at "
            "the same time: it depends on the crank angle how weight and force add up.",
        ),
    ]


def cut_off(case: Case) -> list[Contrast]:
    """Return damage with and without that of loads below F_min, both couplings."""
    found = []
    for name, history in (
        ("the present coupling", present_history(case)),
        ("the high-stiffness coupling", high_stiffness_history(case)),
    ):
        everything, above = (
            PAPER_UNIT * damage(case, history, small) for small in (True, False)
        )
        found.append(
            Contrast(
                f"What damage does a run-down with {name} do?",
                "every load counts",
                everything,
                "none below F_min",
                above,
                "1e-6",
                "every load counts",
                f"{100 * (1 - above / everything):.2f} % of it is done below F_min. "
                "The paper neglects such loads, yet gives its final coupling, which it "
                "holds below the limit throughout, a D of 0.0023.",
            )
        )
    return found


def damage(case: Case, history: History, small_loads: bool) -> float:
    """Return bearing 1's Miner sum over a history."""
    return miner_damage(
        bearing_loads(case, history)[0],
        history.generator_speed,
        case.shutdown.time_step,
        case.bearings[0],
        case.lubrication,
        case.reliability,
        small_loads_do_damage=small_loads,
    )


def damage_unit(case: Case) -> list[Contrast]:
    """Return D as a Miner sum and as the paper counts it, as run-downs of a life."""
    D = present_performance(case).damage
    return [
        Contrast(
            "How many run-downs make a bearing's life?",
            "D is Miner's sum times 1e6",
            1 / D,
            "D is Miner's sum",
            1 / (PAPER_UNIT * D),
            "run-downs",
            "Miner's sum, printed beside 1e6 times it",
            f"Life in millions of revolutions against revolutions in ones gives "
            f"{PAPER_UNIT * D:.5f}, the size the paper prints; the sum itself is "
            f"{D:.4g}.",
        )
    ]


def _side(value: float, limit: float) -> str:
    return "below" if value <= limit else "above"


def tables(found: Honesty) -> Sequence[Table]:
    """Return every contrast in a table."""
    made = table("Two readings of the paper", "question", "reading", "value", "unit")
    for row in found.contrasts:
        made.add_row(
            row.question, row.first_reading, significant(row.first, 5), row.unit
        )
        made.add_row("", row.second_reading, significant(row.second, 5), row.unit)
    return [made]


def figures(found: Honesty) -> Mapping[str, Figure]:
    """Return the contact over the gap for each reading of sigma."""
    return {"smoothing": draw(found.keys)}


def findings(found: Honesty) -> Sequence[str]:
    """Return what follows from each contrast."""
    return [row.remark for row in found.contrasts]


STUDY = Study("Two readings of the paper", examine, tables, figures, findings)

if __name__ == "__main__":
    leave(STUDY)

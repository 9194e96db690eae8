"""Every result that the paper prints, beside ours: what the shipped case is held to.

Values hold within a tenth of the paper's, the gap's influence within three percentage
points, signs exactly. The run-down's 0.66 % against the test bench cannot be compared:
the measurement is lost.
"""

from __future__ import annotations

import functools
from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.figure import Figure
from rich.table import Table

from coupling_design.machine.machine import Case
from coupling_design.parts.bearing.contact_stress import (
    minimum_load,
    permissible_transmission_force,
)
from coupling_design.parts.bearing.damage import PAPER_UNIT
from coupling_design.report.words.numbers import significant
from coupling_design.steps.limits import high_frequency_constraint
from coupling_design.wear.performance import Performance
from studies import gap, resonance, stiffness
from studies.command import Study, leave, table
from studies.contact import why_not_half
from studies.forces import change
from studies.judgement import direction, within, within_share
from studies.machine import (
    high_stiffness_performance,
    least_elastic_peak,
    present_performance,
    required_stiffness,
)
from tests.verification.comparison import Comparison

RPM = resonance.RPM
SHARE_OF_RANGE = 10.0  # that a linear D may be off its line [%]


@functools.cache
def comparisons(case: Case) -> tuple[Comparison, ...]:
    """Return all the paper's results beside ours."""
    groups = (set_up, of_the_present, of_stiffness, of_the_gap, of_the_method)
    return tuple(row for group in groups for row in group(case))


def set_up(case: Case) -> list[Comparison]:
    """Return what follows from the inputs alone."""
    shaft, bearings = case.shaft, case.bearings
    exact = (
        ("duration of the run-down", "", 12.0, case.shutdown.duration, "s", 0.0),
        ("steps", "", 120e3, float(case.shutdown.n_steps), "-", 0.0),
        ("F_min", "eq. (7)", 48838.56, minimum_load(bearings[0]), "N", 0.005),
        (
            "permissible peak of Fc",
            "step 3",
            36120.18,
            permissible_transmission_force(shaft, bearings),
            "N",
            0.005,
        ),
        (
            "least natural frequency",
            "step 4",
            188.56,
            high_frequency_constraint(case).limit,
            "Hz",
            0.005,
        ),
        (
            "stiffness that this takes, two masses",
            "step 4, with its inertias",
            192.75,
            required_stiffness(case) / 1e6,
            "MN m/rad",
            0.01,
        ),
    )
    return [
        within(name, where or "set-up", published, float(ours), unit, tolerance)
        for name, where, published, ours, unit, tolerance in exact
    ]


def of_the_present(case: Case) -> list[Comparison]:
    """Return damage, resonance and loads with the present coupling."""
    performance = present_performance(case)
    speed = resonance.STUDY.examine(case).force_swing.speed * RPM
    load, limit = performance.peak_combined_load[1], minimum_load(case.bearings[1])
    return [
        within("speed at resonance", "100 to 140 rpm", 120.0, speed, "rpm", 20.0),
        within_share(
            "D, present coupling, gap as built",
            "0.0023 / (1 - 0.4319)",
            0.0023 / (1 - 0.4319),
            PAPER_UNIT * performance.damage,
            "1e-6",
        ),
        direction(
            "largest load of bearing 2 against F_min",
            "fig. 7",
            -1,
            float(load - limit),
            f"{load:.0f} N of {limit:.0f} N",
        ),
    ]


def of_stiffness(case: Case) -> list[Comparison]:
    """Return the influence of stiffness, and step 3 for any elastic stiffness."""
    found = stiffness.examine(case)
    half = found.damage_change(stiffness.HALF)
    stiffer = found.damage_change(stiffness.SLIGHTLY_STIFFER)
    permissible = float(permissible_transmission_force(case.shaft, case.bearings))
    at, least = least_elastic_peak(case)
    return [
        within_share(
            "change of D at half the stiffness",
            "fig. 9",
            90.21,
            half,
            "%",
            why_not_half(case),
        ),
        direction(
            f"change of D at {stiffness.SLIGHTLY_STIFFER:g} times the stiffness",
            "fig. 9, slightly above 1",
            -1,
            stiffer,
            f"{stiffer:+.2f} %",
        ),
        direction(
            "least peak of Fc with any elastic stiffness against the permissible",
            "step 3 fails",
            +1,
            least - permissible,
            f"{least:.0f} N at {at / 1e6:.3g} MN m/rad, tight fit or gap as built, "
            f"of {permissible:.0f} N",
        ),
    ]


def of_the_gap(case: Case) -> list[Comparison]:
    """Return the influence of the gap."""
    found = gap.examine(case)
    return [
        within(
            "change of D from a tight fit to a gap of 0.3 mm",
            "fig. 10",
            19.68,
            found.damage_change,
            "%",
            3.0,
        ),
        within(
            "D over the gap: largest distance from a straight line, of D's range",
            "fig. 10, linear",
            0.0,
            found.deviation,
            "%",
            SHARE_OF_RANGE,
        ),
        direction(
            "change of D as the gap opens, its smallest step",
            "fig. 10",
            +1,
            float(np.diff(found.damages).min()),
            f"{len(found.gaps)} gaps from 0 to {found.gaps[-1] * 1e3:g} mm",
        ),
    ]


def of_the_method(case: Case) -> list[Comparison]:
    """Return what the high-stiffness coupling in a tight fit does."""
    stiff, before = high_stiffness_performance(case), present_performance(case)
    peak = float(stiff.peak_transmission_force)
    damage = PAPER_UNIT * stiff.damage
    fall = change(stiff.damage, before.damage)
    where = "fig. 13, high-stiffness coupling, tight fit"
    return [
        within_share("peak of Fc", where, 33926.07, peak, "N"),
        direction(
            "its peak against the permissible",
            where,
            -1,
            peak - float(permissible_transmission_force(case.shaft, case.bearings)),
            f"{peak:.0f} N",
        ),
        within_share("D", where, 0.0023, damage, "1e-6", why_less(stiff)),
        within_share("change of D by it", where, -43.19, fall, "%"),
    ]


def why_less(stiff: Performance) -> str:
    """Return what the high-stiffness coupling's D does by chance."""
    if stiff.spread is None:
        raise TypeError("what it does by chance takes more than one crank angle")
    low, high = (PAPER_UNIT * damage for damage in stiff.spread.damages[0])
    return (
        "The paper prints two digits and one run-down, without the crank angle and the "
        f"direction of gravity it starts from. By these alone D lies between "
        f"{significant(low)} and {significant(high)}; ours is the mean."
    )


def tables(found: Sequence[Comparison]) -> Sequence[Table]:
    """Return all comparisons in a table."""
    made = table("The paper's results", "what", "paper", "ours", "unit", "agrees")
    for row in found:
        made.add_row(
            row.quantity,
            significant(row.published, 5),
            significant(row.ours, 5),
            row.unit,
            "yes" if row.agrees else "NO",
        )
    return [made]


def findings(found: Sequence[Comparison]) -> Sequence[str]:
    """Return how many agree, and a sentence on each that does not."""
    failed = [row for row in found if not row.agrees]
    return (
        f"{len(found) - len(failed)} of {len(found)} agree.",
        *(f"{row.quantity}: {row.remark}" for row in failed),
    )


def no_figures(found: Sequence[Comparison]) -> Mapping[str, Figure]:
    """Return nothing: every figure belongs to the study that its row is taken from."""
    return {}


STUDY = Study("The paper's results", comparisons, tables, no_figures, findings)

if __name__ == "__main__":
    leave(STUDY)

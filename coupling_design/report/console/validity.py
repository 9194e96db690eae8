"""How far a report may be relied on."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from rich.panel import Panel

from coupling_design.checks.fatigue_limits import FatigueLimits
from coupling_design.flow.outcome import DesignOutcome
from coupling_design.parts.criterion import Verdict
from coupling_design.report.console.blocks import bullets, panel
from coupling_design.report.words.numbers import significant
from coupling_design.report.words.units import quantity
from coupling_design.wear.signals import Rundown

_ALWAYS = (
    "Damage is the Miner sum of one run-down as described by the case: multiply by the "
    "number of stops. Starts, load steps, misfire, short circuit and faulty "
    "synchronisation are not in it.",
    "Three inertias, one coupling, one connection; the gap is smoothed by tanh. No "
    "misalignment, unbalance, bending or gas torque of a fired engine.",
    "Life after ISO 281:2007 with a_ISO for the load of each moment; bearing loads by "
    "statics of the overhung shaft, a rigid lever that turns bearing 2's load over.",
    "The result is as good as the case file. It replaces neither the coupling maker's "
    "approval nor a torsional vibration calculation of the classification society.",
)


def render_validity(outcome: DesignOutcome) -> Panel:
    """Return the limits of validity in a panel."""
    limits = limits_of_validity(outcome)
    return panel("Limits of validity", [bullets("Read with this", limits)])


def limits_of_validity(outcome: DesignOutcome) -> tuple[str, ...]:
    """Return what a result does not cover, what is so in this run first."""
    own = list(_of_rundown("Present", outcome.baseline.rundown))
    if outcome.chosen is not None:
        own += _of_rundown("Chosen", outcome.chosen.rundown)
    own += outcome.remarks
    limits = _two_limits(outcome.fatigue_limits)
    return (*own, *_not_checked(outcome), *limits, *_ALWAYS)


def _two_limits(bearings: Iterable[FatigueLimits]) -> Iterable[str]:
    """Yield which of a bearing's two fatigue limits decides, and why they differ.

    Once for bearings that are alike.
    """
    alike: dict[FatigueLimits, list[str]] = {}
    for each in bearings:
        alike.setdefault(replace(each, bearing=""), []).append(each.bearing)
    for limits, names in alike.items():
        F_min, C_u = (quantity(each, "N") for each in (limits.minimum_load, limits.C_u))
        told = (
            f"{' and '.join(names)}: F_min {F_min} kN, from S_min and K1, and C_u "
            f"{C_u} kN, from C_0 (ISO 281), are both fatigue limits of one bearing. "
            "F_min decides, by the method; C_u stands in the life. K1 takes stress to "
            f"grow with the load's {limits.law}."
        )
        if limits.is_a_ball_by_the_line_law:
            told += (
                " It has balls, whose stress goes with the cube root: write K1 in "
                "MPa/N^(1/3), which is S_min / F_min^(1/3)."
            )
        yield told


def _not_checked(outcome: DesignOutcome) -> Iterable[str]:
    """Yield by name what the chosen design could not be held against."""
    criteria = outcome.chosen.criteria if outcome.chosen else ()
    names = [c.name for c in criteria if c.verdict is Verdict.NOT_CHECKED]
    if names:
        yield f"Not checked, for want of a limit or a load: {'; '.join(names)}."


def _of_rundown(name: str, rundown: Rundown) -> Iterable[str]:
    if rundown.out_of_range_time > 0:
        seconds = significant(rundown.out_of_range_time, 3)
        yield (
            f"{name} coupling: for {seconds} s the viscosity ratio is below the range "
            "of ISO 281 (0.1) and taken as 0.1."
        )

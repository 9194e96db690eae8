"""What is chance in a run-down, and what is not known well, in words."""

from __future__ import annotations

import math

from coupling_design.flow.outcome import ChosenDesign
from coupling_design.machine.machine import Case
from coupling_design.report.words.units import quantity
from coupling_design.wear.performance import Performance
from coupling_design.wear.sensitivity import Sensitivity

CHAOTIC = (
    "Chaotic: a start moved by 1e-12 rad moves the damage by more than 1e-3 of it. The "
    "digits beyond are no computer's to tell."
)
_UNSETTLED = (
    " Before it the key rattles without a period at the initial speed: the start is "
    "that after 200 periods, and stands for no other."
)


def describe_chances(performance: Performance) -> str:
    """Return over what a performance is judged."""
    spread = performance.spread
    if spread is None:
        return "one crank angle"
    if spread.crank_angles == 1:
        return (
            f"the crank angle of the case alone.{'' if spread.repeats else _UNSETTLED}"
        )
    return (
        f"{spread.crank_angles} crank angles at the start, each with another direction "
        "of gravity: the largest peak, the mean damage."
        f"{'' if spread.repeats else _UNSETTLED}"
    )


def describe_moves(sensitivity: Sensitivity) -> str:
    """Return what damage and peak do when inputs move within what is known of them."""
    told = []
    for name in sensitivity.names:
        low, high, lowest, highest = sensitivity.reach(name)
        told.append(
            f"{name} {sensitivity.span(name)}: D {_reach(low, high)}, peak "
            f"{_reach(lowest, highest)}"
        )
    return "; ".join(told)


def describe_at_once(case: Case, chosen: ChosenDesign) -> str | None:
    """Return the bound of the peak if the fuel's torque goes at once, None if none."""
    bound = chosen.fuel_cut_at_once
    if bound is None or bound.spread is None:
        return None
    largest = quantity(bound.peak_transmission_force, "N")
    mean = quantity(bound.spread.mean_peak, "N")
    speed = case.shutdown.initial_speed * 30 / math.pi
    return (
        f"Bound: were the fuel's mean torque at {speed:.4g} rpm taken away at once, "
        f"F_c would reach {mean} kN on average over the crank angle, {largest} kN at "
        "most. A governor takes it away over a working cycle or more."
    )


def _reach(low: float, high: float) -> str:
    return f"{100 * low:+.1f} to {100 * high:+.1f} %"

"""How a run-down ends whose time is up before the set is at rest."""

from __future__ import annotations

import math
from collections.abc import Sequence
from enum import IntEnum

from coupling_design.case.case import Case
from coupling_design.design.performance import Performance
from coupling_design.driveline.resonance import orders_above_resonance

_RPM = math.pi / 30


class Ending(IntEnum):
    """Where a run-down stops; the larger, the less of it there was."""

    AT_REST = 0
    BEFORE_REST = 1
    ABOVE_RESONANCE = 2


def final_speed(performance: Performance) -> float:
    """Return the speed of what turns fastest at the end [rad/s], 0 if not known."""
    return performance.spread.final_speed if performance.spread else 0.0


def ending(case: Case, performance: Performance) -> Ending:
    """Return how a run-down of a case ends.

    At rest is what dry friction, smoothed over the transition speed, tells from motion.
    """
    driveline, speed = case.driveline, final_speed(performance)
    resistances = (driveline.engine_resistance, driveline.generator_resistance)
    if speed <= max(float(each.transition_speed) for each in resistances):
        return Ending.AT_REST
    if _not_passed(case, performance):
        return Ending.ABOVE_RESONANCE
    return Ending.BEFORE_REST


def describe_ending(case: Case, performance: Performance) -> str | None:
    """Return in a sentence how a run-down ends, None where it comes to rest."""
    rpm = f"up to {final_speed(performance) / _RPM:.3g} rpm"
    match ending(case, performance):
        case Ending.AT_REST:
            return None
        case Ending.BEFORE_REST:
            return (
                f"The run-down ends at {rpm}, before rest: what follows is not in the "
                "damage."
            )
    resonances = " and ".join(
        f"order {order:g} ({speed / _RPM:.3g} rpm)"
        for order, speed in _not_passed(case, performance)
    )
    return (
        f"The run-down ends at {rpm}, above the resonance with {resonances}: that "
        "passage is neither in the damage nor in the peak. Take a longer "
        "shutdown.duration."
    )


def describe_endings(
    endings: Sequence[float], speeds: Sequence[float]
) -> tuple[str, ...]:
    """Return in sentences how many of many run-downs do not come to rest.

    Of each its `Ending` and its final speed [rad/s].
    """
    told = []
    for grade, how, so in (
        (Ending.BEFORE_REST, "before rest", "what follows is not in the damage."),
        (
            Ending.ABOVE_RESONANCE,
            "above a resonance",
            "that passage is neither in the damage nor in the peak. Take a longer "
            "shutdown.duration.",
        ),
    ):
        ends = [v for v, each in zip(speeds, endings, strict=True) if each == grade]
        if ends:
            told.append(
                f"{len(ends)} of {len(endings)} points: the run-down ends {how}, at up "
                f"to {max(ends) / _RPM:.3g} rpm; {so}"
            )
    return tuple(told)


def ending_warnings(case: Case, *performances: Performance) -> tuple[str, ...]:
    """Return what must be said at the top of a result: run-downs that end too soon."""
    told = [
        describe_ending(case, each)
        for each in performances
        if ending(case, each) is Ending.ABOVE_RESONANCE
    ]
    return tuple(dict.fromkeys(sentence for sentence in told if sentence))


def _not_passed(case: Case, performance: Performance) -> list[tuple[float, float]]:
    return orders_above_resonance(
        case.driveline.excitation,
        2 * math.pi * float(performance.natural_frequency),
        final_speed(performance),
    )

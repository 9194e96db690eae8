"""How many digits of a damage stand when its start and its time step are moved."""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

from coupling_design.wear.digits import standing_digits
from coupling_design.wear.evaluator import Evaluator
from coupling_design.wear.performance import Performance

_START_OFFSET = 1e-12  # rad, far below anything that could be measured
# A nudge that small which moves the damage by more than this leaves it to chance.
_CHAOTIC = 1e-3


@dataclass(frozen=True)
class Conditioning:
    """How firmly a damage stands.

    Attributes
    ----------
    damage_change_by_start : relative change when the start is moved by 1e-12 rad
    damage_change_by_step : relative change when the time step is halved
    peak_change_by_step : relative change of the peak force when it is halved
    digits : significant digits that both leave standing, 1 to 6
    """

    damage_change_by_start: float
    damage_change_by_step: float
    peak_change_by_step: float
    digits: int


def conditioning(evaluator: Evaluator, performance: Performance) -> Conditioning:
    """Return how far damage and peak move; three rollouts, one of twice the steps.

    They run at the same time, from the first crank angle: it stands for the others.
    Rattling can be chaotic: then a start moved by 1e-12 rad moves the damage, and no
    computer's digits beyond that mean anything.
    """
    point = performance.torsional_stiffness, performance.key_gap
    one = evaluator.scan
    with ThreadPoolExecutor(1) as other:
        refined = other.submit(evaluator.refined.scan.performance, *point)
        plain = one.performance(*point)
        moved = one.performance(*point, start_offset=_START_OFFSET)
        halved = refined.result()
    by_start = moved.damage / plain.damage - 1
    by_step = halved.damage / plain.damage - 1
    return Conditioning(
        damage_change_by_start=by_start,
        damage_change_by_step=by_step,
        peak_change_by_step=halved.peak_transmission_force
        / plain.peak_transmission_force
        - 1,
        digits=standing_digits(max(abs(by_start), abs(by_step))),
    )


def chaotic(evaluator: Evaluator, performance: Performance) -> bool:
    """Return whether a start moved by 1e-12 rad moves the damage by more than 1e-3."""
    point = performance.torsional_stiffness, performance.key_gap
    return any(are_chaotic(evaluator, [point]))


def are_chaotic(
    evaluator: Evaluator, points: Sequence[tuple[float, float]]
) -> tuple[bool, ...]:
    """Return the same of many points at once."""
    pairs = zip(
        evaluator.scan.performances(points),
        evaluator.scan.performances(points, _START_OFFSET),
        strict=True,
    )
    return tuple(abs(b.damage / a.damage - 1) > _CHAOTIC for a, b in pairs)

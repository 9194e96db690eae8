"""How many digits of a damage stand when its start and its time step are moved."""

from __future__ import annotations

import math
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor

from coupling_design.design.evaluation import Evaluator
from coupling_design.design.results import Conditioning, Performance

_START_OFFSET = 1e-12  # rad, far below anything that could be measured
# A nudge that small which moves the damage by more than this leaves it to chance.
_CHAOTIC = 1e-3
_MOST_DIGITS = 6


def conditioning(evaluator: Evaluator, performance: Performance) -> Conditioning:
    """Return how far damage and peak move; two rollouts, one of twice the steps.

    They run at the same time. Rattling can be chaotic: then a start moved by 1e-12 rad
    moves the damage, and no computer's digits beyond that mean anything.
    """
    point = performance.torsional_stiffness, performance.key_gap
    with ThreadPoolExecutor(1) as other:
        refined = other.submit(evaluator.refined.performance, *point)
        moved = evaluator.performance(*point, start_offset=_START_OFFSET)
        halved = refined.result()
    by_start = moved.damage / performance.damage - 1
    by_step = halved.damage / performance.damage - 1
    return Conditioning(
        damage_change_by_start=by_start,
        damage_change_by_step=by_step,
        peak_change_by_step=halved.peak_transmission_force
        / performance.peak_transmission_force
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
        evaluator.performances(points),
        evaluator.performances(points, _START_OFFSET),
        strict=True,
    )
    return tuple(abs(b.damage / a.damage - 1) > _CHAOTIC for a, b in pairs)


def standing_digits(relative_change: float) -> int:
    """Return how many significant digits a relative change leaves, 1 to 6.

    A change of 5e-4 leaves 3: the third digit moves by one half at the most.
    """
    if relative_change <= 0.0:
        return _MOST_DIGITS
    digits = math.floor(-math.log10(2 * relative_change) + 1e-9)
    return min(max(digits, 1), _MOST_DIGITS)

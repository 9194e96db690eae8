"""The stiffness that limits on the natural frequency leave, known without a rollout."""

from __future__ import annotations

import math
from collections.abc import Sequence

from coupling_design.search.program import BACK_OFF, Constraint
from coupling_design.wear.evaluator import Evaluator

_BISECTIONS = 60


def reachable_stiffness(
    evaluator: Evaluator,
    constraints: Sequence[Constraint],
    stiffness: tuple[float, float],
) -> tuple[float, float] | None:
    """Return the part of a stiffness range [N m/rad] that the constraints leave.

    Only constraints that need no rollout count. The natural frequency rises with
    stiffness, so each leaves one end of the range; None if they leave nothing.
    """
    low, high = stiffness
    for constraint in constraints:
        if constraint.needs_rollout:
            continue
        keeps_low = _holds(evaluator, constraint, low)
        keeps_high = _holds(evaluator, constraint, high)
        if not (keeps_low or keeps_high):
            return None
        if not keeps_high:
            high = _border(evaluator, constraint, low, high)
        if not keeps_low:
            low = _border(evaluator, constraint, high, low)
    return low, high


def _holds(evaluator: Evaluator, constraint: Constraint, stiffness: float) -> bool:
    return float(constraint.excess(evaluator.outline(stiffness))) <= -BACK_OFF


def _border(
    evaluator: Evaluator, constraint: Constraint, inside: float, outside: float
) -> float:
    """Return the stiffness nearest to `outside` at which the constraint still holds."""
    for _ in range(_BISECTIONS):
        middle = math.sqrt(inside * outside)
        if _holds(evaluator, constraint, middle):
            inside = middle
        else:
            outside = middle
    return inside

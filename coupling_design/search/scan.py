"""Looking at the whole allowed range before an optimiser sees it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from coupling_design.search.program import DesignProblem, DesignSpace
from coupling_design.wear.performance import Performance


def grid(
    space: DesignSpace, n_stiffness: int, n_gaps: int
) -> tuple[tuple[float, float], ...]:
    """Return the points of a grid, stiffness spaced by ratio and gap evenly.

    The bounds are on the grid; a fixed gap gives one row, a fixed stiffness one column.
    """
    low, high = space.stiffness
    stiffnesses = np.geomspace(low, high, n_stiffness if high > low else 1)
    # geomspace may leave the upper bound by a rounding.
    stiffnesses[-1] = high
    gaps = np.linspace(*space.gap, n_gaps if space.gap_is_free else 1)
    return tuple((float(k), float(g)) for g in gaps for k in stiffnesses)


def best_first(
    problem: DesignProblem, performances: Sequence[Performance]
) -> list[Performance]:
    """Return the performances, feasible before infeasible, best objective first.

    Infeasible ones are ordered by their largest violation.
    """

    def rank(performance: Performance) -> tuple[bool, float]:
        if problem.is_feasible(performance):
            return False, float(problem.value(performance))
        return True, problem.violation(performance)

    return sorted(performances, key=rank)


def local_minima(
    problem: DesignProblem, performances: Sequence[Performance]
) -> list[Performance]:
    """Return the points of a one-row scan that are better than both neighbours."""
    values = [
        float(problem.value(p)) + 1e3 * max(problem.violation(p), 0.0)
        for p in performances
    ]
    padded = [float("inf"), *values, float("inf")]
    return [
        performance
        for i, performance in enumerate(performances)
        if padded[i] > padded[i + 1] <= padded[i + 2]
    ]

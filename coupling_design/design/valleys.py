"""The smallest load of a candidate: a search without derivatives, valley by valley."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from coupling_design.design.activity import active_constraints
from coupling_design.design.conditioning import conditioning
from coupling_design.design.problem import DesignProblem
from coupling_design.design.results import Optimum, Performance
from coupling_design.design.scan import best_first, local_minima

_ITERATIONS = 15
_RESOLUTION = 1e-3  # of the logarithm of stiffness
# Valleys whose loads over the limit differ by less than this are equally good.
_SAME_LOAD = 1e-3


def smallest_load(
    problem: DesignProblem, scanned: Sequence[Performance], n_valleys: int
) -> Optimum:
    """Return the point of smallest load over stiffness, at a fixed gap.

    The largest of 120 000 loads has a kink wherever another one takes the lead, so
    the best valleys of the scan are searched without derivatives.
    """
    before = problem.evaluator.rollouts
    floors = best_first(problem, local_minima(problem, scanned))[:n_valleys]
    ends = [_bounded_search(problem, scanned, floor) for floor in floors]
    rollouts = problem.evaluator.rollouts - before
    winner = best_first(problem, ends)[0]
    same = [abs(float(problem.value(end) - problem.value(winner))) for end in ends]
    return Optimum(
        objective=problem.objective.value,
        performance=winner,
        connection=problem.evaluator.candidate.connection.kind.value,
        coupling_type=problem.evaluator.candidate.coupling_type.name,
        method="bounded search",
        solver_status="not used",
        starts=len(ends),
        starts_agreeing=sum(difference <= _SAME_LOAD for difference in same),
        scan_points=len(scanned),
        rollouts=rollouts,
        kkt_residual=None,
        active_constraints=active_constraints(problem, winner),
        conditioning=conditioning(problem.evaluator, winner),
    )


def _bounded_search(
    problem: DesignProblem, scanned: Sequence[Performance], floor: Performance
) -> Performance:
    """Return the best point between the neighbours of a valley's floor."""
    from scipy.optimize import minimize_scalar

    at = next(i for i, performance in enumerate(scanned) if performance is floor)
    neighbours = scanned[max(at - 1, 0)], scanned[min(at + 1, len(scanned) - 1)]
    seen = [floor]

    def value(log_stiffness: float) -> float:
        stiffness = float(np.exp(log_stiffness))
        seen.append(problem.evaluator.performance(stiffness, floor.key_gap))
        return float(problem.value(seen[-1]))

    minimize_scalar(
        value,
        bounds=[float(np.log(p.torsional_stiffness)) for p in neighbours],
        method="bounded",
        options={"xatol": _RESOLUTION, "maxiter": _ITERATIONS},
    )
    return best_first(problem, seen)[0]

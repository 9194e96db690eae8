"""The smallest load of a candidate: a search without derivatives, valley by valley."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from coupling_design.design.activity import active_constraints
from coupling_design.design.conditioning import conditioning
from coupling_design.design.problem import DesignProblem
from coupling_design.design.results import Optimum, Performance
from coupling_design.design.scan import best_first, local_minima

# Points in each bracket, round by round: what is left of it is 1/325 and 1/64.
_WITH_LANES, _ONE_BY_ONE = (16, 16, 8), (3,) * 6
# Valleys whose loads over the limit differ by less than this are equally good.
_SAME_LOAD = 1e-3


def smallest_load(
    problem: DesignProblem,
    scanned: Sequence[Performance],
    n_valleys: int,
    coarsening: int = 1,
) -> Optimum:
    """Return the point of smallest load over stiffness, at a fixed gap.

    The largest of 120 000 loads has a kink wherever another one takes the lead, so
    the best valleys of the scan are searched without derivatives. All rounds but the
    last may have a time step `coarsening` times as long, known to be good enough.
    """
    before = _rollouts(problem)
    floors = best_first(problem, local_minima(problem, scanned))[:n_valleys]
    ends = _zoom(problem, scanned, floors, coarsening)
    rollouts = _rollouts(problem) - before
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


def _rollouts(problem: DesignProblem) -> int:
    return problem.evaluator.rollouts + problem.evaluator.coarse_rollouts


def _zoom(
    problem: DesignProblem,
    scanned: Sequence[Performance],
    floors: Sequence[Performance],
    coarsening: int,
) -> list[Performance]:
    """Return the best point of each valley, between the neighbours of its floor.

    Every round rolls out a few points in every bracket, all in one batch, and goes on
    between the neighbours of the best: 16 of them cost machine code no more than one.
    """
    evaluator, gap = problem.evaluator, floors[0].key_gap
    coarser = evaluator.coarser(coarsening) if coarsening > 1 else evaluator
    rounds = _WITH_LANES if evaluator.is_compiled else _ONE_BY_ONE
    brackets = [_neighbours(scanned, floor) for floor in floors]
    best = list(floors)
    for left, points in zip(reversed(range(len(rounds))), rounds, strict=True):
        inside = [k for bracket in brackets for k in _between(bracket, points)]
        rolled_out = (coarser if left else evaluator).performances(
            [(k, gap) for k in inside]
        )
        for i, bracket in enumerate(brackets):
            found = rolled_out[i * points : (i + 1) * points]
            known = [*bracket, best[i], *found] if left else [floors[i], *found]
            known.sort(key=lambda performance: performance.torsional_stiffness)
            best[i] = best_first(problem, known)[0]
            brackets[i] = _neighbours(known, best[i])
    return best


def _neighbours(
    performances: Sequence[Performance], of: Performance
) -> tuple[Performance, Performance]:
    """Return the points on either side of one, itself where there is none."""
    at = next(i for i, performance in enumerate(performances) if performance is of)
    last = len(performances) - 1
    return performances[max(at - 1, 0)], performances[min(at + 1, last)]


def _between(bracket: tuple[Performance, Performance], points: int) -> list[float]:
    """Return stiffnesses inside a bracket, spaced by ratio, its ends left out."""
    low, high = (performance.torsional_stiffness for performance in bracket)
    return [float(k) for k in np.geomspace(low, high, points + 2)[1:-1]]

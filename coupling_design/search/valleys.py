"""The smallest load of a candidate: a search without derivatives, valley by valley."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from coupling_design.search.activity import active_constraints, what_holds
from coupling_design.search.optimum import Optimum
from coupling_design.search.program import DesignProblem
from coupling_design.search.scan import best_first, local_minima
from coupling_design.wear.conditioning import conditioning
from coupling_design.wear.evaluator import Evaluator
from coupling_design.wear.performance import Performance

# Points in each bracket, round by round: what is left of it is 1/180 and 1/32.
_WITH_LANES, _ONE_BY_ONE = (16, 16, 4), (3,) * 5
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
    looked, ends = _zoom(problem, problem.evaluator.scan, scanned, floors, coarsening)
    if _is_open(problem, looked, ends):
        judge = problem.evaluator
        _, ends = _zoom(problem, judge, scanned, floors, coarsening)
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
        held_by=what_holds(problem, winner),
        conditioning=conditioning(problem.evaluator, winner),
    )


def _rollouts(problem: DesignProblem) -> int:
    return problem.evaluator.all_rollouts + problem.evaluator.coarse_rollouts


def _is_open(
    problem: DesignProblem,
    looked: Sequence[Performance],
    ends: Sequence[Performance],
) -> bool:
    """Return whether one crank angle leaves open if some stiffness keeps the limits.

    A peak over all crank angles is no smaller than that of one: where the smallest of
    one is too large, so are all. Only where it is not, and the ends are, is it open.
    """
    one = min(float(problem.load_ratio(each)) for each in looked)
    return one <= 1.0 < min(float(problem.load_ratio(end)) for end in ends)


def _zoom(
    problem: DesignProblem,
    guide: Evaluator,
    scanned: Sequence[Performance],
    floors: Sequence[Performance],
    coarsening: int,
) -> tuple[list[Performance], list[Performance]]:
    """Return the best point of each valley, between the neighbours of its floor.

    Every round rolls out a few points in every bracket, all in one batch, and goes on
    between the neighbours of the best: first as `guide` sees them, in the last round
    judged over all crank angles. What the guide saw last comes first.
    """
    gap = floors[0].key_gap
    coarser = guide.coarser(coarsening) if coarsening > 1 else guide
    rounds = _WITH_LANES if guide.is_compiled else _ONE_BY_ONE
    brackets = [_bracket(scanned, floor) for floor in floors]
    best, looked = list(floors), list(floors)
    for left, points in zip(reversed(range(len(rounds))), rounds, strict=True):
        # In the last round, at the case's own step, a bracket's ends decide nothing.
        inside = [
            sorted({at.torsional_stiffness, *_between(bracket, points)})
            if not left
            else sorted({*bracket, at.torsional_stiffness, *_between(bracket, points)})
            for bracket, at in zip(brackets, best, strict=True)
        ]
        judge = coarser if left else problem.evaluator
        found = judge.performances([(k, gap) for row in inside for k in row])
        rows = [[p for p in found if p.torsional_stiffness in row] for row in inside]
        looked, best = best, [best_first(problem, row)[0] for row in rows]
        brackets = [_bracket(row, at) for row, at in zip(rows, best, strict=True)]
    return looked, best


def _bracket(
    performances: Sequence[Performance], of: Performance
) -> tuple[float, float]:
    """Return the stiffnesses on either side of one, its own where there is none."""
    at = next(i for i, performance in enumerate(performances) if performance is of)
    around = (
        performances[max(at - 1, 0)],
        performances[min(at + 1, len(performances) - 1)],
    )
    return around[0].torsional_stiffness, around[1].torsional_stiffness


def _between(bracket: tuple[float, float], points: int) -> list[float]:
    """Return stiffnesses inside a bracket, spaced by ratio, its ends left out."""
    low, high = bracket
    return [float(k) for k in np.geomspace(low, high, points + 2)[1:-1]]

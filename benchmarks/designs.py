"""The flow's own searches beside what one would take from scipy.optimize.

Least damage of the present coupling type with a key, as in steps 3 and 5: over
stiffness at the present gap, then over stiffness and gap. scipy's methods get the same
compiled rollout, one design a call, and finite differences where they want a gradient.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from benchmarks.scale import Scale
from benchmarks.subject import SEED, Subject
from benchmarks.table import Row
from coupling_design.arithmetic import FloatArray
from coupling_design.flow.design import silent
from coupling_design.search.program import DesignProblem, DesignSpace, Objective
from coupling_design.search.workbench import CLOSE, Workbench, search
from coupling_design.steps.present import present_candidate
from coupling_design.wear.evaluator import Evaluator

_STARTS = (0.1, 0.3, 0.5, 0.7, 0.9)
_SAME = 1e-3  # of the logarithm of damage, as for the flow's own starts

Scaled = Callable[[FloatArray], float]


@dataclass(frozen=True)
class Found:
    """What a search came to from its best and its worst start, and what it cost."""

    damage: float
    worst: float
    seconds: float
    rollouts: int


def design_searches(subject: Subject, scale: Scale) -> list[Row]:
    """Return scipy's methods beside our search, with one variable and with two."""
    kind = subject.case.coupling_types[0]
    gap = getattr(subject.case.driveline.connection, "gap", 0.0)
    least = present_candidate(subject.case).connection.minimum_gap
    spaces = {
        "stiffness": DesignSpace(kind.stiffness_range, (gap, gap)),
        "stiffness and gap": DesignSpace(kind.stiffness_range, (least, gap)),
    }
    rows = []
    for name, space in spaces.items():
        rows += _rows(name, Subject(scale.case), space, scale)
    return rows


def _rows(name: str, subject: Subject, space: DesignSpace, scale: Scale) -> list[Row]:
    ours, problem = _ours(subject, space)
    key = name.replace(" ", "_")
    first = f"{ours.seconds:.2f} s, {ours.rollouts} rollouts"
    rows = [Row(f"{key}_ours", f"least damage over {name}, our search", first)]
    for method, solve in _methods(space, scale).items():
        found = _timed(_fresh(problem), solve)
        best, worst = (end / ours.damage for end in (found.damage, found.worst))
        shown = (
            f"{found.seconds / ours.seconds:.2f} x the time, {found.rollouts} "
            f"rollouts, {best:.4f} x the damage"
        )
        if worst > best:
            shown += f" (worst start {worst:.4f} x)"
        label = f"the same, {method}, against our search"
        rows.append(Row(f"{key}_{method}", label, shown))
    return rows


def _ours(subject: Subject, space: DesignSpace) -> tuple[Found, DesignProblem]:
    """Return what scan and Ipopt find; what checks its digits is in the cost."""
    bench = Workbench(subject.case, silent, CLOSE)
    evaluator = bench.evaluator(present_candidate(subject.case))
    problem = DesignProblem(evaluator, space, Objective.DAMAGE, ())
    _warm_up(evaluator, space)
    before, began = _cost(evaluator), time.perf_counter()
    performance = search(bench, problem).performance
    seconds = time.perf_counter() - began
    rollouts = _cost(evaluator) - before
    damage = float(performance.damage)
    return Found(damage, damage, seconds, rollouts), problem


def _cost(evaluator: Evaluator) -> int:
    """Return the rollouts so far, those to look around with too; half a step is two."""
    return evaluator.all_rollouts + 2 * evaluator.refined.all_rollouts


def _warm_up(evaluator: Evaluator, space: DesignSpace) -> None:
    """Build and load everything before the clock starts."""
    point = space.stiffness[0], space.gap[1]
    evaluator.performance(*point)
    evaluator.totals_and_jacobian(*point)
    evaluator.refined.performance(*point)


def _fresh(problem: DesignProblem) -> DesignProblem:
    old = problem.evaluator
    evaluator = Evaluator(old.case, old.candidate)
    _warm_up(evaluator, problem.space)
    return replace(problem, evaluator=evaluator)


def _timed(
    problem: DesignProblem, solve: Callable[[Scaled], list[FloatArray]]
) -> Found:
    def objective(scaled: FloatArray) -> float:
        point = problem.space.point(np.clip(scaled, 0.0, 1.0))
        stiffness, gap = (float(value) for value in point)
        return float(problem.value(problem.evaluator.performance(stiffness, gap)))

    before, began = problem.evaluator.rollouts, time.perf_counter()
    ends = solve(objective)
    seconds = time.perf_counter() - began
    rollouts = problem.evaluator.rollouts - before
    damages = [float(np.exp(objective(end))) for end in ends]
    return Found(min(damages), max(damages), seconds, rollouts)


def _methods(
    space: DesignSpace, scale: Scale
) -> dict[str, Callable[[Scaled], list[FloatArray]]]:
    """Return scipy's methods with their defaults, the local ones from each start."""
    from scipy.optimize import differential_evolution, minimize

    largest_gap = [1.0] if space.gap_is_free else []
    starts = [np.array([u, *largest_gap]) for u in _STARTS]
    bounds = [(0.0, 1.0)] * len(starts[0])

    def local(method: str) -> Callable[[Scaled], list[FloatArray]]:
        return lambda f: [
            np.asarray(minimize(f, start, method=method, bounds=bounds).x)
            for start in starts
        ]

    def evolve(**tolerance: float) -> Callable[[Scaled], list[FloatArray]]:
        limits = {"maxiter": scale.generations, "rng": SEED, **tolerance}
        return lambda f: [np.asarray(differential_evolution(f, bounds, **limits).x)]

    return {
        "SLSQP": local("SLSQP"),
        "Nelder-Mead": local("Nelder-Mead"),
        "differential evolution": evolve(),
        # Its own tolerance is relative to the objective, here a logarithm.
        "differential evolution to 1e-3": evolve(tol=0.0, atol=_SAME),
    }

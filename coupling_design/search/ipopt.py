"""Ipopt from several starts, every end checked again by a rollout of its own.

"Solve_Succeeded" is no proof on a function that rattling may roughen: the answer is
the best verified point of all starts and of the scan, and it says which it was.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np

from coupling_design.search.activity import active_constraints, what_holds
from coupling_design.search.optimum import Optimum
from coupling_design.search.program import DesignProblem
from coupling_design.search.scan import best_first, local_minima
from coupling_design.wear.conditioning import conditioning
from coupling_design.wear.performance import Performance

# Exact first derivatives, approximated second ones: a second derivative of 120 000
# steps costs more than the iterations it would save.
_IPOPT: dict[str, Any] = {
    "hessian_approximation": "limited-memory",
    # Starts are valley floors of a scan: a barrier this weak polishes them in a few
    # steps, where an adaptive one first walks away, sometimes to another valley.
    "mu_strategy": "monotone",
    "mu_init": 1e-4,
    # A damage is known to about five digits: more in the multipliers is not in it.
    "tol": 1e-5,
    "acceptable_tol": 1e-3,
    "acceptable_iter": 5,
    "max_iter": 30,
    # Scaled by hand already; one chaotic gradient must not set the scale.
    "nlp_scaling_method": "none",
    # A limit is a limit: no point beyond the bounds, not even by rounding.
    "bound_relax_factor": 0.0,
    "print_level": 0,
    "sb": "yes",
}
# Starts agree when they end this near in objective (a ratio, as it is a logarithm or
# of order one) and in every scaled variable.
_SAME_OBJECTIVE, _SAME_POINT = 1e-3, 1e-2
# The program's limits lie a little inside the scan's: less than this is no win.
_TIE = 1e-5
# How many of a scan's best are judged beside Ipopt's ends.
_JUDGED = 3
_CONVERGED = ("Solve_Succeeded", "Solved_To_Acceptable_Level")


@dataclass(frozen=True)
class _End:
    scaled: tuple[float, ...]
    performance: Performance
    status: str
    residual: float


def optimise(
    problem: DesignProblem,
    scanned: Sequence[Performance],
    n_starts: int,
) -> Optimum:
    """Return the best verified point, from the best `n_starts` of a scan.

    The point may violate constraints if nothing examined met them: ask the problem.
    """
    starts = _choose_starts(problem, scanned, n_starts)
    before = problem.evaluator.rollouts
    ends = [_run_ipopt(problem, start) for start in starts]
    best_end = best_first(problem, [end.performance for end in ends])[0]
    best_scanned = _judged(problem, scanned)
    rollouts = problem.evaluator.rollouts - before
    end = next(end for end in ends if end.performance is best_end)
    by_ipopt = _is_ipopts(problem, end, best_scanned)
    winner = best_end if by_ipopt else best_scanned
    return Optimum(
        objective=problem.objective.value,
        performance=winner,
        connection=problem.evaluator.candidate.connection.kind.value,
        coupling_type=problem.evaluator.candidate.coupling_type.name,
        method="ipopt" if by_ipopt else "scan",
        solver_status=end.status,
        starts=len(ends),
        starts_agreeing=_count_agreeing(problem, winner, ends),
        scan_points=len(scanned),
        rollouts=rollouts,
        kkt_residual=end.residual if by_ipopt else None,
        active_constraints=active_constraints(problem, winner),
        held_by=what_holds(problem, winner),
        conditioning=conditioning(problem.evaluator, winner),
    )


def _judged(problem: DesignProblem, scanned: Sequence[Performance]) -> Performance:
    """Return the best of a scan, those that look best judged over all crank angles."""
    best = best_first(problem, scanned)[:_JUDGED]
    points = [(p.torsional_stiffness, p.key_gap) for p in best]
    return best_first(problem, problem.evaluator.performances(points))[0]


def _is_ipopts(problem: DesignProblem, end: _End, scanned: Performance) -> bool:
    """Return whether Ipopt's end wins over the scan; a tie only if it converged."""
    if end.status in _CONVERGED:
        return not _clearly_better(problem, scanned, end.performance)
    return _clearly_better(problem, end.performance, scanned)


def _clearly_better(
    problem: DesignProblem, challenger: Performance, holder: Performance
) -> bool:
    """Return whether the challenger beats the holder by more than a tie."""
    feasible = problem.is_feasible(challenger), problem.is_feasible(holder)
    if feasible == (True, True):
        ahead = float(problem.value(holder)) - float(problem.value(challenger))
        return ahead > _TIE
    if feasible == (False, False):
        return problem.violation(challenger) < problem.violation(holder)
    return feasible[0]


def _choose_starts(
    problem: DesignProblem, scanned: Sequence[Performance], n_starts: int
) -> list[Performance]:
    """Return the best valley floors first, then the best of the rest."""
    ranked = best_first(problem, scanned)
    floors = local_minima(problem, _best_gaps(problem, scanned))
    preferred = [p for p in ranked if any(p is floor for floor in floors)]
    others = [p for p in ranked if not any(p is floor for floor in floors)]
    return [*preferred, *others][:n_starts]


def _best_gaps(
    problem: DesignProblem, scanned: Sequence[Performance]
) -> list[Performance]:
    """Return the best point of a scan at each stiffness, by rising stiffness.

    Damage hardly depends on a small gap: without this, all starts lie in one valley.
    """
    columns: dict[float, list[Performance]] = {}
    for performance in scanned:
        columns.setdefault(performance.torsional_stiffness, []).append(performance)
    return [best_first(problem, columns[stiffness])[0] for stiffness in sorted(columns)]


def _run_ipopt(problem: DesignProblem, start: Performance) -> _End:
    program, kept = problem.functions()
    n = program.size1_in(0)
    u = ca.MX.sym("u", n)
    objective, excess = program(u)
    parts: dict[str, Any] = {"x": u, "f": objective, "g": excess}
    options: dict[str, Any] = {
        "ipopt": _IPOPT,
        "print_time": False,
        "error_on_fail": False,
        "show_eval_warnings": False,  # the status says it, once
    }
    solver = ca.nlpsol(
        "design",
        "ipopt",
        parts,
        options,
    )
    u0 = problem.space.scaled(start.torsional_stiffness, start.key_gap)
    found = solver(x0=u0, lbx=0.0, ubx=1.0, lbg=-ca.inf, ubg=0.0)
    scaled = np.clip(np.asarray(found["x"]).ravel(), 0.0, 1.0)
    stiffness, gap = (float(value) for value in problem.space.point(ca.DM(scaled)))
    residual = _kkt_residual(program, found)
    status = str(solver.stats()["return_status"])
    del kept
    return _End(
        tuple(scaled),
        problem.evaluator.performance(stiffness, gap),
        status,
        residual,
    )


def _kkt_residual(program: ca.Function, found: dict[str, ca.DM]) -> float:
    """Return the largest entry of grad f + J' lam_g + lam_x at what was found."""
    u = program.mx_in(0)
    objective, excess = program(u)
    derivatives = ca.Function(
        "derivatives", [u], [ca.gradient(objective, u), ca.jacobian(excess, u)]
    )
    gradient, jacobian = derivatives(found["x"])
    residual = gradient + jacobian.T @ found["lam_g"] + found["lam_x"]
    return float(ca.norm_inf(residual))


def _count_agreeing(
    problem: DesignProblem, winner: Performance, ends: Sequence[_End]
) -> int:
    target = problem.space.scaled(winner.torsional_stiffness, winner.key_gap)
    value = float(problem.value(winner))

    def agrees(end: _End) -> bool:
        distance = max(abs(a - b) for a, b in zip(end.scaled, target, strict=True))
        difference = abs(float(problem.value(end.performance)) - value)
        return difference <= _SAME_OBJECTIVE and distance <= _SAME_POINT

    return sum(bool(agrees(end)) for end in ends)

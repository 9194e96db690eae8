"""Step 3: does an elastic coupling keep the bearing load below its limit?"""

from __future__ import annotations

from dataclasses import dataclass, replace

from coupling_design.machine.candidate import Candidate
from coupling_design.machine.hub_seat import ConnectionOption
from coupling_design.machine.machine import Case
from coupling_design.machine.words import Plan
from coupling_design.search.optimum import Optimum
from coupling_design.search.plane import Survey, survey
from coupling_design.search.program import (
    Constraint,
    DesignProblem,
    DesignSpace,
    Objective,
)
from coupling_design.search.reach import reachable_stiffness
from coupling_design.search.valleys import smallest_load
from coupling_design.search.workbench import count_valleys, problem, search
from coupling_design.steps.limits import (
    isolation_constraints,
    load_constraints,
    survival_constraints,
)
from coupling_design.steps.so_far import (
    AllowedType,
    FlowState,
    Solution,
    gap_nearest_present,
    options_of,
)
from coupling_design.steps.step_result import Alternative, Decision, StepResult

TITLE = "Bearing load"
QUESTION = (
    "Which stiffness of an isolating elastic coupling does the least damage while the "
    "peak load stays below its limit, at the present gap?"
)


def limit_bearing_load(state: FlowState) -> FlowState:
    """Return the state with an elastic solution, or with why there is none."""
    if not state.elastic:
        return state.after(
            StepResult(
                step=3,
                title=TITLE,
                question=QUESTION,
                decision=Decision.SKIPPED,
                findings=("No elastic coupling is left to examine.",),
            )
        )
    trials = [_examine(state, allowed) for allowed in state.elastic]
    state = replace(state, surveys=tuple((3, trial.plane) for trial in trials))
    passing = [trial for trial in trials if trial.solution is not None]
    if passing:
        best = min(passing, key=lambda trial: trial.optimum.performance.damage)
        return state.after(
            _result(state, trials, best, Decision.PASS), solution=best.solution
        )
    nearest = min(trials, key=lambda trial: trial.load_ratio)
    return state.after(
        _result(state, trials, nearest, Decision.FAIL), nearest=nearest.optimum
    )


@dataclass(frozen=True)
class _Trial:
    """What one elastic type came to; `load_ratio`: smallest load over the limit."""

    optimum: Optimum
    load_ratio: float
    alternatives: tuple[Alternative, ...]
    findings: tuple[str, ...]
    plane: Survey
    solution: Solution | None


def _examine(state: FlowState, allowed: AllowedType) -> _Trial:
    case, bench = state.case, state.bench
    option, stiffness = _examined(state, allowed)
    gap = gap_nearest_present(case, option)
    candidate = Candidate(allowed.coupling_type, option)
    limits = _limits(case)
    space = DesignSpace(stiffness, (gap, gap))
    # A damage is no load: it does not count as one over its limit.
    loads = (*isolation_constraints(case), *load_constraints(case))
    least_load = problem(bench, candidate, space, Objective.PEAK, loads)
    plane = survey(bench, replace(least_load, space=replace(space, gap=(0.0, gap))))
    scanned = plane.largest_gap
    bench.progress(f"least load of {candidate.label}")
    lowest = smallest_load(least_load, scanned, bench.effort.starts, plane.longest_step)
    ratio = float(least_load.load_ratio(lowest.performance))
    trial = _Trial(
        optimum=lowest,
        load_ratio=ratio,
        alternatives=_evidence("at the present gap", lowest, ratio),
        findings=(_scan_finding(candidate, least_load, plane),),
        plane=plane,
        solution=None,
    )
    if ratio > 1.0:
        closed = _with_gap_closed(state, least_load, plane)
        return replace(trial, alternatives=(*trial.alternatives, *closed))
    bench.progress(f"least damage of {candidate.label}")
    damage = problem(bench, candidate, space, Objective.DAMAGE, limits)
    best = search(bench, damage, scanned)
    if not damage.is_feasible(best.performance):
        return trial
    solution = Solution(Plan.ELASTIC, candidate, allowed, best, limits)
    return replace(trial, optimum=best, solution=solution)


def _examined(
    state: FlowState, allowed: AllowedType
) -> tuple[ConnectionOption, tuple[float, float]]:
    """Return the connection a type is examined in, and what isolates there [N m/rad].

    The present one, or else the loosest it may have; another where that never isolates.
    """
    case, limits = state.case, isolation_constraints(state.case)
    options = options_of(case, allowed.coupling_type)
    present = case.present_connection
    for option in sorted(options, key=lambda option: option.kind is not present):
        evaluator = state.bench.evaluator(Candidate(allowed.coupling_type, option))
        own = reachable_stiffness(evaluator, limits, allowed.stiffness)
        if own is not None:
            return option, own
    return options[0], allowed.stiffness


def _limits(case: Case) -> tuple[Constraint, ...]:
    return (
        *isolation_constraints(case),
        *load_constraints(case),
        *survival_constraints(case),
    )


def _scan_finding(candidate: Candidate, program: DesignProblem, plane: Survey) -> str:
    low, high = (stiffness / 1e6 for stiffness in program.space.stiffness)
    valleys = count_valleys(program, plane.largest_gap)
    longer = (
        f" The smallest peak is narrowed down at {plane.longest_step} times the time "
        "step, its last round at the case's own."
        if plane.longest_step > 1
        else ""
    )
    return (
        f"{candidate.label}: {len(plane.largest_gap)} stiffnesses from {low:.4g} to "
        f"{high:.4g} MN*m/rad at each of {plane.n_gaps} gaps; at the present gap "
        f"damage has {valleys} valley{'' if valleys == 1 else 's'}."
        f"{longer}"
    )


def _with_gap_closed(
    state: FlowState, program: DesignProblem, plane: Survey
) -> tuple[Alternative, ...]:
    if program.space.gap[1] == 0.0:
        return ()
    label = program.evaluator.candidate.label
    state.bench.progress(f"least load of {label} with the gap closed")
    closed = replace(program, space=replace(program.space, gap=(0.0, 0.0)))
    lowest = smallest_load(closed, plane.smallest_gap, 1, plane.longest_step)
    ratio = float(closed.load_ratio(lowest.performance))
    return _evidence("with the gap closed", lowest, ratio)


def _evidence(
    where: str, lowest: Optimum, load_ratio: float
) -> tuple[Alternative, ...]:
    return (
        Alternative(
            name=f"{lowest.coupling_type}: smallest peak {where}",
            passes=load_ratio <= 1.0,
            performance=lowest.performance,
            remark=f"{load_ratio:.3f} of the limit, from {lowest.scan_points} scanned "
            f"stiffnesses and {lowest.rollouts} rollouts in the best valleys",
        ),
    )


def _closed_gap_caveat(trials: list[_Trial]) -> tuple[str, ...]:
    """Return a caveat if closing the gap alone would have let an elastic type pass."""
    return tuple(
        f"{alternative.name} would meet the limit: a tight fit is worth considering "
        "before a high-stiffness coupling. The method judges at the present gap."
        for trial in trials
        for alternative in trial.alternatives[1:]
        if trial.solution is None and alternative.passes
    )


def _result(
    state: FlowState, trials: list[_Trial], shown: _Trial, decision: Decision
) -> StepResult:
    performance = shown.optimum.performance
    return StepResult(
        step=3,
        title=TITLE,
        question=QUESTION,
        decision=decision,
        criteria=tuple(limit.criterion(performance) for limit in _limits(state.case)),
        alternatives=tuple(a for trial in trials for a in trial.alternatives),
        findings=tuple(f for trial in trials for f in trial.findings),
        caveats=_closed_gap_caveat(trials),
        optimum=shown.optimum,
    )

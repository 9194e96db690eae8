"""Step 4: how stiff must a coupling be to stand above every excitation?"""

from __future__ import annotations

from dataclasses import dataclass

from coupling_design.machine.candidate import Candidate
from coupling_design.machine.hub_seat import ConnectionOption
from coupling_design.machine.machine import Case
from coupling_design.machine.words import Plan
from coupling_design.search.optimum import Optimum
from coupling_design.search.program import DesignSpace, Objective
from coupling_design.search.workbench import (
    out_of_reach,
    problem,
    search,
    verdict_remark,
)
from coupling_design.steps.limits import (
    ISOLATION_RATIO,
    deciding_orders,
    high_frequency_constraint,
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

TITLE = "High-stiffness plan"
QUESTION = (
    "What is the lowest stiffness whose natural frequency stands sqrt 2 above the "
    "highest excitation and whose peak load stays below its limit?"
)


def plan_high_stiffness(state: FlowState) -> FlowState:
    """Return the state with a high-stiffness solution, if Step 3 left none."""
    if state.solution is not None:
        return _skip(state, "Step 3 found an elastic coupling: no stiff one is needed.")
    if not state.stiff:
        return _skip(state, "No high-stiffness coupling carries the torque.")
    trials = [
        _examine(state, allowed, option)
        for allowed in state.stiff
        for option in options_of(state.case, allowed.coupling_type)
    ]
    solutions = [trial.solution for trial in trials if trial.solution is not None]
    if not solutions:
        return _fail(state, trials)
    best = min(
        solutions,
        key=lambda found: float(found.optimum.performance.torsional_stiffness),
    )
    return state.after(
        _result(state, trials, best.optimum, Decision.PASS), solution=best
    )


@dataclass(frozen=True)
class _Trial:
    """What one type in one connection came to; `excess` is its largest violation."""

    alternative: Alternative
    optimum: Optimum | None
    excess: float
    solution: Solution | None


def _examine(
    state: FlowState, allowed: AllowedType, option: ConnectionOption
) -> _Trial:
    case, bench = state.case, state.bench
    candidate = Candidate(allowed.coupling_type, option)
    frequency = high_frequency_constraint(case)
    loads = (*load_constraints(case), *survival_constraints(case))
    gap = gap_nearest_present(case, option)
    program = problem(
        bench,
        candidate,
        DesignSpace(allowed.stiffness, (gap, gap)),
        Objective.STIFFNESS,
        (frequency, *loads),
    )
    unreachable = out_of_reach(program)
    if unreachable is not None:
        excess, remark = unreachable
        alternative = Alternative(candidate.label, False, None, remark)
        return _Trial(alternative, None, excess, None)
    bench.progress(f"lowest stiffness of {candidate.label}")
    optimum = search(bench, program)
    performance = optimum.performance
    passes = program.is_feasible(performance)
    remark = verdict_remark(program, performance)
    solution = Solution(
        Plan.HIGH_STIFFNESS, candidate, allowed, optimum, (frequency, *loads)
    )
    return _Trial(
        Alternative(candidate.label, passes, performance, remark),
        optimum,
        program.violation(performance),
        solution if passes else None,
    )


def _skip(state: FlowState, reason: str) -> FlowState:
    return state.after(
        StepResult(
            step=4,
            title=TITLE,
            question=QUESTION,
            decision=Decision.SKIPPED,
            findings=(reason,),
        )
    )


def _fail(state: FlowState, trials: list[_Trial]) -> FlowState:
    rolled = [trial for trial in trials if trial.optimum is not None]
    if not rolled:
        return state.after(_result(state, trials, None, Decision.FAIL))
    nearest = min(rolled, key=lambda trial: trial.excess).optimum
    return state.after(_result(state, trials, nearest, Decision.FAIL), nearest=nearest)


def _deciding(case: Case, frequency: float) -> str:
    """Return which order makes the limit, and what small ones have to do with it."""
    highest, strong = deciding_orders(case)
    told = (
        f"The highest excitation is {frequency / ISOLATION_RATIO:.2f} Hz, order "
        f"{highest:g} at the highest working speed; sqrt 2 times it is "
        f"{frequency:.2f} Hz."
    )
    if strong == highest:
        return f"{told} No order above it is left out; it is not a small one."
    return (
        f"{told} Without the orders under 1 % of the largest amplitude it would be "
        f"order {strong:g}, and the limit {frequency * strong / highest:.2f} Hz."
    )


def _result(
    state: FlowState,
    trials: list[_Trial],
    shown: Optimum | None,
    decision: Decision,
) -> StepResult:
    limits = (
        high_frequency_constraint(state.case),
        *load_constraints(state.case),
        *survival_constraints(state.case),
    )
    frequency = limits[0].limit
    return StepResult(
        step=4,
        title=TITLE,
        question=QUESTION,
        decision=decision,
        criteria=()
        if shown is None
        else tuple(limit.criterion(shown.performance) for limit in limits),
        alternatives=tuple(trial.alternative for trial in trials),
        findings=(_deciding(state.case, frequency),),
        optimum=shown,
    )

"""Step 5: what is the smallest key gap, with everything else kept?"""

from __future__ import annotations

from dataclasses import dataclass, replace

from coupling_design.line.contact import SHARP, sharpness
from coupling_design.line.parameters import KeyedConnection
from coupling_design.machine.candidate import Candidate, candidate_driveline
from coupling_design.machine.hub_seat import ConnectionOption
from coupling_design.search.optimum import Optimum
from coupling_design.search.program import DesignProblem, DesignSpace, Objective
from coupling_design.search.workbench import (
    Workbench,
    out_of_reach,
    problem,
    search,
    verdict_remark,
)
from coupling_design.steps.parsimony import (
    WORTH_A_CHANGE,
    keep_lowest_stiffness,
    kept_finding,
)
from coupling_design.steps.so_far import (
    FlowState,
    Solution,
    gap_nearest_present,
    options_of,
)
from coupling_design.steps.step_result import Alternative, Decision, StepResult

TITLE = "Key gap"
QUESTION = (
    "What is the smallest gap the connection allows with every limit kept, and which "
    "stiffness and gap together do the least damage?"
)
# A gap within this of the smallest, relative, is the smallest.
_SAME_GAP = 1e-3


def minimise_key_gap(state: FlowState) -> FlowState:
    """Return the state with the tightest connection that keeps every limit."""
    solution = state.solution
    if solution is None:
        return state.after(
            StepResult(
                step=5,
                title=TITLE,
                question=QUESTION,
                decision=Decision.SKIPPED,
                findings=("No coupling meets the limits: there is no gap to reduce.",),
            )
        )
    # The tightest first: it is the one to be looked at closely.
    options = reversed(options_of(state.case, solution.allowed.coupling_type))
    trials: list[_Trial] = []
    for option in options:
        found = any(trial.alternative.passes for trial in trials)
        starts = 1 if found else state.bench.effort.starts
        trials.append(_examine(state, solution, option, starts))
    passing = [trial for trial in trials if trial.alternative.passes]
    tightest = _tightest(solution, passing)
    chosen = keep_lowest_stiffness(state, solution, tightest)
    result = _result(state, chosen, tightest, trials, passing)
    return state.after(result, solution=chosen)


def _tightest(solution: Solution, passing: list[_Trial]) -> Solution:
    """Return the solution in the tightest connection that passes.

    The earlier step's own stands where none was found again.
    """
    for trial in passing:
        if trial.optimum is not None:
            return replace(solution, candidate=trial.candidate, optimum=trial.optimum)
    return solution


@dataclass(frozen=True)
class _Trial:
    """What one connection came to; no optimum where no stiffness is in reach."""

    candidate: Candidate
    alternative: Alternative
    optimum: Optimum | None


def _examine(
    state: FlowState, solution: Solution, option: ConnectionOption, starts: int
) -> _Trial:
    bench = state.bench
    candidate = Candidate(solution.allowed.coupling_type, option)
    largest = gap_nearest_present(state.case, option)
    program = problem(
        bench,
        candidate,
        DesignSpace(solution.allowed.stiffness, (option.minimum_gap, largest)),
        Objective.DAMAGE,
        solution.constraints,
    )
    unreachable = out_of_reach(program)
    if unreachable is not None:
        return _Trial(
            candidate, Alternative(candidate.label, False, None, unreachable[1]), None
        )
    bench.progress(f"least damage of {candidate.label}, stiffness and gap")
    optimum = _at_smallest_gap(bench, program, search(bench, program, starts=starts))
    performance = optimum.performance
    return _Trial(
        candidate,
        Alternative(
            candidate.label,
            program.is_feasible(performance),
            performance,
            verdict_remark(program, performance),
        ),
        optimum,
    )


def _at_smallest_gap(
    bench: Workbench, program: DesignProblem, joint: Optimum
) -> Optimum:
    """Return the joint optimum, or the one at the smallest gap if that passes too.

    The method asks for the smallest gap, which need not be the least damage.
    """
    smallest = program.space.gap[0]
    if joint.performance.key_gap <= smallest * (1 + _SAME_GAP):
        return joint
    tight = replace(program, space=replace(program.space, gap=(smallest, smallest)))
    optimum = search(bench, tight, starts=1)
    return optimum if tight.is_feasible(optimum.performance) else joint


def _result(
    state: FlowState,
    chosen: Solution,
    tightest: Solution,
    trials: list[_Trial],
    passing: list[_Trial],
) -> StepResult:
    performance, optimum = chosen.optimum.performance, tightest.optimum
    findings = [
        f"{len(passing)} of {len(trials)} connections keep every limit; the tightest "
        f"is {chosen.candidate.label}."
    ]
    if chosen is not tightest:
        findings.append(kept_finding(chosen, tightest))
    return StepResult(
        step=5,
        title=TITLE,
        question=QUESTION,
        decision=Decision.PASS,
        criteria=tuple(c.criterion(performance) for c in chosen.constraints),
        alternatives=tuple(trial.alternative for trial in trials),
        findings=tuple(findings),
        caveats=(*_caveats(chosen, passing), *_blunt(state, trials)),
        optimum=optimum,
    )


def _blunt(state: FlowState, trials: list[_Trial]) -> tuple[str, ...]:
    """Return which gaps are so small that the smoothing takes part of them."""
    found = []
    for trial in trials:
        performance = trial.alternative.performance
        if performance is None or performance.key_gap == 0.0:
            continue
        driveline = candidate_driveline(
            state.case, trial.candidate, 1.0, performance.key_gap
        )
        if isinstance(driveline.connection, KeyedConnection):
            s_b = float(sharpness(driveline.connection))
            if s_b < SHARP:
                found.append(
                    f"{trial.candidate.label}, {performance.key_gap * 1e3:.3g} mm: the "
                    f"edge of the gap is smoothed over 1/{s_b:.3g} of half the gap "
                    f"(1/{SHARP:.0f} or less is sharp), so its rattle is understated."
                )
    return tuple(found)


def _caveats(chosen: Solution, passing: list[_Trial]) -> tuple[str, ...]:
    damage = chosen.optimum.performance.damage
    optima = [trial.optimum for trial in passing if trial.optimum is not None]
    if not optima:
        return ()
    least = min(optima, key=lambda optimum: optimum.performance.damage)
    less = 1 - least.performance.damage / damage
    if less <= WORTH_A_CHANGE or least.connection == chosen.optimum.connection:
        return ()
    return (
        f"The smallest gap is not the least damage: {least.connection} does "
        f"{less:.1%} less.",
    )

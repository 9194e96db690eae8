"""Step 5: what is the smallest key gap, with everything else kept?"""

from __future__ import annotations

from dataclasses import dataclass, replace

from coupling_design.case.case import ConnectionOption
from coupling_design.design.candidate import Candidate
from coupling_design.design.problem import DesignSpace, Objective
from coupling_design.design.results import (
    Alternative,
    Decision,
    Optimum,
    StepResult,
)
from coupling_design.design.search import (
    out_of_reach,
    problem,
    search,
    verdict_remark,
)
from coupling_design.design.state import (
    FlowState,
    Solution,
    gap_nearest_present,
    options_of,
)

TITLE = "Key gap"
QUESTION = (
    "What is the smallest gap the connection allows with every limit kept, and which "
    "stiffness and gap together do the least damage?"
)
# A connection that does this much less damage than the tightest is worth saying.
_WORTH_SAYING = 1e-3


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
    options = options_of(state.case, solution.allowed.coupling_type)
    trials = [_examine(state, solution, option) for option in options]
    passing = [trial for trial in trials if trial.alternative.passes]
    chosen = _tightest(solution, passing)
    return state.after(_result(chosen, trials, passing), solution=chosen)


def _tightest(solution: Solution, passing: list[_Trial]) -> Solution:
    """Return the solution in the tightest connection that passes.

    The earlier step's own stands where none was found again.
    """
    for trial in reversed(passing):
        if trial.optimum is not None:
            return replace(solution, candidate=trial.candidate, optimum=trial.optimum)
    return solution


@dataclass(frozen=True)
class _Trial:
    """What one connection came to; no optimum where no stiffness is in reach."""

    candidate: Candidate
    alternative: Alternative
    optimum: Optimum | None


def _examine(state: FlowState, solution: Solution, option: ConnectionOption) -> _Trial:
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
    optimum = search(bench, program)
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


def _result(
    chosen: Solution, trials: list[_Trial], passing: list[_Trial]
) -> StepResult:
    performance = chosen.optimum.performance
    least = min(
        (t.optimum for t in passing if t.optimum is not None),
        key=lambda optimum: optimum.performance.damage,
    )
    caveats = []
    if least.performance.damage < performance.damage * (1 - _WORTH_SAYING):
        caveats.append(
            f"The smallest gap is not the least damage: {least.connection} does "
            f"{1 - least.performance.damage / performance.damage:.1%} less."
        )
    return StepResult(
        step=5,
        title=TITLE,
        question=QUESTION,
        decision=Decision.PASS,
        criteria=tuple(c.criterion(performance) for c in chosen.constraints),
        alternatives=tuple(trial.alternative for trial in trials),
        findings=(
            f"{len(passing)} of {len(trials)} connections keep every limit; the "
            f"tightest is {chosen.candidate.label}.",
        ),
        caveats=tuple(caveats),
        optimum=chosen.optimum,
    )

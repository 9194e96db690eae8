"""The design flow: five steps in order, and what comes out at the end."""

from __future__ import annotations

import time
from collections.abc import Callable
from contextlib import closing

from coupling_design.checks.coupling import size_criteria, torque_criteria
from coupling_design.checks.fatigue_limits import fatigue_limits
from coupling_design.checks.time_step import check_time_step
from coupling_design.checks.warnings import weight_above_limit
from coupling_design.flow.maps import (
    chosen_plane,
    steps_with_maps,
)
from coupling_design.flow.outcome import ChosenDesign, DesignOutcome, LoadReading
from coupling_design.flow.real_sizes import choose_size, settle
from coupling_design.flow.remarks import (
    fuel_cut_at_once,
    outcome_remarks,
    outcome_warnings,
)
from coupling_design.machine.candidate import Candidate
from coupling_design.machine.machine import Case
from coupling_design.machine.words import ConnectionKind, LoadLimitReading, Plan
from coupling_design.parts.bearing.contact_stress import strict_transmission_force
from coupling_design.parts.criterion import Criterion, none_fails
from coupling_design.search.optimum import Optimum
from coupling_design.search.workbench import (
    CLOSE,
    COARSE,
    Effort,
    Progress,
    Workbench,
)
from coupling_design.steps.bearing_load import limit_bearing_load
from coupling_design.steps.coupling_types import determine_coupling_types
from coupling_design.steps.high_stiffness_plan import plan_high_stiffness
from coupling_design.steps.key_gap import minimise_key_gap
from coupling_design.steps.limits import load_constraints
from coupling_design.steps.present import (
    evaluate_baseline,
    present_candidate,
    rundown,
)
from coupling_design.steps.so_far import (
    FlowState,
    Solution,
    connection_option,
    options_of,
)
from coupling_design.steps.vibration_isolation import (
    check_vibration_isolation,
)
from coupling_design.wear.conditioning import conditioning
from coupling_design.wear.performance import Performance
from coupling_design.wear.sensitivity import reduction_range, sensitivity
from coupling_design.wear.signals import RundownHistory, rundown_history

Stage = Callable[[FlowState], FlowState]

STAGES: tuple[Stage, ...] = (
    determine_coupling_types,
    check_vibration_isolation,
    limit_bearing_load,
    plan_high_stiffness,
    minimise_key_gap,
)


def silent(_: str) -> None:
    """Take a progress message and say nothing."""


def run_design(
    case: Case, progress: Progress = silent, effort: Effort | None = None
) -> DesignOutcome:
    """Return the outcome of the five-step flow on a case.

    Raises CaseError if the time step is too large for the case's own driveline, and
    SimulationError if a run-down leaves finite numbers.
    """
    began = time.perf_counter()
    check_time_step(case)
    with closing(Workbench(case, progress)) as bench:
        progress("present coupling")
        _start_compiling(bench)
        state = FlowState(case, bench, evaluate_baseline(bench))
        bench.effort = effort or (CLOSE if bench.is_compiled else COARSE)
        for number, stage in enumerate(STAGES, start=1):
            bench.progress = _prefixed(progress, f"step {number} of {len(STAGES)}: ")
            state = stage(state)
        return _outcome(state, began)


def _start_compiling(bench: Workbench) -> None:
    """Have machine code made for what comes first, and for what step 4 may need."""
    case = bench.case
    stiff = (t for t in case.coupling_types if t.plan is Plan.HIGH_STIFFNESS)
    tight = (Candidate(each, options_of(case, each)[-1]) for each in stiff)
    for candidate in (present_candidate(case), *tight):
        bench.evaluator(candidate).run_downs.start_compiling()


def _outcome(state: FlowState, began: float) -> DesignOutcome:
    """Return what the steps came to, once the rows in the background are there."""
    case, bench = state.case, state.bench
    choice = choose_size(state)
    state = settle(state, choice)
    plane = chosen_plane(state, state.solution) if state.solution else None
    chosen = _chosen(state, state.solution) if state.solution else None
    nearest = None if chosen else state.nearest
    shown = chosen or nearest
    histories = _histories(state, chosen, nearest)
    if state.surveys or plane:
        bench.progress("finishing the map")
    return DesignOutcome(
        case=case,
        baseline=state.baseline,
        steps=steps_with_maps(state),
        chosen=chosen,
        strict_reading=_strict_reading(case, shown.performance) if shown else None,
        nearest=nearest,
        nearest_criteria=_nearest_criteria(state) if nearest else (),
        assumptions=case.assumptions,
        histories=histories,
        chosen_map=plane.design_map() if plane else None,
        engine=bench.engine,
        rollouts=bench.rollouts,
        coarse_rollouts=bench.coarse_rollouts,
        run_time=time.perf_counter() - began,
        catalogue_choice=choice,
        fatigue_limits=fatigue_limits(case),
        warnings=tuple(outcome_warnings(state, chosen, shown)),
        reasons=() if chosen else tuple(weight_above_limit(case)),
        remarks=tuple(outcome_remarks(state, chosen)),
    )


def _prefixed(progress: Progress, prefix: str) -> Progress:
    return lambda message: progress(prefix + message)


def _chosen(state: FlowState, solution: Solution) -> ChosenDesign:
    case, candidate = state.case, solution.candidate
    evaluator = state.bench.evaluator(candidate)
    performance = solution.optimum.performance
    state.bench.progress("run-down of the chosen coupling")
    moved = sensitivity(evaluator, performance)
    return ChosenDesign(
        plan=solution.plan,
        coupling_type=candidate.coupling_type.name,
        connection=candidate.connection.kind.value,
        performance=performance,
        rundown=rundown(evaluator, performance),
        conditioning=solution.optimum.conditioning
        or conditioning(evaluator, performance),
        damage_reduction=1 - performance.damage / state.baseline.performance.damage,
        criteria=(
            *(
                size_criteria(case, candidate, candidate.size)
                if candidate.size
                else torque_criteria(case, candidate.coupling_type)
            ),
            *(limit.criterion(performance) for limit in solution.constraints),
        ),
        sensitivity=moved,
        reduction_range=reduction_range(state.baseline.sensitivity, moved),
        fuel_cut_at_once=fuel_cut_at_once(evaluator, performance)
        if solution.plan is Plan.HIGH_STIFFNESS
        else None,
        size=candidate.size.name if candidate.size else None,
    )


def _histories(
    state: FlowState, chosen: ChosenDesign | None, nearest: Optimum | None
) -> tuple[RundownHistory, ...]:
    """Return the present run-down, and the chosen or the nearest one beside it."""
    state.bench.progress("histories for the figures")
    case = state.case
    before = state.baseline.performance
    present = _history(state, present_candidate(case), before, "present")
    if chosen and state.solution:
        candidate = state.solution.candidate
        return present, _history(state, candidate, chosen.performance, "chosen")
    if nearest is None:
        return (present,)
    kind = next(t for t in case.coupling_types if t.name == nearest.coupling_type)
    connection = connection_option(case, ConnectionKind(nearest.connection))
    candidate = Candidate(kind, connection)
    return present, _history(state, candidate, nearest.performance, "nearest")


def _history(
    state: FlowState, candidate: Candidate, performance: Performance, role: str
) -> RundownHistory:
    evaluator = state.bench.evaluator(candidate)
    history = evaluator.history(performance.torsional_stiffness, performance.key_gap)
    return rundown_history(state.case, candidate.label, history, performance, role)


def _strict_reading(case: Case, performance: Performance) -> LoadReading:
    criteria = tuple(
        limit.criterion(performance)
        for limit in load_constraints(case, LoadLimitReading.COMBINED_LOAD)
    )
    return LoadReading(
        reading=LoadLimitReading.COMBINED_LOAD.value,
        criteria=criteria,
        passes=none_fails(criteria),
        permissible_transmission_force=float(
            strict_transmission_force(case.shaft, case.bearings)
        ),
    )


def _nearest_criteria(state: FlowState) -> tuple[Criterion, ...]:
    """Return the criteria of the step whose failing optimum came nearest."""
    for result in reversed(state.steps):
        if state.nearest is not None and result.optimum is state.nearest:
            return result.criteria
    return ()

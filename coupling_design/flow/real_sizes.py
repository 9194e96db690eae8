"""The best real size of a catalogue beside the ideal stiffness, and its price."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from coupling_design.checks.coupling import size_criteria
from coupling_design.flow.size_choice import CatalogueChoice, SizeTrial
from coupling_design.machine.candidate import Candidate
from coupling_design.machine.coupling_size import CouplingSize
from coupling_design.machine.coupling_type import CouplingType
from coupling_design.machine.machine import Case
from coupling_design.machine.words import Choice
from coupling_design.parts.criterion import Criterion, Verdict, none_fails
from coupling_design.steps.coupling_types import carrying_sizes
from coupling_design.steps.so_far import FlowState, Solution
from coupling_design.wear.conditioning import conditioning

_ALL_MET = "meets every limit"


def choose_size(state: FlowState) -> CatalogueChoice | None:
    """Return what the sizes of the chosen plan come to in the chosen connection.

    None where the case names no catalogue, or where there is no design.
    """
    case, solution = state.case, state.solution
    if solution is None or not case.catalogues:
        return None
    trials = tuple(
        _try(state, solution, series, size)
        for series in case.coupling_types
        if series.sizes and series.plan is solution.plan
        for size, _ in carrying_sizes(case, series)
    )
    selected = _least_damage(trials)
    ideal = solution.optimum.performance
    return CatalogueChoice(
        files=case.catalogues,
        plan=solution.plan.value,
        connection=solution.candidate.connection.kind.value,
        ideal_type=solution.candidate.coupling_type.name,
        ideal=ideal,
        trials=trials,
        selected=selected,
        price=_damage(selected) / ideal.damage - 1 if selected else None,
        price_of_stiffness=_price_of_stiffness(state, solution, selected),
        is_chosen=selected is not None and case.choose is Choice.CATALOGUE,
        findings=(*_smallest(trials, selected), *_findings(case, trials)),
    )


def settle(state: FlowState, choice: CatalogueChoice | None) -> FlowState:
    """Return the state with the real size as its solution, if the case wants that."""
    solution = state.solution
    if choice is None or solution is None or not choice.is_chosen:
        return state
    selected = choice.selected
    if selected is None or selected.performance is None:
        return state
    candidate = _candidate(state.case, solution, selected.size)
    evaluator = state.bench.evaluator(candidate)
    optimum = replace(
        solution.optimum,
        performance=selected.performance,
        coupling_type=selected.size.series,
        method="catalogue",
        conditioning=conditioning(evaluator, selected.performance),
    )
    settled = replace(solution, candidate=candidate, optimum=optimum)
    return replace(state, solution=settled)


def _try(
    state: FlowState, solution: Solution, series: CouplingType, size: CouplingSize
) -> SizeTrial:
    """Return how one size fares; a run-down only where nothing else rules it out."""
    kind = solution.candidate.connection.kind
    if kind not in series.connections:
        remark = f"not made with a {kind.replace('_', ' ')}"
        return SizeTrial(size, None, (), passes=False, remark=remark)
    candidate = _candidate(state.case, solution, size)
    evaluator = state.bench.evaluator(candidate)
    asked = size_criteria(state.case, candidate, size)
    outline = evaluator.outline(size.torsional_stiffness)
    known = (
        *asked,
        *(c.criterion(outline) for c in solution.constraints if not c.needs_rollout),
    )
    if not none_fails(known):
        return SizeTrial(size, None, known, passes=False, remark=_remark(known))
    state.bench.progress(f"size {candidate.label}")
    gap = float(solution.optimum.performance.key_gap)
    performance = evaluator.performance(size.torsional_stiffness, gap)
    criteria = (*asked, *(c.criterion(performance) for c in solution.constraints))
    passes = none_fails(criteria)
    return SizeTrial(size, performance, criteria, passes, _remark(criteria))


def _candidate(case: Case, solution: Solution, size: CouplingSize) -> Candidate:
    series = next(each for each in case.coupling_types if each.name == size.series)
    return Candidate(series, solution.candidate.connection, size)


def _remark(criteria: tuple[Criterion, ...]) -> str:
    failed = [c.name.partition(": ")[2] or c.name for c in criteria if c.fails]
    if failed:
        return f"fails: {'; '.join(failed)}"
    unknown = [c for c in criteria if c.verdict is Verdict.NOT_CHECKED]
    names = "; ".join(c.name.partition(": ")[2] or c.name for c in unknown)
    return f"meets every limit checked; not checked: {names}" if names else _ALL_MET


def _least_damage(trials: tuple[SizeTrial, ...]) -> SizeTrial | None:
    passing = [trial for trial in trials if trial.passes and trial.performance]
    return min(passing, key=_damage, default=None)


def _damage(trial: SizeTrial) -> float:
    return trial.performance.damage if trial.performance else float("inf")


def _price_of_stiffness(
    state: FlowState, solution: Solution, selected: SizeTrial | None
) -> float | None:
    """Return by how much the damage moves with the size's stiffness and no more."""
    if selected is None:
        return None
    ideal = solution.optimum.performance
    evaluator = state.bench.evaluator(solution.candidate)
    stiffness = selected.size.torsional_stiffness
    alone = evaluator.performance(stiffness, float(ideal.key_gap))
    return alone.damage / ideal.damage - 1


def _smallest(
    trials: tuple[SizeTrial, ...], selected: SizeTrial | None
) -> Iterator[str]:
    """Yield the smallest size that serves, where the best is a larger one."""
    passing = [trial for trial in trials if trial.passes]
    if selected is None:
        return
    smallest = min(passing, key=lambda trial: trial.size.nominal_torque)
    if smallest.size.nominal_torque < selected.size.nominal_torque:
        more = _damage(smallest) / _damage(selected) - 1
        yield (
            f"The smallest size that meets every limit is {smallest.size.name}; it "
            f"does {more:.1%} more damage than {selected.size.name}."
        )


def _findings(case: Case, trials: tuple[SizeTrial, ...]) -> Iterator[str]:
    yield (
        "Each size was rolled out with its own stiffness and damping, in the chosen "
        "connection and with its gap."
    )
    sizes = [trial.size for trial in trials]
    if not any(size.driven_inertia or size.driving_inertia for size in sizes):
        yield "The catalogue gives no inertias: those of the case were kept."
        return
    yield "A size's driven inertia stands in place of the case's coupling_inertia."
    if case.present_driving_inertia is None:
        yield (
            "Its driving inertia was left out: the case does not say how much of "
            "engine_inertia is the present coupling's (driveline.coupling."
            "driving_inertia)."
        )
    else:
        yield (
            "Its driving inertia stands in place of the present coupling's "
            f"{case.present_driving_inertia:g} kg*m^2 within engine_inertia."
        )

"""Step 1: which coupling types carry the torque, and what stiffness each spans."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from coupling_design.checks.coupling import (
    size_criteria,
    torque_criteria,
)
from coupling_design.machine.candidate import Candidate
from coupling_design.machine.coupling_size import CouplingSize
from coupling_design.machine.coupling_type import CouplingType
from coupling_design.machine.machine import Case
from coupling_design.machine.words import Plan
from coupling_design.parts.criterion import Criterion, none_fails
from coupling_design.steps.so_far import AllowedType, FlowState, options_of
from coupling_design.steps.step_result import Alternative, Decision, StepResult

TITLE = "Coupling types"
QUESTION = "Which coupling types carry the torque, and what stiffness does each span?"


def determine_coupling_types(state: FlowState) -> FlowState:
    """Return the state with the types that carry torque and speed of the duty.

    A series of a catalogue goes on with those of its sizes that do.
    """
    case = state.case
    checked = [_check(case, each) for each in case.coupling_types]
    carrying = [each for each in checked if each.carried is not None]
    allowed = tuple(
        AllowedType(each.carried, each.carried.stiffness_range)
        for each in carrying
        if each.carried is not None
    )
    result = StepResult(
        step=1,
        title=TITLE,
        question=QUESTION,
        decision=Decision.PASS if carrying else Decision.FAIL,
        criteria=tuple(c for each in checked for c in each.criteria),
        alternatives=tuple(a for each in checked for a in each.alternatives),
        findings=tuple(_findings(checked)),
        caveats=tuple(_caveats(case)),
    )
    return state.after(
        result,
        elastic=tuple(a for a in allowed if a.coupling_type.plan is Plan.ELASTIC),
        stiff=tuple(a for a in allowed if a.coupling_type.plan is Plan.HIGH_STIFFNESS),
    )


def carrying_sizes(
    case: Case, coupling_type: CouplingType
) -> tuple[tuple[CouplingSize, tuple[Criterion, ...]], ...]:
    """Return the sizes of a series that carry the duty, each with its criteria.

    In the tightest connection, which no gap and no key makes softer.
    """
    checked = _size_criteria(case, coupling_type)
    return tuple((size, criteria) for size, criteria in checked if _all_pass(criteria))


@dataclass(frozen=True)
class _Checked:
    """A type or series: what is left of it, None if nothing, and why."""

    carried: CouplingType | None
    criteria: tuple[Criterion, ...]
    alternatives: tuple[Alternative, ...]


def _check(case: Case, coupling_type: CouplingType) -> _Checked:
    if coupling_type.sizes:
        return _check_series(case, coupling_type)
    criteria = torque_criteria(case, coupling_type)
    passes = _all_pass(criteria)
    alternative = Alternative(coupling_type.name, passes, None, _span(coupling_type))
    return _Checked(coupling_type if passes else None, criteria, (alternative,))


def _check_series(case: Case, series: CouplingType) -> _Checked:
    """Return the series of those sizes that carry.

    Shown against its limits is the smallest that carries, or else the largest there is.
    """
    checked = _size_criteria(case, series)
    left = [(size, criteria) for size, criteria in checked if _all_pass(criteria)]
    alternatives = tuple(_alternative(*pair) for pair in checked)
    if left:
        carried = series.with_sizes(tuple(size for size, _ in left))
        shown = min(left, key=lambda pair: pair[0].nominal_torque)
        whole = Alternative(series.name, True, None, _span(carried))
        return _Checked(carried, shown[1], (whole, *alternatives))
    shown = max(checked, key=lambda pair: pair[0].nominal_torque)
    whole = Alternative(series.name, False, None, "no size carries")
    return _Checked(None, shown[1], (whole, *alternatives))


def _size_criteria(
    case: Case, series: CouplingType
) -> tuple[tuple[CouplingSize, tuple[Criterion, ...]], ...]:
    tightest = Candidate(series, options_of(case, series)[-1])
    return tuple((size, size_criteria(case, tightest, size)) for size in series.sizes)


def _all_pass(criteria: tuple[Criterion, ...]) -> bool:
    return none_fails(criteria)


def _span(coupling_type: CouplingType) -> str:
    low, high = (stiffness / 1e6 for stiffness in coupling_type.stiffness_range)
    plan = coupling_type.plan.value.replace("_", " ")
    sizes = f", {len(coupling_type.sizes)} sizes" if coupling_type.sizes else ""
    return f"{plan} plan, {low:.4g} to {high:.4g} MN*m/rad{sizes}"


def _alternative(size: CouplingSize, criteria: tuple[Criterion, ...]) -> Alternative:
    stiffness = f"{size.torsional_stiffness / 1e6:.4g} MN*m/rad"
    failed = [c.name.partition(": ")[2] for c in criteria if c.fails]
    margins = [(c.margin, c.name) for c in criteria if c.margin is not None]
    margin, name = min(margins)
    told = (
        f"fails: {'; '.join(failed)}"
        if failed
        else f"least to spare, {margin:.0%}: {name.partition(': ')[2]}"
    )
    return Alternative(size.name, not failed, None, f"{stiffness}; {told}")


def _findings(checked: list[_Checked]) -> Iterator[str]:
    left = [each.carried for each in checked if each.carried is not None]
    yield (
        f"{len(left)} of {len(checked)} coupling types carry the torque and run at the "
        "highest working speed."
    )
    if any(len(each.alternatives) > 1 for each in checked):
        yield (
            "A series of the catalogue goes on with the sizes that carry; its limits "
            "are shown for the smallest of them, or for its largest where none does."
        )


def _caveats(case: Case) -> Iterator[str]:
    sizes = [size for each in case.coupling_types for size in each.sizes]
    if not sizes:
        return
    whose = (
        "Vibratory torque and power loss are those of a fired engine's orders"
        if case.works_fired
        else "Vibratory torque and power loss are those of the run-down's orders, "
        "without fuel: the fired engine's are larger, state them in duty.excitation"
    )
    yield f"{whose}; orders are added up with their crests together."
    if case.duty.short_circuit is not None:
        yield (
            "The short circuit's torque in the coupling is the bound for an air-gap "
            "torque that steps up and stays; of its parts at once and twice the grid's "
            "frequency a soft coupling takes less."
        )

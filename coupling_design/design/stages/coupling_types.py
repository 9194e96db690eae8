"""Step 1: which coupling types carry the torque, and what stiffness each spans."""

from __future__ import annotations

from coupling_design.case.case import Case, CouplingType, Plan
from coupling_design.design.results import (
    Alternative,
    Criterion,
    Decision,
    Sense,
    StepResult,
)
from coupling_design.design.state import AllowedType, FlowState

TITLE = "Coupling types"
QUESTION = "Which coupling types carry the torque, and what stiffness does each span?"


def determine_coupling_types(state: FlowState) -> FlowState:
    """Return the state with the types that carry torque and speed of the duty."""
    case = state.case
    checked = {t.name: torque_criteria(case, t) for t in case.coupling_types}
    carrying = tuple(
        AllowedType(t, t.stiffness_range)
        for t in case.coupling_types
        if all(criterion.passes for criterion in checked[t.name])
    )
    result = StepResult(
        step=1,
        title=TITLE,
        question=QUESTION,
        decision=Decision.PASS if carrying else Decision.FAIL,
        criteria=tuple(c for criteria in checked.values() for c in criteria),
        alternatives=tuple(
            _alternative(t, checked[t.name]) for t in case.coupling_types
        ),
        findings=(
            f"{len(carrying)} of {len(case.coupling_types)} coupling types carry the "
            "torque and run at the highest working speed.",
        ),
        caveats=(
            "Vibratory torque T_KW and power loss P_KV are not checked here: the case "
            "file gives neither.",
        ),
    )
    return state.after(
        result,
        elastic=tuple(a for a in carrying if a.coupling_type.plan is Plan.ELASTIC),
        stiff=tuple(a for a in carrying if a.coupling_type.plan is Plan.HIGH_STIFFNESS),
    )


def torque_criteria(case: Case, coupling_type: CouplingType) -> tuple[Criterion, ...]:
    """Return rated torque, peak torque and speed against what the type can take."""
    duty, name = case.duty, coupling_type.name
    return (
        _at_most(
            f"{name}: rated torque x service factor",
            duty.rated_torque * duty.service_factor,
            coupling_type.nominal_torque,
            "N*m",
            "nominal torque T_KN of the type",
        ),
        _at_most(
            f"{name}: peak torque",
            duty.peak_torque,
            coupling_type.maximum_torque,
            "N*m",
            "maximum torque T_Kmax of the type",
        ),
        _at_most(
            f"{name}: highest working speed",
            duty.working_speed[1],
            coupling_type.maximum_speed,
            "rad/s",
            "maximum speed of the type",
        ),
    )


def _at_most(
    name: str, value: float, limit: float, unit: str, source: str
) -> Criterion:
    return Criterion(
        name=name,
        value=value,
        limit=limit,
        sense=Sense.AT_MOST,
        unit=unit,
        passes=value <= limit,
        margin=1 - value / limit,
        source=source,
    )


def _alternative(
    coupling_type: CouplingType, criteria: tuple[Criterion, ...]
) -> Alternative:
    low, high = (stiffness / 1e6 for stiffness in coupling_type.stiffness_range)
    plan = coupling_type.plan.value.replace("_", " ")
    return Alternative(
        name=coupling_type.name,
        passes=all(criterion.passes for criterion in criteria),
        performance=None,
        remark=f"{plan} plan, {low:.4g} to {high:.4g} MN*m/rad",
    )

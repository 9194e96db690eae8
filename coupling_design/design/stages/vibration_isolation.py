"""Step 2: does the driveline stay isolated over the whole working speed range?"""

from __future__ import annotations

import math

from coupling_design.design.candidate import Candidate
from coupling_design.design.constraints import isolation_constraints
from coupling_design.design.performance import none_fails
from coupling_design.design.reach import reachable_stiffness
from coupling_design.design.results import Alternative, Decision, StepResult
from coupling_design.design.state import (
    AllowedType,
    FlowState,
    options_of,
)

TITLE = "Vibration isolation"
QUESTION = (
    "Is every excitation order more than sqrt 2 above the natural frequency, over the "
    "whole working speed range (soft plan)?"
)


def check_vibration_isolation(state: FlowState) -> FlowState:
    """Return the state with the elastic types left, at the stiffness that isolates."""
    limits = isolation_constraints(state.case)
    left = [(a, isolating_range(state, a)) for a in state.elastic]
    allowed = tuple(
        AllowedType(a.coupling_type, span) for a, span in left if span is not None
    )
    present = state.baseline.performance
    criteria = tuple(limit.criterion(present) for limit in limits)
    result = StepResult(
        step=2,
        title=TITLE,
        question=QUESTION,
        decision=Decision.PASS if allowed else Decision.FAIL,
        criteria=criteria,
        alternatives=tuple(_alternative(a, span) for a, span in left),
        findings=_findings(state, none_fails(criteria)),
        caveats=(
            "The natural frequency is that of the undamped driveline with the gap "
            "closed; an open gap lowers it for swings about zero torque.",
        ),
    )
    return state.after(result, elastic=allowed)


def isolating_range(
    state: FlowState, allowed: AllowedType
) -> tuple[float, float] | None:
    """Return the part of a type's stiffness [N m/rad] that isolates, None if none.

    In its tightest connection, where the natural frequency is highest.
    """
    tightest = options_of(state.case, allowed.coupling_type)[-1]
    evaluator = state.bench.evaluator(Candidate(allowed.coupling_type, tightest))
    return reachable_stiffness(
        evaluator, isolation_constraints(state.case), allowed.stiffness
    )


def _findings(state: FlowState, present_passes: bool) -> tuple[str, ...]:
    present = state.baseline.performance
    verdict = "is isolated" if present_passes else "is not isolated"
    lowest, highest = (w * 30 / math.pi for w in state.case.duty.working_speed)
    return (
        f"The present coupling, {present.natural_frequency:.2f} Hz, {verdict} from "
        f"every order between {lowest:.0f} and {highest:.0f} rpm.",
    )


def _alternative(allowed: AllowedType, span: tuple[float, float] | None) -> Alternative:
    if span is None:
        remark = "isolates at no stiffness of its range"
    else:
        low, high = (stiffness / 1e6 for stiffness in span)
        remark = f"isolates from {low:.4g} to {high:.4g} MN*m/rad"
    return Alternative(allowed.coupling_type.name, span is not None, None, remark)

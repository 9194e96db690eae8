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
    Span,
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
    left = [(a, isolating_ranges(state, a)) for a in state.elastic]
    allowed = tuple(
        narrowed for a, spans in left if (narrowed := _narrowed(a, spans)) is not None
    )
    present = state.baseline.performance
    criteria = tuple(limit.criterion(present) for limit in limits)
    result = StepResult(
        step=2,
        title=TITLE,
        question=QUESTION,
        decision=Decision.PASS if allowed else Decision.FAIL,
        criteria=criteria,
        alternatives=tuple(
            _alternative(candidate, span)
            for _, spans in left
            for candidate, span in spans
        ),
        findings=_findings(state, none_fails(criteria)),
        caveats=(
            "The natural frequency is that of the undamped driveline with the gap "
            "closed; an open gap lowers it for swings about zero torque.",
        ),
    )
    return state.after(result, elastic=allowed)


_Isolating = tuple[tuple[Candidate, Span | None], ...]


def isolating_ranges(state: FlowState, allowed: AllowedType) -> _Isolating:
    """Return the part of a type's stiffness [N m/rad] that isolates, None if none.

    In each connection it may have, the tightest last: there the natural frequency of a
    coupling is highest and the range smallest.
    """
    limits = isolation_constraints(state.case)
    candidates = [
        Candidate(allowed.coupling_type, option)
        for option in options_of(state.case, allowed.coupling_type)
    ]
    return tuple(
        (each, reachable_stiffness(state.bench.evaluator(each), limits, span))
        for each in candidates
        if (span := allowed.stiffness_in(each.connection.kind)) is not None
    )


def _narrowed(allowed: AllowedType, spans: _Isolating) -> AllowedType | None:
    """Return a type with what isolates, None if it does so in no connection."""
    left = [(each.connection.kind, span) for each, span in spans if span is not None]
    if not left:
        return None
    lows, highs = zip(*(span for _, span in left), strict=True)
    return AllowedType(allowed.coupling_type, (min(lows), max(highs)), tuple(left))


def _findings(state: FlowState, present_passes: bool) -> tuple[str, ...]:
    present = state.baseline.performance
    verdict = "is isolated" if present_passes else "is not isolated"
    lowest, highest = (w * 30 / math.pi for w in state.case.duty.working_speed)
    return (
        f"The present coupling, {present.natural_frequency:.2f} Hz, {verdict} from "
        f"every order between {lowest:.0f} and {highest:.0f} rpm.",
    )


def _alternative(candidate: Candidate, span: Span | None) -> Alternative:
    if span is None:
        remark = "isolates at no stiffness of its range"
    else:
        low, high = (stiffness / 1e6 for stiffness in span)
        remark = f"isolates from {low:.4g} to {high:.4g} MN*m/rad"
    return Alternative(candidate.label, span is not None, None, remark)

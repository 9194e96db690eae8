"""Step 2: does the driveline stay isolated over the whole working speed range?"""

from __future__ import annotations

import math
from collections.abc import Iterable

from coupling_design.machine.candidate import Candidate
from coupling_design.parts.criterion import none_fails
from coupling_design.search.reach import reachable_stiffness
from coupling_design.steps.limits import isolation_constraints
from coupling_design.steps.so_far import (
    AllowedType,
    FlowState,
    options_of,
)
from coupling_design.steps.step_result import Alternative, Decision, StepResult

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
        AllowedType(a.coupling_type, _hull(spans.values()))
        for a, spans in left
        if spans
    )
    present = state.baseline.performance
    criteria = tuple(limit.criterion(present) for limit in limits)
    result = StepResult(
        step=2,
        title=TITLE,
        question=QUESTION,
        decision=Decision.PASS if allowed else Decision.FAIL,
        criteria=criteria,
        alternatives=tuple(_alternative(a, spans) for a, spans in left),
        findings=_findings(state, none_fails(criteria)),
        caveats=(
            "The natural frequency is that of the undamped driveline with the gap "
            "closed; an open gap lowers it for swings about zero torque.",
        ),
    )
    return state.after(result, elastic=allowed)


def isolating_ranges(
    state: FlowState, allowed: AllowedType
) -> dict[str, tuple[float, float]]:
    """Return the part of a type's stiffness [N m/rad] that isolates, by connection.

    A key is a spring in series: with it a stiffer coupling still isolates. Connections
    in which no stiffness does are left out.
    """
    found = {}
    for option in options_of(state.case, allowed.coupling_type):
        evaluator = state.bench.evaluator(Candidate(allowed.coupling_type, option))
        span = reachable_stiffness(
            evaluator, isolation_constraints(state.case), allowed.stiffness
        )
        if span is not None:
            found[option.kind.value] = span
    return found


def _hull(spans: Iterable[tuple[float, float]]) -> tuple[float, float]:
    """Return what any connection allows; each keeps its own limit afterwards."""
    lows, highs = zip(*spans, strict=True)
    return min(lows), max(highs)


def _findings(state: FlowState, present_passes: bool) -> tuple[str, ...]:
    present = state.baseline.performance
    verdict = "is isolated" if present_passes else "is not isolated"
    lowest, highest = (w * 30 / math.pi for w in state.case.duty.working_speed)
    return (
        f"The present coupling, {present.natural_frequency:.2f} Hz, {verdict} from "
        f"every order between {lowest:.0f} and {highest:.0f} rpm.",
    )


def _alternative(
    allowed: AllowedType, spans: dict[str, tuple[float, float]]
) -> Alternative:
    by_span: dict[tuple[float, float], list[str]] = {}
    for kind, span in spans.items():
        by_span.setdefault(span, []).append(kind.replace("_", " "))
    told = [
        f"{' and '.join(kinds)}: {low / 1e6:.4g} to {high / 1e6:.4g} MN*m/rad"
        for (low, high), kinds in by_span.items()
    ]
    remark = f"isolates with {'; '.join(told)}" if told else "isolates at no stiffness"
    return Alternative(allowed.coupling_type.name, bool(spans), None, remark)

"""The maps that figures show, worked out once the design stands."""

from __future__ import annotations

from dataclasses import replace

from coupling_design.search.plane import Survey, survey
from coupling_design.search.program import DesignSpace, Objective
from coupling_design.search.workbench import problem
from coupling_design.steps.so_far import FlowState, Solution, gap_nearest_present
from coupling_design.steps.step_result import StepResult

# Gaps in the plane of the chosen coupling: one that no step of the flow needed.
_GAPS = 16


def chosen_plane(state: FlowState, solution: Solution) -> Survey | None:
    """Return the plane of the chosen coupling, None where a step has surveyed it.

    None too without machine code: a figure is not worth the wait then.
    """
    known = {plane.name for _, plane in state.surveys}
    if solution.candidate.label in known or not state.bench.is_compiled:
        return None
    option = solution.candidate.connection
    space = DesignSpace(
        solution.candidate.coupling_type.stiffness_range,
        (option.minimum_gap, gap_nearest_present(state.case, option)),
    )
    effort = replace(state.bench.effort, survey_gaps=_GAPS)
    bench = replace(state.bench, effort=effort)
    program = problem(
        bench, solution.candidate, space, Objective.DAMAGE, solution.constraints
    )
    return survey(bench, program)


def steps_with_maps(state: FlowState) -> tuple[StepResult, ...]:
    """Return the steps, each with the maps of its surveys, waiting for their rows."""
    return tuple(
        replace(
            step,
            maps=tuple(
                plane.design_map() for n, plane in state.surveys if n == step.step
            ),
        )
        for step in state.steps
    )

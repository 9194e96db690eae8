"""The run-downs and the plane that figures show, worked out once the design stands."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from coupling_design.arithmetic import FloatArray
from coupling_design.machine.machine import Case
from coupling_design.parts.bearing.contact_stress import minimum_load
from coupling_design.parts.bearing.damage import share_of_life
from coupling_design.parts.bearing.life import (
    basic_rating_life,
    life_modification_factor,
    modified_life,
)
from coupling_design.parts.bearing.loads import (
    combined_load,
    rotational_loads,
    static_loads,
)
from coupling_design.parts.bearing.lubrication import (
    contamination_factor,
    unclamped_viscosity_ratio,
)
from coupling_design.search.plane import Survey, survey
from coupling_design.search.program import DesignSpace, Objective
from coupling_design.search.workbench import problem
from coupling_design.signals.detrending import collision_force
from coupling_design.signals.history import History
from coupling_design.signals.resonance import largest_swing
from coupling_design.steps.so_far import FlowState, Solution, gap_nearest_present
from coupling_design.steps.step_result import StepResult
from coupling_design.wear.performance import Performance
from coupling_design.wear.signals import BearingHistory, RundownHistory

# Gaps in the plane of the chosen coupling: one that no step of the flow needed.
_GAPS = 16


def rundown_history(
    case: Case, label: str, history: History, performance: Performance, role: str
) -> RundownHistory:
    """Return a run-down with what the bearings bear in it.

    The run-down is the one whose peak decides. Its damage counts as in the flow: the
    last value is one of those whose mean `performance` has.
    """
    frequency = 2 * math.pi * float(performance.natural_frequency)
    force = collision_force(history, frequency)
    first, second = (_bearing_history(case, history, k) for k in range(2))
    return RundownHistory(
        role=role,
        label=label,
        driveline=history,
        force_trend=force.trend,
        collision_force=force.fluctuation,
        bearings=(first, second),
        resonance=largest_swing(history, frequency).time,
    )


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


def _bearing_history(case: Case, history: History, k: int) -> BearingHistory:
    bearing = case.bearings[k]
    speed, lubrication = history.generator_speed, case.lubrication
    load: FloatArray = combined_load(
        rotational_loads(history.transmission_force, case.shaft)[k],
        static_loads(case.shaft)[k],
        history.generator_angle + history.gravity_angle,
    )
    kappa = unclamped_viscosity_ratio(lubrication.viscosity, speed, bearing)
    e_c = contamination_factor(kappa, bearing.pitch_diameter, lubrication.cleanliness)
    a_iso = life_modification_factor(load, kappa, e_c, bearing)
    basic = basic_rating_life(load, bearing)
    # Of what has been worked out: each of these powers takes milliseconds.
    life = modified_life(a_iso, basic, case.reliability)
    return BearingHistory(
        combined_load=load,
        minimum_load=float(minimum_load(bearing)),
        viscosity_ratio=kappa,
        contamination_factor=e_c,
        life_modification_factor=a_iso,
        basic_rating_life=basic,
        modified_rating_life=life,
        damage=np.cumsum(share_of_life(speed, case.shutdown.time_step, life)),
    )

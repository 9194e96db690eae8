"""The present coupling in the present connection, as everything else is held to it."""

from __future__ import annotations

import math

import numpy as np

from coupling_design.line.modes import largest_stable_step
from coupling_design.machine.candidate import Candidate
from coupling_design.machine.machine import Case
from coupling_design.parts.bearing.lubrication import (
    VISCOSITY_RATIO_RANGE,
    unclamped_viscosity_ratio,
)
from coupling_design.search.workbench import Workbench
from coupling_design.signals.resonance import largest_swing, rest_time
from coupling_design.steps.baseline import Baseline
from coupling_design.steps.so_far import connection_option
from coupling_design.wear.conditioning import conditioning
from coupling_design.wear.evaluator import Evaluator
from coupling_design.wear.performance import Performance
from coupling_design.wear.sensitivity import sensitivity
from coupling_design.wear.signals import Rundown


def present_candidate(case: Case) -> Candidate:
    """Return the candidate that the machine has now."""
    present = next(
        t for t in case.coupling_types if t.name == case.present_coupling_type
    )
    option = connection_option(case, case.present_connection)
    stiffness = case.driveline.coupling.torsional_stiffness
    return Candidate(present, option, present.size_of(stiffness))


def evaluate_baseline(bench: Workbench) -> Baseline:
    """Return what the present coupling does."""
    case, candidate = bench.case, present_candidate(bench.case)
    evaluator = bench.evaluator(candidate)
    stiffness = case.driveline.coupling.torsional_stiffness
    gap = getattr(case.driveline.connection, "gap", 0.0)
    driveline = evaluator.driveline(stiffness, gap)
    performance = evaluator.performance(stiffness, gap)
    return Baseline(
        performance=performance,
        connection=candidate.connection.kind.value,
        coupling_type=candidate.coupling_type.name,
        rundown=rundown(evaluator, performance),
        conditioning=conditioning(evaluator, performance),
        time_step=case.shutdown.time_step,
        largest_stable_step=largest_stable_step(driveline),
        sensitivity=sensitivity(evaluator, performance),
    )


def rundown(evaluator: Evaluator, performance: Performance) -> Rundown:
    """Return how the run-down of one design point went, from its history."""
    case = evaluator.case
    driveline = case.driveline
    history = evaluator.history(performance.torsional_stiffness, performance.key_gap)
    swing = largest_swing(history, 2 * math.pi * performance.natural_frequency)
    ratio = unclamped_viscosity_ratio(
        case.lubrication.viscosity, history.generator_speed, case.bearings[0]
    )
    return Rundown(
        resonance_speed=swing.speed,
        resonance_swing=swing.amplitude,
        rest_time=rest_time(history, driveline.engine_resistance.transition_speed),
        revolutions=float(history.generator_angle[-1]) / (2 * math.pi),
        final_speed=float(history.generator_speed[-1]),
        out_of_range_time=float(
            np.count_nonzero(ratio < VISCOSITY_RATIO_RANGE[0]) * case.shutdown.time_step
        ),
    )

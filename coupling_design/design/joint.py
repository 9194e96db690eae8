"""Driveline and bearings in one step: the one place where the two meet.

The joint state is the driveline's, then TOTALS: both bearings' Miner sums and the
running peaks, so that memory does not grow with the number of steps and no maximum is
smoothed.
"""

from __future__ import annotations

import casadi as ca

from coupling_design.arithmetic import Scalar
from coupling_design.bearing.damage import damage_increment
from coupling_design.bearing.loads import (
    combined_load,
    rotational_loads,
    static_loads,
)
from coupling_design.case.case import Case
from coupling_design.driveline.dynamics import Motion, motion, state_names
from coupling_design.driveline.initial_state import quasi_steady_state
from coupling_design.driveline.parameters import Driveline
from coupling_design.rollout.runge_kutta import rk4_step

TOTALS = (
    "damage_1",
    "damage_2",
    "peak_transmission_force",
    "peak_combined_load_1",
    "peak_combined_load_2",
)


def joint_step(
    driveline: Driveline, case: Case, time_step: float, parameters: ca.SX
) -> ca.Function:
    """Return (joint state, parameters) -> joint state one time step [s] later.

    `driveline` holds the symbols in `parameters` where it varies; shaft, bearings and
    lubrication are the case's.
    """
    n = len(state_names(driveline))
    state, totals = ca.SX.sym("state", n), ca.SX.sym("totals", len(TOTALS))
    state_next = rk4_step(lambda y: motion(driveline, y).state_rate, state, time_step)
    totals_next = _add(totals, motion(driveline, state), case, time_step)
    return ca.Function(
        "step",
        [ca.vertcat(state, totals), parameters],
        [ca.cse(ca.vertcat(state_next, totals_next))],
        ["state", "parameters"],
        ["state_next"],
    )


def joint_start(
    driveline: Driveline, initial_speed: Scalar, parameters: ca.SX
) -> ca.Function:
    """Return parameters -> (joint state at the start, its Jacobian).

    `initial_speed` [rad/s] may be among the parameters.
    """
    state = quasi_steady_state(driveline, initial_speed)
    start = ca.vertcat(state, ca.SX.zeros(len(TOTALS)))
    return ca.Function(
        "start",
        [parameters],
        [start, ca.densify(ca.jacobian(start, parameters))],
        ["parameters"],
        ["state", "jacobian"],
    )


def _add(totals: Scalar, now: Motion, case: Case, time_step: float) -> Scalar:
    """Return the totals with the segment that starts now, eqs. (4)-(6), (13), (14)."""
    forces = rotational_loads(now.transmission_force, case.shaft)
    weights = static_loads(case.shaft)
    loads = [
        combined_load(force, weight, now.generator_angle)
        for force, weight in zip(forces, weights, strict=True)
    ]
    damages = [
        damage_increment(
            load,
            now.generator_speed,
            time_step,
            bearing,
            case.lubrication,
            case.reliability,
        )
        for load, bearing in zip(loads, case.bearings, strict=True)
    ]
    peaks = ca.vertcat(ca.fabs(now.transmission_force), *loads)
    return ca.vertcat(totals[:2] + ca.vertcat(*damages), ca.fmax(totals[2:], peaks))

"""Driveline and bearings in one step: the one place where the two meet.

The joint state is the driveline's, then what the run-down leaves behind (`quantities`),
so that memory does not grow with the number of steps and no maximum is smoothed.
"""

from __future__ import annotations

import casadi as ca

from coupling_design.events.shutdown import (
    closed_start,
    run_down_motion,
    run_down_state_names,
)
from coupling_design.line.motion import Motion
from coupling_design.line.parameters import Driveline, Shutdown
from coupling_design.machine.machine import Case
from coupling_design.march.runge_kutta import rk4_step
from coupling_design.parts.bearing.damage import damage_increment
from coupling_design.parts.bearing.loads import (
    combined_load,
    rotational_loads,
    static_loads,
)
from coupling_design.wear.quantities import QUANTITIES, TOTALS, Segment


def joint_step(
    driveline: Driveline,
    case: Case,
    time_step: float,
    parameters: ca.SX,
    shutdown: Shutdown | None = None,
) -> ca.Function:
    """Return (joint state, parameters) -> joint state one time step [s] later.

    `driveline` and `shutdown` hold the symbols in `parameters` where they vary, the
    latter the case's if not given; shaft, bearings and lubrication are the case's.
    """
    shutdown = shutdown or case.shutdown
    n = len(run_down_state_names(driveline, shutdown))
    state, totals = ca.SX.sym("state", n), ca.SX.sym("totals", len(TOTALS))
    state_next = rk4_step(
        lambda y: run_down_motion(driveline, shutdown, y).state_rate, state, time_step
    )
    now = run_down_motion(driveline, shutdown, state)
    segment = _segment(now, case, shutdown, time_step)
    totals_next = [
        quantity.gather(total, segment)
        for quantity, total in zip(QUANTITIES, ca.vertsplit(totals), strict=True)
    ]
    return ca.Function(
        "step",
        [ca.vertcat(state, totals), parameters],
        [ca.cse(ca.vertcat(state_next, *totals_next))],
        ["state", "parameters"],
        ["state_next"],
    )


def joint_start(
    driveline: Driveline,
    shutdown: Shutdown,
    parameters: ca.SX,
    n_varied: int | None = None,
) -> ca.Function:
    """Return parameters -> (joint state at the start, its Jacobian).

    The start is that of joints that stay closed; the Jacobian is to the first
    `n_varied` parameters, to all if not given.
    """
    start = ca.vertcat(closed_start(driveline, shutdown), ca.SX.zeros(len(TOTALS)))
    varied = parameters[:n_varied] if n_varied else parameters
    return ca.Function(
        "start",
        [parameters],
        [start, ca.densify(ca.jacobian(start, varied))],
        ["parameters"],
        ["state", "jacobian"],
    )


def _segment(now: Motion, case: Case, shutdown: Shutdown, time_step: float) -> Segment:
    """Return what acts in the step that starts now, eqs. (4)-(6), (13), (14)."""
    forces = rotational_loads(now.transmission_force, case.shaft)
    weights = static_loads(case.shaft)
    beta = now.generator_angle + (shutdown.gravity_angle - shutdown.crank_angle)
    loads = [
        combined_load(force, weight, beta)
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
    return Segment(now.transmission_force, loads, damages)

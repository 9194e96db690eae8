"""Driveline and bearings in one step: the one place where the two meet.

The joint state is the driveline's, then what the event leaves behind (`quantities`),
so that memory does not grow with the number of steps and no maximum is smoothed.
"""

from __future__ import annotations

import casadi as ca

from coupling_design.events.event import Event
from coupling_design.machine.machine import Case
from coupling_design.march.runge_kutta import rk4_step
from coupling_design.parts.bearing.damage import damage_increment
from coupling_design.parts.bearing.loads import combined_loads
from coupling_design.wear.quantities import QUANTITIES, TOTALS, Segment


def joint_step(
    event: Event, case: Case, parameters: ca.SX, time_step: float | None = None
) -> ca.Function:
    """Return (joint state, parameters) -> joint state one time step later.

    `event` holds the symbols in `parameters` (m,) where it varies; shaft, bearings and
    lubrication are the case's. `time_step` [s] is the event's own if not given. A joint
    state is (n_states + n_totals,).
    """
    time_step = time_step or event.time_step
    state = ca.SX.sym("state", len(event.state_names))
    totals = ca.SX.sym("totals", len(TOTALS))
    state_next = rk4_step(lambda y: event.motion(y).state_rate, state, time_step)
    segment = _segment(event, state, case, time_step)
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
    event: Event, parameters: ca.SX, n_varied: int | None = None
) -> ca.Function:
    """Return parameters -> (joint state at the start, its Jacobian).

    The start is that of joints that stay closed; the Jacobian (n, n_varied) is to the
    first `n_varied` parameters, to all if not given.
    """
    start = ca.vertcat(event.start(), ca.SX.zeros(len(TOTALS)))
    varied = parameters[:n_varied] if n_varied else parameters
    return ca.Function(
        "start",
        [parameters],
        [start, ca.densify(ca.jacobian(start, varied))],
        ["parameters"],
        ["state", "jacobian"],
    )


def _segment(event: Event, state: ca.SX, case: Case, time_step: float) -> Segment:
    """Return what acts in the step that starts now, eqs. (4)-(6), (13), (14)."""
    now = event.motion(state)
    beta = now.generator_angle + (event.gravity_angle - event.crank_angle)
    loads = combined_loads(now.transmission_force, beta, case.shaft)
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

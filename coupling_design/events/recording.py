"""One event in full: time histories of the driveline.

Sources
-------
[1] Advances in Mechanical Engineering 2023, doi 10.1177/16878132231190062, eq. (1).
"""

from __future__ import annotations

import casadi as ca
import numpy as np

from coupling_design.arithmetic import FloatArray
from coupling_design.errors import SimulationError
from coupling_design.events.event import Event
from coupling_design.events.shutdown import RunDown
from coupling_design.events.start import initial_state
from coupling_design.line.parameters import Driveline, Shutdown
from coupling_design.march.record import record
from coupling_design.march.runge_kutta import rk4_step
from coupling_design.signals.history import History


def simulate(driveline: Driveline, shutdown: Shutdown) -> History:
    """Return the history of a run-down from the shutdown's own start and crank angle.

    Its signals are (n_steps,). Raises SimulationError, saying when, if the rollout
    leaves finite numbers.
    """
    return record_event(
        RunDown(driveline, shutdown), initial_state(driveline, shutdown)
    )


def record_event(event: Event, start: FloatArray) -> History:
    """Return the history of an event of numbers from a state (n_states, 1).

    Its signals are (n_steps,). Raises SimulationError, saying when, if the rollout
    leaves finite numbers.
    """
    state = ca.SX.sym("state", len(event.state_names))
    none = ca.SX.sym("parameters", 0)
    state_next = rk4_step(lambda y: event.motion(y).state_rate, state, event.time_step)
    step = ca.Function("step", [state, none], [state_next])
    return history_of(event, record(step, event.n_steps, start, np.empty((0, 1))))


def history_of(event: Event, states: FloatArray) -> History:
    """Return the history that states at the start of every step tell.

    `states` (n_states, n_steps). Raises SimulationError, saying when, if they are not
    finite.
    """
    is_finite = np.isfinite(states).all(axis=0)
    if not is_finite.all():
        reached = float(np.argmin(is_finite)) * event.time_step
        raise SimulationError(
            f"the run-down left finite numbers by {reached:.4g} s, with a step of "
            f"{event.time_step:.3g} s. Take a smaller step, or a softer contact."
        )
    now = event.motion(states)
    return History(
        time=event.time_step * np.arange(states.shape[1], dtype=np.float64),
        transmission_force=now.transmission_force,
        coupling_torque=now.coupling_torque,
        engine_speed=now.engine_speed,
        generator_speed=now.generator_speed,
        generator_angle=now.generator_angle - event.crank_angle,
        crank_angle=float(event.crank_angle),
        gravity_angle=float(event.gravity_angle),
    )

"""One run-down in full: time histories of the driveline.

Sources
-------
[1] Advances in Mechanical Engineering 2023, doi 10.1177/16878132231190062, eq. (1).
"""

from __future__ import annotations

import casadi as ca
import numpy as np

from coupling_design.arithmetic import FloatArray
from coupling_design.errors import SimulationError
from coupling_design.events.shutdown import run_down_motion, run_down_state_names
from coupling_design.events.start import initial_state
from coupling_design.line.parameters import Driveline, Shutdown
from coupling_design.march.record import record
from coupling_design.march.runge_kutta import rk4_step
from coupling_design.signals.history import History


def simulate(driveline: Driveline, shutdown: Shutdown) -> History:
    """Return the history of a run-down from the shutdown's own start and crank angle.

    Raises SimulationError, saying when, if the rollout leaves finite numbers.
    """
    state = ca.SX.sym("state", len(run_down_state_names(driveline, shutdown)))
    none = ca.SX.sym("parameters", 0)
    state_next = rk4_step(
        lambda y: run_down_motion(driveline, shutdown, y).state_rate,
        state,
        shutdown.time_step,
    )
    step = ca.Function("step", [state, none], [state_next])
    start = initial_state(driveline, shutdown)
    states = record(step, shutdown.n_steps, start, np.empty((0, 1)))
    return history_of(driveline, shutdown, states)


def history_of(driveline: Driveline, shutdown: Shutdown, states: FloatArray) -> History:
    """Return the history that states at the start of every step tell, (n, n_steps).

    Raises SimulationError, saying when, if they are not finite.
    """
    is_finite = np.isfinite(states).all(axis=0)
    if not is_finite.all():
        reached = float(np.argmin(is_finite)) * shutdown.time_step
        raise SimulationError(
            f"the run-down left finite numbers by {reached:.4g} s, with a step of "
            f"{shutdown.time_step:.3g} s. Take a smaller step, or a softer contact."
        )
    now = run_down_motion(driveline, shutdown, states)
    time = shutdown.time_step * np.arange(states.shape[1], dtype=np.float64)
    return History(
        time=time,
        transmission_force=now.transmission_force,
        coupling_torque=now.coupling_torque,
        engine_speed=now.engine_speed,
        generator_speed=now.generator_speed,
        generator_angle=now.generator_angle - shutdown.crank_angle,
        crank_angle=float(shutdown.crank_angle),
        gravity_angle=float(shutdown.gravity_angle),
    )

"""One run-down in full: time histories of the driveline.

Sources
-------
[1] Advances in Mechanical Engineering 2023, doi 10.1177/16878132231190062, eq. (1).
"""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca
import numpy as np

from coupling_design.arithmetic import FloatArray
from coupling_design.driveline.dynamics import motion, state_names
from coupling_design.driveline.initial_state import quasi_steady_state
from coupling_design.driveline.parameters import Driveline, Shutdown
from coupling_design.errors import SimulationError
from coupling_design.rollout.recording import record
from coupling_design.rollout.runge_kutta import rk4_step


@dataclass(frozen=True)
class History:
    """Signals at the start of every step, each (n_steps,).

    Attributes
    ----------
    time : [s]
    transmission_force : F_c [N]
    coupling_torque : in the elastic part [N m]
    engine_speed, generator_speed : [rad/s]
    generator_angle : turned since the start [rad]
    """

    time: FloatArray
    transmission_force: FloatArray
    coupling_torque: FloatArray
    engine_speed: FloatArray
    generator_speed: FloatArray
    generator_angle: FloatArray


_SIGNALS = tuple(History.__dataclass_fields__)[1:]


def simulate(driveline: Driveline, shutdown: Shutdown) -> History:
    """Return the history of a run-down from its quasi-steady start.

    Raises SimulationError, saying when, if the rollout leaves finite numbers.
    """
    state = ca.SX.sym("state", len(state_names(driveline)))
    none = ca.SX.sym("parameters", 0)
    state_next = rk4_step(
        lambda y: motion(driveline, y).state_rate, state, shutdown.time_step
    )
    step = ca.Function("step", [state, none], [state_next])
    start = np.asarray(ca.DM(quasi_steady_state(driveline, shutdown.initial_speed)))
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
    now = motion(driveline, states)
    time = shutdown.time_step * np.arange(states.shape[1], dtype=np.float64)
    return History(time, *(getattr(now, name) for name in _SIGNALS))

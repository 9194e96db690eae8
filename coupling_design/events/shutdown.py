"""A shutdown as equations: what acts while the line runs down, and where it starts.

Its state is the driveline's; where the fuel is taken away over a time, that time is one
more entry.

Sources
-------
[1] Advances in Mechanical Engineering 2023, doi 10.1177/16878132231190062, eq. (1).
"""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca
import numpy as np

from coupling_design.arithmetic import Scalar, maximum, stacked
from coupling_design.events.settled_state import settled_state
from coupling_design.line.even_start import (
    all_resistances,
    quasi_steady_state,
)
from coupling_design.line.motion import Motion, inertias, motion, state_names
from coupling_design.line.parameters import (
    Driveline,
    FuelCutStart,
    QuasiSteadyStart,
    Shutdown,
)

_TIME = "time"


@dataclass(frozen=True)
class RunDown:
    """A shutdown of a line: the first kind of `event.Event`."""

    driveline: Driveline
    shutdown: Shutdown

    @property
    def state_names(self) -> tuple[str, ...]:
        """The driveline's, then the time [s] where the fuel goes over one."""
        names = state_names(self.driveline)
        return (*names, _TIME) if self.shutdown.fuel_cut_time else names

    @property
    def time_step(self) -> float:
        """The time step [s]."""
        return self.shutdown.time_step

    @property
    def n_steps(self) -> int:
        """The number of steps."""
        return self.shutdown.n_steps

    @property
    def crank_angle(self) -> Scalar:
        """The crank angle when the fuel goes off [rad]."""
        return self.shutdown.crank_angle

    @property
    def gravity_angle(self) -> Scalar:
        """The angle to gravity when the fuel goes off [rad]."""
        return self.shutdown.gravity_angle

    def motion(self, state: Scalar) -> Motion:
        """Return the motion at a state (n_states,), or an array (n_states, n_steps)."""
        line, tau = self.driveline, self.shutdown.fuel_cut_time
        if not tau:
            return motion(line, state)
        n = len(state_names(line))
        time = state[n]
        left = maximum(1 - time / tau, 0.0)
        moved = motion(line, state[:n], left * fuel_torque(line, self.shutdown))
        return _with_rate(moved, _joined(moved.state_rate, time * 0 + 1.0))

    def start(self) -> Scalar:
        """Return the state at t = 0 (n_states,), a CasADi expression, joints closed.

        What a settled start is where the gap opens, `periodic_orbit` says.
        """
        line, shutdown = self.driveline, self.shutdown
        speed, crank = shutdown.initial_speed, shutdown.crank_angle
        if isinstance(shutdown.start, QuasiSteadyStart):
            turned = ca.DM(quasi_turn(line))
            state = quasi_steady_state(line, speed) + turned * crank
        else:
            fuel = fuel_torque(line, shutdown)
            state = settled_state(line, speed, crank, fuel)
        return ca.vertcat(state, 0.0) if shutdown.fuel_cut_time else state


def fuel_torque(driveline: Driveline, shutdown: Shutdown) -> Scalar:
    """Return the mean torque of the fuel before t = 0 [N m]; 0 without fuel."""
    if isinstance(shutdown.start, FuelCutStart):
        return all_resistances(driveline, shutdown.initial_speed)
    return 0.0


def quasi_turn(driveline: Driveline) -> list[float]:
    """Return 1 for each angle of the driveline's state, 0 for each speed.

    As many as the driveline has states (n_states,), the time not among them.
    """
    n = len(inertias(driveline))
    return [1.0] * n + [0.0] * n


def _with_rate(moved: Motion, state_rate: Scalar) -> Motion:
    return Motion(**{**vars(moved), "state_rate": state_rate})


def _joined(rates: Scalar, last: Scalar) -> Scalar:
    if isinstance(rates, np.ndarray):
        return np.vstack([rates, last])
    return stacked(*ca.vertsplit(rates), last)

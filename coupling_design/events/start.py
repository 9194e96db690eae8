"""The states that run-downs start from, at values of what varies between them."""

from __future__ import annotations

import os
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import cached_property

import casadi as ca
import numpy as np

from coupling_design.arithmetic import FloatArray
from coupling_design.events.held_line import HeldLine
from coupling_design.events.lift_off import LiftOff
from coupling_design.events.periodic_orbit import PeriodicOrbit
from coupling_design.events.settled_state import period_of
from coupling_design.events.shutdown import RunDown
from coupling_design.line.parameters import (
    Driveline,
    QuasiSteadyStart,
    Shutdown,
)

_SLOWEST = 0.9  # of the nominal speed; it sets the number of steps in a period


@dataclass(frozen=True)
class Starts:
    """Where run-downs start, a column each.

    Attributes
    ----------
    states : (n_states, b)
    slopes : to the varied parameters (b, n_states, n_varied)
    repeats : of each group of crank angles, whether the vibration is periodic
    """

    states: FloatArray
    slopes: FloatArray
    repeats: tuple[bool, ...]


class StartingStates:
    """Finds the states at t = 0: linear where joints stay closed, else by an orbit.

    Parameters
    ----------
    driveline, shutdown : of values and of the symbols in `parameters`
    parameters : symbols (m,), the first `n_varied` of which slopes are wanted to
    speed : nominal initial speed [rad/s]; none 10 % slower will be asked for
    """

    def __init__(
        self,
        driveline: Driveline,
        shutdown: Shutdown,
        parameters: ca.SX,
        n_varied: int,
        speed: float,
    ) -> None:
        self._line, self._shutdown, self._p = driveline, shutdown, parameters
        self._n_varied, self._slowest = n_varied, _SLOWEST * speed

    def closed(self, columns: FloatArray) -> FloatArray:
        """Return the states (n, b) for parameters (m, b), as if no gap opened."""
        return np.asarray(self._closed(columns)[0], dtype=float)

    def __call__(
        self, columns: FloatArray, n_angles: int, *, with_slopes: bool = False
    ) -> Starts:
        """Return the states for parameters (m, b).

        Columns come in groups of `n_angles`, which differ in the crank angle alone and
        spread it evenly over the orders' period. Without slopes these are zero.
        """
        groups = columns.shape[1] // n_angles
        states = self.closed(columns)
        slopes = np.zeros((columns.shape[1], len(states), self._n_varied))
        if with_slopes:
            slopes = np.stack(
                [
                    np.asarray(self._closed(column)[1], dtype=float)
                    for column in columns.T
                ]
            )
        repeats = [True] * groups
        firsts = [columns[:, i * n_angles] for i in range(groups)]
        opening = [i for i, values in enumerate(firsts) if self._opens(values)]
        if not opening:
            return Starts(states, slopes, tuple(repeats))
        self._orbit.prepare(n_angles)  # built before threads share it
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            found = pool.map(
                lambda i: self._orbit.settle(
                    firsts[i], n_angles, with_slopes=with_slopes
                ),
                opening,
            )
            for i, settled in zip(opening, found, strict=True):
                mine = slice(i * n_angles, (i + 1) * n_angles)
                n = len(settled.states)
                states[:n, mine] = settled.states
                slopes[mine, :n] = settled.slopes
                repeats[i] = settled.repeats
        return Starts(states, slopes, tuple(repeats))

    def _opens(self, values: FloatArray) -> bool:
        if isinstance(self._shutdown.start, QuasiSteadyStart):
            return False
        return self._lift_off.happens(values)

    @cached_property
    def _closed(self) -> ca.Function:
        start = RunDown(self._line, self._shutdown).start()
        slopes = ca.jacobian(start, self._p[: self._n_varied])
        return ca.Function("start", [self._p], [start, ca.densify(slopes)])

    @cached_property
    def _lift_off(self) -> LiftOff:
        return LiftOff(self._line, self._shutdown, self._p)

    @cached_property
    def _orbit(self) -> PeriodicOrbit:
        held = HeldLine(self._line, self._shutdown, self._p, self._n_varied)
        period = period_of(self._line.excitation)
        return PeriodicOrbit(held, period, self._slowest)


def initial_state(driveline: Driveline, shutdown: Shutdown) -> FloatArray:
    """Return the state at t = 0 (n_states, 1) of a run-down of numbers."""
    speed = float(shutdown.initial_speed)
    starting = StartingStates(driveline, shutdown, ca.SX.sym("none", 0), 0, speed)
    return starting(np.empty((0, 1)), 1).states

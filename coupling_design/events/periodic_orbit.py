"""The settled vibration of a line whose gap opens: a periodic orbit, by shooting.

The held line is marched over one period of the orders; Newton's method, on the march's
exact derivatives, finds the state that comes back to itself [1], and the same
derivatives say how it moves with the design variables. Where there is no such state,
or none that lasts, the line is marched for many periods instead.

Sources
-------
[1] Nayfeh, Balachandran (1995), Applied Nonlinear Dynamics, 6.5: shooting; 3.2: Floquet
    multipliers, none outside the unit circle where an orbit lasts.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import casadi as ca
import numpy as np

from coupling_design.arithmetic import FloatArray
from coupling_design.events.held_line import HeldLine
from coupling_design.march.fastest import fastest_marcher
from coupling_design.march.marcher import Marcher

# A march cut in so many pieces keeps what is between: the angles are read off it.
_FEWEST_PIECES = 8
_NEWTON_STEPS, _CLOSED = 25, 1e-11
# Multipliers of 1 belong to the line turned as a whole, and to its mean speed.
_LASTING = 1 + 1e-4
# In place of an orbit; a coupling with 1 % of critical damping at half of the lowest
# order's frequency has by then lost all but e^-6 of where it began.
_MARCHED_PERIODS = 200
# Newton's matrix is made anew where a step leaves more than this of what it missed, and
# multipliers where they were made further than this from the orbit, scaled.
_SLOW, _SAME = 0.3, 1e-3
_NULL = 1e-10  # singular values below this, relative, belong to the line as a whole


@dataclass(frozen=True)
class SettledVibration:
    """The settled state at evenly spread crank angles.

    Attributes
    ----------
    states : (n_states, n_angles)
    slopes : to the varied parameters (n_angles, n_states, n_varied); zero where the
        vibration does not repeat, as it has none then
    repeats : whether it is periodic with the orders
    """

    states: FloatArray
    slopes: FloatArray
    repeats: bool


@dataclass(frozen=True)
class _Turn:
    """One period: states (n, pieces + 1), slopes to start and to what is varied."""

    states: FloatArray
    to_start: FloatArray
    to_varied: FloatArray


class PeriodicOrbit:
    """Finds the settled vibration of a held line at values of its parameters.

    Parameters
    ----------
    line : held
    period : crank angle after which the orders repeat [rad]
    speed : slowest mean speed asked for, which has the most steps [rad/s]
    """

    def __init__(self, line: HeldLine, period: float, speed: float) -> None:
        self._line, self._period, self._speed = line, period, speed
        self._marches: dict[tuple[int, bool], ca.Function] = {}
        self._long: dict[int, Marcher] = {}

    def prepare(self, n_angles: int) -> None:
        """Build what `settle` needs, so that threads may share it."""
        _ = self._guess, self._crank
        for with_slopes in (False, True):
            self._piece(_pieces(n_angles), with_slopes=with_slopes)

    def settle(
        self, values: FloatArray, n_angles: int, *, with_slopes: bool
    ) -> SettledVibration:
        """Return the settled states at parameter values (m,).

        The first angle is that of the values, the others follow over one period.
        """
        pieces = _pieces(n_angles)
        found = self._orbit(values, pieces, with_slopes=with_slopes)
        every = pieces // n_angles
        if found is not None:
            states, slopes = found
            return SettledVibration(states[:, :-1:every], slopes[:-1:every], True)
        states = self._marched(values, pieces)
        slopes = np.zeros((n_angles, self._line.n_states, self._line.n_varied))
        return SettledVibration(states[:, :-1:every], slopes, repeats=False)

    def _orbit(
        self, values: FloatArray, pieces: int, *, with_slopes: bool
    ) -> tuple[FloatArray, FloatArray] | None:
        """Return states and slopes of a lasting orbit, None if there is none.

        Newton's matrix is kept while it serves: it costs as much as eight turns.
        """
        start = self._start(values)
        system: FloatArray | None = None
        before = np.inf
        for _ in range(_NEWTON_STEPS):
            if system is None:
                turn = self._turn_with_slopes(start, values, pieces)
                system, made_at = turn.to_start[-1], start
                states = turn.states
            else:
                states = self._turn(start, values, pieces)
            miss = (states[:, -1] - start - self._whole) / self._scale
            missed = float(np.abs(miss).max())
            if not np.isfinite(missed):
                return None
            if missed < _CLOSED:
                near = np.abs((start - made_at) / self._scale).max() < _SAME
                if with_slopes or not near:
                    turn = self._turn_with_slopes(start, values, pieces)
                return self._lasting(turn, states)
            if missed > _SLOW * before:
                system = None  # no longer good enough; the next is made here
                before = np.inf
                continue
            start = start + self._step(system, miss)
            before = missed
        return None

    def _lasting(
        self, turn: _Turn, states: FloatArray
    ) -> tuple[FloatArray, FloatArray] | None:
        if np.abs(np.linalg.eigvals(turn.to_start[-1])).max() > _LASTING:
            return None
        scale = self._scale[:, np.newaxis]
        first = -scale * self._solve(turn.to_start[-1], turn.to_varied[-1] / scale)
        return states, turn.to_start @ first + turn.to_varied

    def _step(self, to_start: FloatArray, miss: FloatArray) -> FloatArray:
        step: FloatArray = -self._scale * self._solve(to_start, miss)
        return step

    def _solve(self, to_start: FloatArray, right: FloatArray) -> FloatArray:
        """Return the least scaled step that answers (M - 1) step = right.

        Turned as a whole the line is the same: the least step leaves that alone.
        """
        scale = self._scale
        back = (to_start - np.eye(len(scale))) * scale / scale[:, np.newaxis]
        return np.asarray(np.linalg.lstsq(back, right, rcond=_NULL)[0], dtype=float)

    def _marched(self, values: FloatArray, pieces: int) -> FloatArray:
        """Return the states over the last of many turns."""
        march, parameters = self._long_march(pieces), self._padded(values)
        start = np.array([*self._start(values), float(self._crank(values)[0])])
        end = march(start[:, np.newaxis], parameters[:, np.newaxis], 1)
        settled = end.ravel()[:-1] - _MARCHED_PERIODS * self._whole
        return self._turn(settled, values, pieces)

    def _long_march(self, pieces: int) -> Marcher:
        if pieces not in self._long:
            step, steps = self._line.step(self._period / pieces, self._speed)
            n_steps = _MARCHED_PERIODS * pieces * steps
            self._long[pieces] = fastest_marcher(step, n_steps)
        return self._long[pieces]

    def _padded(self, values: FloatArray) -> FloatArray:
        return np.concatenate([values, np.zeros(self._line.n_states)])

    def _start(self, values: FloatArray) -> FloatArray:
        return np.asarray(self._guess(values)[0], dtype=float).ravel()

    def _turn(self, start: FloatArray, values: FloatArray, pieces: int) -> FloatArray:
        """Return the states over one period (n, pieces + 1)."""
        crank = float(self._crank(values)[0])
        march = self._piece(pieces, with_slopes=False)
        parameters = self._padded(values)
        passed = [np.array([*start, crank])]
        for _ in range(pieces):
            end = march(passed[-1], parameters)
            passed.append(np.asarray(end, dtype=float).ravel())
        return np.stack(passed, axis=1)[:-1]

    def _turn_with_slopes(
        self, start: FloatArray, values: FloatArray, pieces: int
    ) -> _Turn:
        crank, crank_slopes = (np.asarray(part, float) for part in self._crank(values))
        n, v = self._line.n_states, crank_slopes.size
        joint = np.zeros((n + 1, 1 + v + n))
        joint[:, 0] = [*start, *crank.ravel()]
        joint[n, 1 : 1 + v] = crank_slopes.ravel()
        joint[:n, 1 + v :] = np.eye(n)
        march = self._piece(pieces, with_slopes=True)
        parameters = self._padded(values)
        passed = [joint]
        for _ in range(pieces):
            end = march(passed[-1].ravel(order="F"), parameters)
            passed.append(np.asarray(end, float).reshape(joint.shape, order="F"))
        at = np.stack(passed)
        return _Turn(at[:, :n, 0].T, at[:, :n, 1 + v :], at[:, :n, 1 : 1 + v])

    def _piece(self, pieces: int, *, with_slopes: bool) -> ca.Function:
        key = pieces, with_slopes
        if key not in self._marches:
            self._marches[key] = self._line.march_over(
                self._period / pieces, self._speed, with_slopes=with_slopes
            )
        return self._marches[key]

    @cached_property
    def _guess(self) -> ca.Function:
        return self._line.guess()

    @cached_property
    def _crank(self) -> ca.Function:
        return self._line.crank()

    @cached_property
    def _whole(self) -> FloatArray:
        """By how much the state grows in a period: each angle by as much."""
        half = self._line.n_states // 2
        return np.array([self._period] * half + [0.0] * half)

    @cached_property
    def _scale(self) -> FloatArray:
        half = self._line.n_states // 2
        return np.array([1.0] * half + [self._speed] * half)


def _pieces(n_angles: int) -> int:
    """Return in how many pieces a period is marched, a multiple of the angles."""
    return n_angles * -(-_FEWEST_PIECES // n_angles)

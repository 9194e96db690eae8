"""What one design point does: the one place where driveline and bearings meet.

A point is (torsional stiffness [N m/rad], key gap [m]). One rollout carries the
driveline's state, both bearings' Miner sums and the running peaks through every step,
so memory does not grow with the number of steps and nothing is smoothed.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import cached_property

import casadi as ca
import numpy as np

from coupling_design.arithmetic import FloatArray, Scalar
from coupling_design.bearing.damage import damage_increment
from coupling_design.bearing.loads import (
    combined_load,
    rotational_loads,
    static_loads,
)
from coupling_design.case.case import Case
from coupling_design.design.candidate import Candidate, candidate_driveline
from coupling_design.design.results import Performance
from coupling_design.driveline.dynamics import Motion, motion, state_names
from coupling_design.driveline.initial_state import quasi_steady_state
from coupling_design.driveline.modes import natural_angular_frequency
from coupling_design.driveline.parameters import Driveline
from coupling_design.errors import SimulationError
from coupling_design.rollout.march import march
from coupling_design.rollout.runge_kutta import rk4_step
from coupling_design.rollout.sensitivities import (
    join_sensitivities,
    with_sensitivities,
)

# What a rollout adds up, in the order of its state's last entries.
TOTALS = (
    "damage_1",
    "damage_2",
    "peak_transmission_force",
    "peak_combined_load_1",
    "peak_combined_load_2",
)

_THREADS = 2


class Evaluator:
    """Rollouts of one candidate of a case, with exact gradients.

    Everything symbolic is built at first use. `refinement` divides the time step.
    """

    def __init__(self, case: Case, candidate: Candidate, refinement: int = 1) -> None:
        self.case = case
        self.candidate = candidate
        self.refinement = refinement
        self.rollouts = 0
        self._known: dict[tuple[float, float], tuple[FloatArray, FloatArray]] = {}

    def driveline(self, torsional_stiffness: Scalar, key_gap: Scalar) -> Driveline:
        """Return the driveline at a design point, values or symbols."""
        return candidate_driveline(
            self.case, self.candidate, torsional_stiffness, key_gap
        )

    def natural_frequency(self, torsional_stiffness: Scalar) -> Scalar:
        """Return the lowest natural frequency with the gap closed [Hz]."""
        driveline = self.driveline(torsional_stiffness, 0.0)
        return natural_angular_frequency(driveline) / (2 * math.pi)

    def performance(
        self, torsional_stiffness: float, key_gap: float, start_offset: float = 0.0
    ) -> Performance:
        """Return what a run-down does at a point.

        `start_offset` [rad] turns the crank before the start, to see how far a result
        depends on it. Raises SimulationError where the rollout leaves finite numbers.
        """
        point = ca.DM([torsional_stiffness, key_gap])
        start = self._start(point)
        start[0] += start_offset
        self.rollouts += 1
        end = np.asarray(self._march(start, point)).ravel()
        totals = end[-len(TOTALS) :]
        self._check_finite(totals, torsional_stiffness, key_gap)
        return self.read(torsional_stiffness, key_gap, totals.tolist())

    def outline(self, torsional_stiffness: float, key_gap: float = 0.0) -> Performance:
        """Return a performance that is known without a rollout, its loads left zero."""
        return self.read(torsional_stiffness, key_gap, [0.0] * len(TOTALS))

    def performances(
        self, points: Sequence[tuple[float, float]]
    ) -> tuple[Performance, ...]:
        """Return the performances at many points, in their order."""
        _ = self._march, self._start  # built once, before the threads ask for them
        with ThreadPoolExecutor(_THREADS) as pool:
            return tuple(pool.map(lambda point: self.performance(*point), points))

    def totals_and_jacobian(
        self, torsional_stiffness: float, key_gap: float
    ) -> tuple[FloatArray, FloatArray]:
        """Return TOTALS (5,) and their exact derivatives (5, 2) to the two variables.

        The last rollouts are kept, so that a solver's separate questions about
        objective, constraints and their gradients cost one rollout.
        """
        key = (torsional_stiffness, key_gap)
        if key not in self._known:
            if len(self._known) > 64:
                self._known.clear()
            self._known[key] = self._roll_with_jacobian(*key)
        return self._known[key]

    def read(
        self, torsional_stiffness: Scalar, key_gap: Scalar, totals: Scalar
    ) -> Performance:
        """Return the performance that `totals` describe, numbers or symbols."""
        return Performance(
            torsional_stiffness=torsional_stiffness,
            key_gap=key_gap,
            natural_frequency=self.natural_frequency(torsional_stiffness),
            damages=(totals[0], totals[1]),
            peak_transmission_force=totals[2],
            peak_combined_load=(totals[3], totals[4]),
        )

    def _roll_with_jacobian(
        self, torsional_stiffness: float, key_gap: float
    ) -> tuple[FloatArray, FloatArray]:
        point = ca.DM([torsional_stiffness, key_gap])
        start = join_sensitivities(self._start(point), self._start_jacobian(point))
        self.rollouts += 1
        end = np.asarray(self._march_with_sensitivities(start, point))
        columns = end.reshape(3, -1)[:, -len(TOTALS) :]
        self._check_finite(columns, torsional_stiffness, key_gap)
        return columns[0], columns[1:].T

    def _check_finite(
        self, values: FloatArray, torsional_stiffness: float, key_gap: float
    ) -> None:
        if not np.isfinite(values).all():
            raise SimulationError(
                self._describe_divergence(torsional_stiffness, key_gap)
            )

    def _describe_divergence(self, torsional_stiffness: float, key_gap: float) -> str:
        point = ca.DM([torsional_stiffness, key_gap])
        state, steps, chunk = self._start(point), 0, max(self._n_steps // 1000, 1)
        advance = march(self._step, chunk)
        while steps < self._n_steps and np.isfinite(np.asarray(state)).all():
            state, steps = advance(state, point), steps + chunk
        return (
            f"{self.case.file}: the run-down of {self.candidate.label} at "
            f"{torsional_stiffness:.6g} N*m/rad and a gap of {key_gap * 1e3:.4g} mm "
            f"left finite numbers by {steps * self._time_step:.4g} s, with a step of "
            f"{self._time_step:.3g} s. Take a smaller shutdown.time_step, or a softer "
            "contact."
        )

    @cached_property
    def refined(self) -> Evaluator:
        """The same rollouts with half the time step."""
        return Evaluator(self.case, self.candidate, 2 * self.refinement)

    @property
    def _time_step(self) -> float:
        return self.case.shutdown.time_step / self.refinement

    @property
    def _n_steps(self) -> int:
        return self.case.shutdown.n_steps * self.refinement

    @cached_property
    def _start(self) -> ca.Function:
        point = ca.SX.sym("point", 2)
        driveline = self.driveline(*ca.vertsplit(point))
        start = quasi_steady_state(driveline, self.case.shutdown.initial_speed)
        totals = ca.SX.zeros(len(TOTALS))
        return ca.Function("start", [point], [ca.vertcat(start, totals)])

    @cached_property
    def _start_jacobian(self) -> ca.Function:
        point = ca.SX.sym("point", 2)
        return ca.Function(
            "start_jacobian", [point], [ca.jacobian(self._start(point), point)]
        )

    @cached_property
    def _step(self) -> ca.Function:
        """One step of the joint state: driveline, then TOTALS."""
        point = ca.SX.sym("point", 2)
        driveline = self.driveline(*ca.vertsplit(point))
        n = len(state_names(driveline))
        state, totals = ca.SX.sym("state", n), ca.SX.sym("totals", len(TOTALS))
        state_next = rk4_step(
            lambda y: motion(driveline, y).state_rate, state, self._time_step
        )
        totals_next = self._add(totals, motion(driveline, state))
        return ca.Function(
            "step",
            [ca.vertcat(state, totals), point],
            [ca.cse(ca.vertcat(state_next, totals_next))],
            ["state", "parameters"],
            ["state_next"],
        )

    def _add(self, totals: Scalar, now: Motion) -> Scalar:
        """Return the totals with the segment that starts now, eqs. (4)-(6), (14)."""
        case = self.case
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
                self._time_step,
                bearing,
                case.lubrication,
                case.reliability,
            )
            for load, bearing in zip(loads, case.bearings, strict=True)
        ]
        peaks = ca.vertcat(ca.fabs(now.transmission_force), *loads)
        return ca.vertcat(totals[:2] + ca.vertcat(*damages), ca.fmax(totals[2:], peaks))

    @cached_property
    def _march(self) -> ca.Function:
        return march(self._step, self._n_steps)

    @cached_property
    def _march_with_sensitivities(self) -> ca.Function:
        return march(with_sensitivities(self._step), self._n_steps)

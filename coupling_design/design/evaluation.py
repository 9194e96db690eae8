"""What one design point does, and how that changes with stiffness and gap.

A point is (torsional stiffness [N m/rad], key gap [m]).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import cached_property, partial

import casadi as ca
import numpy as np

from coupling_design.arithmetic import FloatArray, Scalar
from coupling_design.case.case import Case
from coupling_design.design.candidate import Candidate, candidate_driveline
from coupling_design.design.joint import TOTALS, joint_start, joint_step
from coupling_design.design.performance import Performance, performance_of
from coupling_design.driveline.history import History, history_of
from coupling_design.driveline.modes import natural_angular_frequency
from coupling_design.driveline.parameters import Driveline
from coupling_design.errors import SimulationError
from coupling_design.rollout.compiled.march import start_compiling
from coupling_design.rollout.divergence import steps_to_divergence
from coupling_design.rollout.fastest import fastest_marcher
from coupling_design.rollout.marcher import Marcher
from coupling_design.rollout.sensitivities import (
    join_sensitivities,
    with_sensitivities,
)

_REMEMBERED = 64  # gradients: a solver asks at most a few times in a row
_HISTORIES = 2


class Evaluator:
    """Rollouts of one candidate of a case, with exact gradients.

    Everything symbolic is built at first use. `refinement` divides the time step,
    `coarsening` multiplies it: the latter must divide the number of steps.
    """

    def __init__(
        self, case: Case, candidate: Candidate, refinement: int = 1, coarsening: int = 1
    ) -> None:
        self.case, self.candidate = case, candidate
        self.refinement, self.coarsening = refinement, coarsening
        self.rollouts = 0
        self._coarser: dict[int, Evaluator] = {}
        self._performances: dict[float, dict[tuple[float, float], Performance]] = {}
        self._histories: dict[tuple[float, float], History] = {}
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
        return self.performances([(torsional_stiffness, key_gap)], start_offset)[0]

    def performances(
        self, points: Sequence[tuple[float, float]], start_offset: float = 0.0
    ) -> tuple[Performance, ...]:
        """Return the performances at many points, in their order.

        Each is rolled out once and kept: again it would be the same to the last bit.
        """
        known = self._performances.setdefault(start_offset, {})
        new = [point for point in dict.fromkeys(points) if point not in known]
        if new:
            ends = self.prepare(new, start_offset)(None)
            known.update(zip(new, self.performances_of(new, ends), strict=True))
        return tuple(known[point] for point in points)

    def prepare(
        self, points: Sequence[tuple[float, float]], start_offset: float = 0.0
    ) -> Callable[[int | None], FloatArray]:
        """Return what rolls out many points with so many threads, to their ends.

        Everything else is done here, and counted: what is returned is the march alone,
        which touches nothing that another thread may be building.
        """
        columns = np.asarray(points, dtype=np.float64).T
        starts = np.asarray(self._start(columns)[0])
        starts[0] += start_offset
        self.rollouts += len(points)
        return partial(self._march, starts, columns)

    def performances_of(
        self, points: Sequence[tuple[float, float]], ends: FloatArray
    ) -> tuple[Performance, ...]:
        """Return the performances at points whose rollouts ended so."""
        frequencies = self.natural_frequency(np.array([k for k, _ in points])).tolist()
        found = []
        columns = ends[-len(TOTALS) :].T
        for point, f, totals in zip(points, frequencies, columns, strict=True):
            self._check_finite(totals, *point)
            found.append(performance_of(*point, f, totals.tolist()))
        return tuple(found)

    def history(self, torsional_stiffness: float, key_gap: float) -> History:
        """Return the run-down at a point in full; the last two asked for are kept.

        Raises SimulationError where the rollout leaves finite numbers.
        """
        point = (torsional_stiffness, key_gap)
        if point not in self._histories:
            if len(self._histories) >= _HISTORIES:
                self._histories.clear()
            column = np.asarray(point, dtype=np.float64)[:, np.newaxis]
            start = np.asarray(self._start(column)[0])
            states = self._march.record(start, column)[: -len(TOTALS)]
            shutdown = replace(self.case.shutdown, time_step=self.time_step)
            self._histories[point] = history_of(
                self.driveline(*point), shutdown, states
            )
        return self._histories[point]

    def outline(self, torsional_stiffness: float, key_gap: float = 0.0) -> Performance:
        """Return a performance that is known without a rollout, its loads left zero."""
        return self.read(torsional_stiffness, key_gap, [0.0] * len(TOTALS))

    def totals_and_jacobian(
        self, torsional_stiffness: float, key_gap: float
    ) -> tuple[FloatArray, FloatArray]:
        """Return TOTALS (5,) and their exact derivatives (5, 2) to the two variables.

        The last ones are kept: a solver's separate questions cost one rollout.
        """
        point = (torsional_stiffness, key_gap)
        if point not in self._known:
            if len(self._known) >= _REMEMBERED:
                self._known.clear()
            self._known[point] = self._roll_with_jacobian(point)
        return self._known[point]

    def read(
        self, torsional_stiffness: Scalar, key_gap: Scalar, totals: Scalar
    ) -> Performance:
        """Return the performance that `totals` describe, numbers or symbols."""
        frequency = self.natural_frequency(torsional_stiffness)
        return performance_of(torsional_stiffness, key_gap, frequency, totals)

    @cached_property
    def refined(self) -> Evaluator:
        """The same rollouts with half the time step."""
        return Evaluator(self.case, self.candidate, 2 * self.refinement)

    def coarser(self, coarsening: int) -> Evaluator:
        """Return the same rollouts with a time step this many times longer."""
        if coarsening not in self._coarser:
            self._coarser[coarsening] = Evaluator(
                self.case, self.candidate, coarsening=coarsening
            )
        return self._coarser[coarsening]

    @property
    def coarse_rollouts(self) -> int:
        """How many rollouts the coarser ones have made."""
        return sum(evaluator.rollouts for evaluator in self._coarser.values())

    def start_compiling(self) -> None:
        """Have the machine code of values made while something else is done."""
        start_compiling(self._step)

    @property
    def is_compiled(self) -> bool:
        """Whether the rollouts run as machine code."""
        return self._march.is_compiled

    @property
    def engine(self) -> str:
        """What does the rollouts, in words."""
        return self._march.engine

    def _roll_with_jacobian(
        self, point: tuple[float, float]
    ) -> tuple[FloatArray, FloatArray]:
        start = np.asarray(join_sensitivities(*self._start(ca.DM(point))))
        self.rollouts += 1
        column = np.asarray(point, dtype=np.float64)[:, np.newaxis]
        end = self._march_with_sensitivities(start, column)
        rows = end.reshape(1 + len(point), -1)[:, -len(TOTALS) :]
        self._check_finite(rows, *point)
        return rows[0], rows[1:].T

    def _check_finite(self, values: FloatArray, k: float, key_gap: float) -> None:
        if np.isfinite(values).all():
            return
        point = ca.DM([k, key_gap])
        start = self._start(point)[0]
        steps = steps_to_divergence(self._step, self._n_steps, start, point)
        raise SimulationError(
            f"{self.case.file}: the run-down of {self.candidate.label} at "
            f"{k:.6g} N*m/rad and a gap of {key_gap * 1e3:.4g} mm "
            f"left finite numbers by {steps * self.time_step:.4g} s, with a step of "
            f"{self.time_step:.3g} s. Take a smaller shutdown.time_step, or a softer "
            "contact."
        )

    @property
    def time_step(self) -> float:
        """The time step [s]."""
        return self.case.shutdown.time_step * self.coarsening / self.refinement

    @property
    def _n_steps(self) -> int:
        return self.case.shutdown.n_steps * self.refinement // self.coarsening

    @cached_property
    def _start(self) -> ca.Function:
        point = ca.SX.sym("point", 2)
        driveline = self.driveline(*ca.vertsplit(point))
        return joint_start(driveline, self.case.shutdown.initial_speed, point)

    @cached_property
    def _step(self) -> ca.Function:
        point = ca.SX.sym("point", 2)
        driveline = self.driveline(*ca.vertsplit(point))
        return joint_step(driveline, self.case, self.time_step, point)

    @cached_property
    def _march(self) -> Marcher:
        return fastest_marcher(self._step, self._n_steps)

    @cached_property
    def _march_with_sensitivities(self) -> Marcher:
        return fastest_marcher(with_sensitivities(self._step), self._n_steps)

"""What is measured: run-downs of the present coupling type with a key."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path

import casadi as ca
import numpy as np

from benchmarks.scale import CASE
from coupling_design.arithmetic import FloatArray
from coupling_design.case import load_case
from coupling_design.events.shutdown import RunDown
from coupling_design.line.parameters import (
    KeyedConnection,
    ProportionalDamping,
    QuasiSteadyStart,
)
from coupling_design.machine.candidate import Candidate, candidate_driveline
from coupling_design.machine.machine import Case
from coupling_design.machine.words import ConnectionKind
from coupling_design.march.sensitivities import (
    join_sensitivities,
    with_sensitivities,
)
from coupling_design.parts.bearing.life import fatigue_load_limit, reliability_factor
from coupling_design.parts.bearing.loads import rotational_loads, static_loads
from coupling_design.parts.bearing.lubrication import GREASE_CONTAMINATION
from coupling_design.parts.bearing.parameters import Cleanliness
from coupling_design.wear.step import joint_start, joint_step

SEED = 281


@dataclass(frozen=True)
class Batch:
    """Design points, a column each, and where their rollouts start."""

    points: FloatArray
    starts: FloatArray
    joint_starts: FloatArray


class Subject:
    """The step of the case's keyed driveline, and points to roll it out from."""

    def __init__(self, path: Path = CASE, refinement: int = 1) -> None:
        self._path = path
        self.case: Case = _one_even_start(load_case(path))
        self.time_step = self.case.shutdown.time_step / refinement
        option = next(
            option
            for option in self.case.connections
            if option.kind is ConnectionKind.KEY
        )
        candidate = Candidate(self.case.coupling_types[0], option)
        self._point = ca.SX.sym("point", 2)
        self._driveline = candidate_driveline(
            self.case, candidate, *ca.vertsplit(self._point)
        )

    def refined(self, refinement: int) -> Subject:
        """Return the same with a finer time step."""
        return Subject(self._path, refinement)

    @cached_property
    def step(self) -> ca.Function:
        """(joint state, point) -> joint state."""
        return joint_step(
            RunDown(self._driveline, self.case.shutdown),
            self.case,
            self._point,
            self.time_step,
        )

    @cached_property
    def joint_step(self) -> ca.Function:
        """The same with sensitivities."""
        return with_sensitivities(self.step)

    def batch(self, size: int) -> Batch:
        """Return points all over the plane of stiffness and gap."""
        random = np.random.default_rng(SEED)
        lowest, highest = self.case.coupling_types[0].stiffness_range
        points = np.vstack(
            [random.uniform(lowest, highest, size), random.uniform(5e-5, 3e-4, size)]
        )
        return self.at(points.T)

    def at(
        self,
        points: Sequence[Sequence[float]] | FloatArray,
        speed: float | None = None,
    ) -> Batch:
        """Return the batch of given (stiffness, gap).

        It starts turning evenly, as the peers do, at the shutdown's speed or another
        [rad/s].
        """
        columns = np.array(points).T
        speed = speed or self.case.shutdown.initial_speed
        shutdown = replace(self.case.shutdown, initial_speed=speed)
        start = joint_start(RunDown(self._driveline, shutdown), self._point)
        both = [start(point) for point in columns.T]
        return Batch(
            columns,
            np.hstack([np.asarray(state) for state, _ in both]),
            np.hstack([np.asarray(join_sensitivities(*pair)) for pair in both]),
        )

    def machine(self) -> FloatArray:
        """Return the numbers of `peers/machine.h` in its order."""
        case, d = self.case, self.case.driveline
        key, law = d.connection, case.coupling_types[0].damping_law
        one, three = d.engine_resistance, d.generator_resistance
        cleanliness = case.lubrication.cleanliness
        if not (
            isinstance(key, KeyedConnection)
            and isinstance(law, ProportionalDamping)
            and isinstance(cleanliness, Cleanliness)
        ):
            raise TypeError("the peers know a key, proportional damping and grease")
        c_1, c_2, _ = GREASE_CONTAMINATION[cleanliness]
        return np.array(
            [
                *(d.engine_inertia, d.coupling_inertia, d.generator_inertia),
                *(law.damping_factor, law.characteristic_frequency),
                *(key.radius, key.contact_stiffness, key.oil_damping, key.smoothing),
                *(x for order in d.excitation for x in (order.amplitude, order.phase)),
                *(one.viscous, one.friction, one.transition_speed),
                *(three.viscous, three.friction, three.transition_speed),
                *rotational_loads(1.0, case.shaft),
                *static_loads(case.shaft),
                *(bearing.dynamic_load_rating for bearing in case.bearings),
                *(fatigue_load_limit(bearing) for bearing in case.bearings),
                reliability_factor(case.reliability),
                case.lubrication.viscosity * 1e6,
                case.bearings[0].pitch_diameter * 1e3,
                *(c_1, c_2, self.time_step),
            ]
        )


def _one_even_start(case: Case) -> Case:
    """Return the case judged by one run-down from even turning, as the peers roll out.

    A settled vibration and a mean over crank angles would be ours alone to compute.
    """
    evenly = replace(case.shutdown, start=QuasiSteadyStart(), crank_angles=1)
    return replace(case, shutdown=evenly)

"""What is known of a design point without a rollout, and how its totals are read."""

from __future__ import annotations

import math

from coupling_design.arithmetic import Scalar
from coupling_design.line.modes import natural_angular_frequency
from coupling_design.line.parameters import Driveline
from coupling_design.machine.candidate import Candidate, candidate_driveline
from coupling_design.machine.machine import Case
from coupling_design.wear.performance import Performance, performance_of
from coupling_design.wear.quantities import TOTALS


class PointReader:
    """Reads the points of one candidate of a case."""

    def __init__(self, case: Case, candidate: Candidate) -> None:
        self.case, self.candidate = case, candidate

    def driveline(self, torsional_stiffness: Scalar, key_gap: Scalar) -> Driveline:
        """Return the driveline at a design point, values or symbols."""
        return candidate_driveline(
            self.case, self.candidate, torsional_stiffness, key_gap
        )

    def natural_frequency(self, torsional_stiffness: Scalar) -> Scalar:
        """Return the lowest natural frequency with the gap closed [Hz]."""
        driveline = self.driveline(torsional_stiffness, 0.0)
        return natural_angular_frequency(driveline) / (2 * math.pi)

    def outline(self, torsional_stiffness: float, key_gap: float = 0.0) -> Performance:
        """Return a performance that is known without a rollout, its loads left zero."""
        return self.read(torsional_stiffness, key_gap, [0.0] * len(TOTALS))

    def read(
        self, torsional_stiffness: Scalar, key_gap: Scalar, totals: Scalar
    ) -> Performance:
        """Return the performance that `totals` describe, numbers or symbols."""
        frequency = self.natural_frequency(torsional_stiffness)
        return performance_of(torsional_stiffness, key_gap, frequency, totals)

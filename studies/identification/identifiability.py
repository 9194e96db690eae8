"""How well each lost input is determined, and which trade off against each other.

The targets are averaged over the crank angle, linearised about a set, and divided by
what the paper leaves to them. Before the paper is read each input may lie anywhere
within its bounds; its singular directions then say what the paper adds.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from coupling_design.arithmetic import FloatArray
from coupling_design.machine.machine import Case
from studies.identification.jacobian import differences
from studies.identification.parameters import (
    NAMES,
    QUANTITIES,
    SMOOTH_CONTACT,
    Inputs,
    from_unit,
    to_unit,
)
from studies.identification.targets import TARGETS, targets_over_phases

# Share of the bounds that the derivatives step: wider than the ripple over the phase.
_STEP = 0.05
# Standard deviation of a value of which only the bounds are known, in their width.
_UNKNOWN = 1 / math.sqrt(12)
# A direction is pinned where the paper says at least as much as the bounds do.
_PINNED = 1.0
_NOTABLE = 0.3


@dataclass(frozen=True)
class Identifiability:
    """What the paper's results say about the inputs near one set.

    Attributes
    ----------
    inputs : the set
    jacobian : targets (rows) in their spreads over inputs in their bounds' deviation
    strengths : singular values, how many times better than by the bounds [-]
    directions : right singular vectors in rows, over the inputs
    results : left singular vectors in columns, over the targets
    """

    inputs: Inputs
    jacobian: FloatArray
    strengths: FloatArray
    directions: FloatArray
    results: FloatArray

    @property
    def determined(self) -> FloatArray:
        """Share of each input's variance that the results take away, 0 to 1 (11,)."""
        taken = self.strengths**2 / (1 + self.strengths**2)
        shares: FloatArray = (self.directions**2 * taken[:, np.newaxis]).sum(axis=0)
        return shares

    @property
    def deviation(self) -> FloatArray:
        """Standard deviation left to each input, as a share of its bounds (11,)."""
        left: FloatArray = _UNKNOWN * np.sqrt(1 - self.determined)
        return left

    @property
    def n_pinned(self) -> int:
        """Number of directions of which the results say more than the bounds."""
        return int((self.strengths > _PINNED).sum())


def identifiability(case: Case, inputs: Inputs, n_phases: int) -> Identifiability:
    """Return what the results say about the inputs near a set."""
    refinement = 1 if inputs["contact_stiffness"] <= SMOOTH_CONTACT else 2

    def values(points: FloatArray) -> FloatArray:
        candidates = [
            Inputs(tuple(row), inputs.cleanliness) for row in from_unit(points).tolist()
        ]
        found = targets_over_phases(case, candidates, n_phases, refinement)
        means: FloatArray = found.mean(axis=1)
        return means

    spreads = np.array([target.spread for target in TARGETS])
    known = np.isfinite(spreads)
    point = to_unit(np.array([inputs.values]))[0]
    low, high = np.zeros(len(NAMES)), np.ones(len(NAMES))
    slopes = differences(values, point, low, high, _STEP)[known]
    jacobian = _UNKNOWN * slopes / spreads[known, np.newaxis]
    results, strengths, directions = np.linalg.svd(jacobian, full_matrices=False)
    return Identifiability(inputs, jacobian, strengths, directions, results)


def ranges(found: Identifiability) -> list[tuple[float, float]]:
    """Return from where to where each input may lie, one deviation either way.

    In the unit of its quantity, held within its bounds.
    """
    point = to_unit(np.array([found.inputs.values]))[0]
    ends = np.clip([point - found.deviation, point + found.deviation], 0.0, 1.0)
    low, high = from_unit(ends)
    return [
        (quantity.from_si(float(a)), quantity.from_si(float(b)))
        for quantity, a, b in zip(QUANTITIES, low, high, strict=True)
    ]


def describe(vector: FloatArray, words: tuple[str, ...]) -> str:
    """Return the notable entries of a singular vector, the largest first."""
    order = np.argsort(-np.abs(vector))
    return ", ".join(
        f"{vector[i]:+.2f} {words[i]}" for i in order if abs(vector[i]) >= _NOTABLE
    )


def input_words() -> tuple[str, ...]:
    """Return the inputs in words, in the order of a direction."""
    return tuple(quantity.words for quantity in QUANTITIES)


def target_words() -> tuple[str, ...]:
    """Return the targets that count here, in the order of a column of `results`."""
    return tuple(t.name for t in TARGETS if math.isfinite(t.spread))

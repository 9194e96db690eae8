"""Damage, transmission force and collision force of one design point after another."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from coupling_design.arithmetic import FloatArray
from coupling_design.parts.bearing.damage import PAPER_UNIT
from coupling_design.signals.detrending import collision_force
from coupling_design.wear.evaluator import Evaluator
from studies.machine import history_of


@dataclass(frozen=True)
class Forces:
    """What a run-down does to bearing and key.

    `damage_e6` is the paper's unit; peaks are largest magnitudes [N], ranges are
    peak-to-peak [N].
    """

    stiffness: float
    gap: float
    damage_e6: float
    transmission_peak: float
    transmission_range: float
    collision_peak: float
    collision_range: float


def forces(
    candidate: Evaluator, points: Sequence[tuple[float, float]]
) -> tuple[Forces, ...]:
    """Return the forces and the damage at (stiffness [N m/rad], gap [m]) points."""
    performances = candidate.performances(points)
    found = []
    for (stiffness, gap), performance in zip(points, performances, strict=True):
        history = history_of(candidate, stiffness, gap)
        omega = 2 * math.pi * float(performance.natural_frequency)
        collision = collision_force(history, omega).fluctuation
        found.append(
            Forces(
                stiffness=stiffness,
                gap=gap,
                damage_e6=PAPER_UNIT * performance.damage,
                transmission_peak=float(performance.peak_transmission_force),
                transmission_range=float(np.ptp(history.transmission_force)),
                collision_peak=float(np.abs(collision).max()),
                collision_range=float(np.ptp(collision)),
            )
        )
    return tuple(found)


def change(value: float, reference: float) -> float:
    """Return by how much a value differs from a reference [%]."""
    return 100 * (value / reference - 1)


def reversals(values: Sequence[float]) -> tuple[int, float]:
    """Return how often a series that should rise falls, and the largest fall [%]."""
    series: FloatArray = np.asarray(values)
    steps = 100 * np.diff(series) / series[:-1]
    falls = steps[steps < 0]
    return len(falls), float(-falls.min(initial=0.0))


def deviation_from_line(x: FloatArray, y: FloatArray) -> float:
    """Return the largest distance from the best straight line, of y's range [%]."""
    line = np.polynomial.Polynomial.fit(x, y, 1)
    return float(100 * np.abs(y - line(x)).max() / np.ptp(y))

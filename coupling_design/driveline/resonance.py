"""Where in a run-down the driveline swings most, and when it comes to rest."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from coupling_design.arithmetic import FloatArray
from coupling_design.driveline.history import History


@dataclass(frozen=True)
class Swing:
    """The largest swing of the transmission force about its running mean.

    `speed` is the generator's mean speed there [rad/s], `amplitude` half the force's
    peak-to-peak [N], `time` [s].
    """

    speed: float
    amplitude: float
    time: float


def largest_swing(history: History, angular_frequency: float) -> Swing:
    """Return the largest swing over one period of `angular_frequency` [rad/s].

    The mean that the deceleration puts into the force does not count as swing.
    """
    from scipy.ndimage import maximum_filter1d, minimum_filter1d, uniform_filter1d

    step = history.time[1] - history.time[0]
    period = max(round(2 * math.pi / angular_frequency / step), 2)
    force = history.transmission_force
    swing = (maximum_filter1d(force, period) - minimum_filter1d(force, period)) / 2
    at = int(np.argmax(swing))
    mean_speed: FloatArray = uniform_filter1d(history.generator_speed, period)
    return Swing(float(mean_speed[at]), float(swing[at]), float(history.time[at]))


def rest_time(history: History, rest_speed: float) -> float | None:
    """Return when the engine's speed fell below `rest_speed` [rad/s] for good [s].

    None if it was still turning at the end. Dry friction smoothed over `rest_speed`
    says nothing about motion slower than that.
    """
    turning = np.flatnonzero(np.abs(history.engine_speed) > rest_speed)
    if turning.size == 0:
        return float(history.time[0])
    if turning[-1] == len(history.time) - 1:
        return None
    return float(history.time[turning[-1] + 1])

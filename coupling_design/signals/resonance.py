"""Where in a run-down the driveline swings most, and when it comes to rest.

Sources
-------
[1] van Herk (1992), A fast algorithm for local minimum and maximum filters on
    rectangular and octagonal kernels, Pattern Recognition Letters 13, 517-521.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from coupling_design.arithmetic import FloatArray
from coupling_design.signals.history import History


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

    The mean that the deceleration puts into the force does not count as swing. Of
    signals (n_steps,) the swing is three single numbers.
    """
    step = history.time[1] - history.time[0]
    period = max(round(2 * math.pi / angular_frequency / step), 2)
    force = _mirrored(history.transmission_force, period)
    swing = (_running_maximum(force, period) + _running_maximum(-force, period)) / 2
    at = int(np.argmax(swing))
    around = _mirrored(history.generator_speed, period)[at : at + period]
    return Swing(float(around.mean()), float(swing[at]), float(history.time[at]))


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


def _mirrored(signal: FloatArray, window: int) -> FloatArray:
    """Return a signal with its ends mirrored, so that every sample has a window.

    The window of sample i is then `window` samples from i on.
    """
    before = window // 2
    return np.pad(signal, (before, window - 1 - before), mode="symmetric")


def _running_maximum(signal: FloatArray, window: int) -> FloatArray:
    """Return the largest of every `window` samples in a row.

    [1]: with the signal cut into blocks as long as the window, each window is the end
    of one block and the beginning of the next.
    """
    n = len(signal) - window + 1
    blocks = np.full((-(-len(signal) // window), window), -np.inf)
    blocks.ravel()[: len(signal)] = signal
    to_the_end = np.maximum.accumulate(blocks[:, ::-1], axis=1)[:, ::-1].ravel()
    from_the_start = np.maximum.accumulate(blocks, axis=1).ravel()
    return np.maximum(to_the_end[:n], from_the_start[window - 1 :][:n])

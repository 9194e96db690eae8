"""What is fast in a signal, apart from what is slow: detrending window by window.

Sources
-------
[1] Advances in Mechanical Engineering 2023, doi 10.1177/16878132231190062: collision
    force apart from transmission force, and the fluctuation of speed at resonance,
    figs. 4, 9 and 10. It names the method and gives neither window nor order.
[2] Peng et al. (1994), Mosaic organization of DNA nucleotides, Phys. Rev. E 49:
    detrended fluctuation analysis. Its first step is used here, not its exponents.

Window and order are a choice of ours:

* Collisions ring on for some 20 ms at 0.5 to 1 kHz, the resonance swings at 8 to 10 Hz.
  Over an eighth of its period a parabola misses a swing of amplitude A by 0.4 % of A
  (0.4 / 6 (pi/8)^3) and a burst of ringing by nearly nothing: `collision_force`.
* Over four periods of the resonance a parabola follows the deceleration and leaves the
  swings whole: `resonance_fluctuation`.
* Windows overlap by half, so that less depends on where in its window an impact falls.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view

from coupling_design.arithmetic import FloatArray
from coupling_design.signals.history import History

PARABOLA = 2
OVERLAP = 0.5
# In periods of the driveline's lowest natural frequency.
COLLISION_WINDOW = 1 / 8
SPEED_WINDOW = 4.0
# A cycle belongs to the resonance while it swings this much of the largest.
_AT_RESONANCE = 0.5


@dataclass(frozen=True)
class Detrended:
    """A signal's trend and what fluctuates about it; their sum is the signal.

    Both are (n,), in the unit of the signal.
    """

    trend: FloatArray
    fluctuation: FloatArray


@dataclass(frozen=True)
class ResonanceFluctuation:
    """The swings of the engine's speed at resonance.

    Attributes
    ----------
    number : of cycles in a row with at least half the largest amplitude [-]
    frequency : of these cycles, their mean [Hz]
    amplitude : half the peak-to-peak of the largest cycle [rad/s]
    start, end : when the first begins and the last ends [s]
    """

    number: int
    frequency: float
    amplitude: float
    start: float
    end: float


def detrend(
    signal: FloatArray, window: int, order: int = PARABOLA, overlap: float = 0.0
) -> Detrended:
    """Return a signal as a least-squares polynomial per window, and what is left.

    Parameters
    ----------
    signal : (n,), in any unit; trend and fluctuation keep it
    window : samples in a window, more than `order` and at most n
    order : of the polynomial; [2] takes 1
    overlap : share of a window that the next one covers too, 0 to less than 1; the
        trend passes from one polynomial to the next in proportion

    Notes
    -----
    [2]. The last window ends with the signal and overlaps as it must.
    """
    hop = max(round(window * (1 - overlap)), 1)
    starts = np.arange(0, len(signal) - window + 1, hop)
    if starts[-1] != len(signal) - window:
        starts = np.append(starts, len(signal) - window)
    # Columns orthonormal on the window: the fit is a projection.
    powers = np.vander(np.linspace(-1.0, 1.0, window), order + 1)
    basis = np.linalg.qr(powers)[0]
    fits = sliding_window_view(signal, window)[starts] @ basis @ basis.T
    # A window counts most in its middle: where two meet, the trend has no step.
    weights = np.minimum(np.arange(1, window + 1), np.arange(window, 0, -1))
    covered = (starts[:, np.newaxis] + np.arange(window)).ravel()
    total = np.bincount(covered, (weights * fits).ravel())
    trend = total / np.bincount(covered, np.tile(weights, len(starts)))
    return Detrended(trend, signal - trend)


def collision_force(
    history: History,
    angular_frequency: float,
    window: float = COLLISION_WINDOW,
    order: int = PARABOLA,
) -> Detrended:
    """Return the collision force [N] as the fluctuation of the transmission force.

    Trend and fluctuation are (n_steps,).

    Parameters
    ----------
    history : of a run-down
    angular_frequency : the driveline's lowest natural one [rad/s]
    window : in periods of it
    order : of the polynomial

    Notes
    -----
    [1] figs. 9(b) and 10(b). A tight fit has no collisions; what this finds there is
    the error of the separation.
    """
    samples = _samples(history, angular_frequency, window, order)
    return detrend(history.transmission_force, samples, order, OVERLAP)


def resonance_fluctuation(
    history: History,
    angular_frequency: float,
    window: float = SPEED_WINDOW,
    order: int = PARABOLA,
) -> ResonanceFluctuation:
    """Return how the engine's speed swings about its deceleration at resonance.

    All are single numbers. Without a whole cycle, number and amplitude are zero, the
    others NaN.

    Parameters
    ----------
    history : of a run-down
    angular_frequency : the driveline's lowest natural one [rad/s]
    window : in periods of it
    order : of the polynomial

    Notes
    -----
    [1] fig. 4. A cycle lasts from one upward crossing of the trend to the next.
    """
    samples = _samples(history, angular_frequency, window, order)
    fluctuation = detrend(history.engine_speed, samples, order, OVERLAP).fluctuation
    crossings = np.flatnonzero((fluctuation[:-1] < 0) & (fluctuation[1:] >= 0))
    if len(crossings) < 2:
        return ResonanceFluctuation(0, math.nan, 0.0, math.nan, math.nan)
    cycles = np.split(fluctuation, crossings + 1)[1:-1]
    amplitudes = np.array([np.ptp(cycle) / 2 for cycle in cycles])
    first, last = _around_the_largest(amplitudes)
    time = history.time
    before = crossings[[first, last + 1]]
    share = fluctuation[before] / (fluctuation[before] - fluctuation[before + 1])
    start, end = time[before] + share * (time[before + 1] - time[before])
    number = last - first + 1
    return ResonanceFluctuation(
        number=number,
        frequency=float(number / (end - start)),
        amplitude=float(amplitudes.max()),
        start=float(start),
        end=float(end),
    )


def _samples(
    history: History, angular_frequency: float, window: float, order: int
) -> int:
    step = float(history.time[1] - history.time[0])
    samples = round(window * 2 * math.pi / angular_frequency / step)
    return min(max(samples, order + 2), len(history.time))


def _around_the_largest(amplitudes: FloatArray) -> tuple[int, int]:
    """Return first and last of the cycles that swing enough, without a gap."""
    largest = int(np.argmax(amplitudes))
    weak = np.flatnonzero(amplitudes < _AT_RESONANCE * amplitudes[largest])
    first = int(weak[weak < largest].max(initial=-1)) + 1
    last = int(weak[weak > largest].min(initial=len(amplitudes))) - 1
    return first, last

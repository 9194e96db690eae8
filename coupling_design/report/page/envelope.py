"""Long signals drawn through their own extremes, so that no peak is lost.

A signal of 120 000 samples is cut into bins; of each bin the smallest and the largest
sample are drawn, each at its own time. Bins are narrower around moments that deserve a
closer look. Nothing is averaged and nothing is made up: every point drawn is a sample.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from coupling_design.report.words.numbers import significant

COARSE_BINS = 500  # over the whole signal
FINER = 8  # times narrower are the bins around a moment
CLOSER_LOOK = 0.05  # of the whole signal, before and after a moment

Floats = NDArray[np.float64]
Indices = NDArray[np.intp]


@dataclass(frozen=True)
class Bins:
    """Where bins begin, as indices of samples, the last one the end; and in words."""

    edges: Indices
    note: str


def bins_around(time: Floats, moments: Sequence[float]) -> Bins:
    """Return the bins of a signal [s], evenly sampled, finer around moments [s]."""
    n = len(time)
    coarse = max(n // COARSE_BINS, 1)
    fine = max(coarse // FINER, 1)
    windows = list(_windows(time, moments)) if fine < coarse else []
    edges: list[NDArray[np.intp]] = []
    at = 0
    for first, last in windows:
        edges += [np.arange(at, first, coarse), np.arange(first, last, fine)]
        at = last
    edges += [np.arange(at, n, coarse), np.array([n])]
    return Bins(np.concatenate(edges), _note(time, coarse, fine, windows))


def extremes(signal: Floats, bins: Bins) -> Indices:
    """Return which samples to draw: both extremes of each bin, and both ends."""
    starts, widths = bins.edges[:-1], np.diff(bins.edges)
    is_drawn = np.zeros(len(signal), dtype=bool)
    is_drawn[[0, -1]] = True
    # Bins of one width in a row are the rows of a matrix: one call instead of hundreds.
    for alike in np.split(np.arange(len(starts)), np.flatnonzero(np.diff(widths)) + 1):
        first, width = starts[alike], widths[alike[0]]
        rows = signal[first[0] : first[-1] + width].reshape(-1, width)
        is_drawn[first + rows.argmin(axis=1)] = True
        is_drawn[first + rows.argmax(axis=1)] = True
    return np.flatnonzero(is_drawn)


def _windows(time: Floats, moments: Sequence[float]) -> Iterator[tuple[int, int]]:
    """Yield first and last sample of each closer look, in order, none overlapping."""
    n = len(time)
    reach = round(CLOSER_LOOK * n)
    at = 0
    for centre in sorted(int(np.searchsorted(time, moment)) for moment in moments):
        first, last = max(centre - reach, at), min(centre + reach, n)
        if first < last:
            yield first, last
            at = last


def _note(
    time: Floats, coarse: int, fine: int, windows: Sequence[tuple[int, int]]
) -> str:
    if coarse == 1:
        return f"All {len(time)} samples are drawn."
    step = float(time[1] - time[0])
    width, narrow = (f"{significant(1e3 * k * step, 3)} ms" for k in (coarse, fine))
    closer = " and ".join(
        f"{significant(float(time[first]), 3)} to "
        f"{significant(float(time[last - 1]), 3)} s"
        for first, last in windows
    )
    closer = f" ({narrow} from {closer})" if windows else ""
    return (
        f"Drawn: the smallest and the largest of the {len(time)} samples in every "
        f"{width}{closer}, each at its own time. No peak is lost; zoomed in further "
        "than that, the line only joins these points."
    )

"""The totals of run-downs that differ by chance, taken together."""

from __future__ import annotations

import numpy as np

from coupling_design.arithmetic import FloatArray
from coupling_design.design.chance import Spread

_DAMAGES = slice(0, 2)  # of `joint.TOTALS`; what follows are peaks
_PEAK_FORCE = 2


def over_chance(totals: FloatArray, *slopes: FloatArray) -> FloatArray:
    """Return the totals to judge by: damages' means, the largest of each peak.

    Parameters
    ----------
    totals : of each run-down, (n_totals, n)
    slopes : their derivatives to one variable each, shapes as totals

    Returns
    -------
    (n_totals,), or with slopes (n_totals, 1 + len(slopes)): a peak's slope is that of
    the run-down that has it
    """
    leading = totals.argmax(axis=1)
    rows = np.arange(len(totals))
    judged = []
    for each in (totals, *slopes):
        column = each[rows, leading]
        column[_DAMAGES] = each[_DAMAGES].mean(axis=1)
        judged.append(column)
    return np.stack(judged, axis=1) if slopes else judged[0]


def spread_of(
    totals: FloatArray, final_speeds: FloatArray, *, repeats: bool = True
) -> Spread:
    """Return how far totals (n_totals, n) reach over their n run-downs.

    `final_speeds` (n_masses, n) are those at their ends [rad/s]; `repeats` is whether
    the vibration they start from is periodic.
    """
    lowest, highest = totals.min(axis=1).tolist(), totals.max(axis=1).tolist()
    return Spread(
        crank_angles=totals.shape[1],
        damages=((lowest[0], highest[0]), (lowest[1], highest[1])),
        peak_transmission_force=(lowest[_PEAK_FORCE], highest[_PEAK_FORCE]),
        mean_peak=float(totals[_PEAK_FORCE].mean()),
        worst=int(totals[_PEAK_FORCE].argmax()),
        final_speed=float(np.abs(final_speeds).max()),
        repeats=repeats,
    )

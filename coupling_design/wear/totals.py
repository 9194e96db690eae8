"""The totals of run-downs that differ by chance, taken together."""

from __future__ import annotations

import numpy as np

from coupling_design.arithmetic import FloatArray
from coupling_design.wear.chance import Spread
from coupling_design.wear.quantities import (
    DAMAGES,
    PEAK_FORCE,
    QUANTITIES,
    Gathering,
    place_of,
)

_SUMS = [quantity.gathering is Gathering.ADDS_UP for quantity in QUANTITIES]


def over_chance(totals: FloatArray, *slopes: FloatArray) -> FloatArray:
    """Return the totals to judge by: means of what adds up, the largest of each peak.

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
        column[_SUMS] = each[_SUMS].mean(axis=1)
        judged.append(column)
    return np.stack(judged, axis=1) if slopes else judged[0]


def spread_of(
    totals: FloatArray, final_speeds: FloatArray, *, repeats: bool = True
) -> Spread:
    """Return how far totals (n_totals, n) reach over their n run-downs.

    `final_speeds` (n_masses, n) are those at their ends [rad/s]; `repeats` is whether
    the vibration they start from is periodic.
    """
    first, second = (_reach(totals[place_of(damage)]) for damage in DAMAGES)
    forces = totals[place_of(PEAK_FORCE)]
    return Spread(
        crank_angles=totals.shape[1],
        damages=(first, second),
        peak_transmission_force=_reach(forces),
        mean_peak=float(forces.mean()),
        worst=int(forces.argmax()),
        final_speed=float(np.abs(final_speeds).max()),
        repeats=repeats,
    )


def _reach(values: FloatArray) -> tuple[float, float]:
    return float(values.min()), float(values.max())

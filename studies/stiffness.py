"""Influence of the coupling's stiffness, damping following it: the paper's figure 9.

Claims: half the stiffness does 90.21 % more damage; a slightly stiffer coupling does
less; peaks of transmission and collision force go the same way.
"""

from __future__ import annotations

import functools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.figure import Figure
from rich.table import Table

from coupling_design.machine.machine import Case
from coupling_design.report.words.numbers import percent, significant
from studies.command import Study, leave, table
from studies.drawing import BLUE, GREEN, GREY, ORANGE, canvas, limits
from studies.forces import Forces, change, forces
from studies.machine import present, present_point

HALF, SLIGHTLY_STIFFER = 0.5, 1.1
MULTIPLIERS = tuple(0.5 + 0.05 * i for i in range(31))


@dataclass(frozen=True)
class StiffnessInfluence:
    """What each of the multipliers of the present stiffness does."""

    multipliers: tuple[float, ...]
    points: tuple[Forces, ...]

    def at(self, multiplier: float) -> Forces:
        """Return the point of the multiplier nearest to the one given."""
        return self.points[
            int(np.abs(np.array(self.multipliers) - multiplier).argmin())
        ]

    def damage_change(self, multiplier: float) -> float:
        """Return the change of damage against the present stiffness [%]."""
        return change(self.at(multiplier).damage_e6, self.at(1.0).damage_e6)


@functools.cache
def examine(
    case: Case, multipliers: tuple[float, ...] = MULTIPLIERS
) -> StiffnessInfluence:
    """Return the influence of stiffness at the present gap."""
    stiffness, gap = present_point(case)
    points = forces(present(case), [(m * stiffness, gap) for m in multipliers])
    return StiffnessInfluence(multipliers, points)


def tables(found: StiffnessInfluence) -> Sequence[Table]:
    """Return every other multiplier's damage and peak forces."""
    made = table(
        "Influence of stiffness (fig. 9)",
        "multiplier",
        "stiffness, MN m/rad",
        "D, 1e-6",
        "change, %",
        "peak Fc, kN",
        "peak collision force, kN",
    )
    for multiplier in found.multipliers[::2]:
        point = found.at(multiplier)
        made.add_row(
            f"{multiplier:.2f}",
            significant(point.stiffness / 1e6),
            significant(point.damage_e6),
            percent(found.damage_change(multiplier) / 100),
            significant(point.transmission_peak / 1e3),
            significant(point.collision_peak / 1e3),
        )
    return [made]


def figures(found: StiffnessInfluence) -> Mapping[str, Figure]:
    """Return damage and peak forces over the multiplier."""
    figure, (damage, peaks) = canvas(1, 2, height=3.2)
    points, x = found.points, found.multipliers
    damage.plot(x, [p.damage_e6 for p in points], ".-", color=BLUE)
    limits(damage, found.at(1.0).damage_e6, "present")
    damage.set_ylabel("D, 1e-6")
    damage.set_ylim(bottom=0.0)
    peaks.plot(
        x,
        [p.transmission_peak / 1e3 for p in points],
        ".-",
        color=ORANGE,
        label="transmission force",
    )
    peaks.plot(
        x,
        [p.collision_peak / 1e3 for p in points],
        ".-",
        color=GREEN,
        label="collision force",
    )
    peaks.set_ylabel("peak, kN")
    peaks.set_ylim(bottom=0.0)
    for axes in (damage, peaks):
        axes.set_xlabel("multiplier of the present stiffness")
        axes.axvline(1.0, color=GREY, linewidth=0.7)
        axes.legend()
    return {"stiffness": figure}


def findings(found: StiffnessInfluence) -> Sequence[str]:
    """Return what the figure shows."""
    values = [point.damage_e6 for point in found.points]
    inner = zip(values, values[1:], values[2:], strict=False)
    valleys = sum(a > b <= c for a, b, c in inner)
    best = int(np.argmin(values))
    half, stiffer = found.at(HALF), found.at(SLIGHTLY_STIFFER)
    now = found.at(1.0)
    return (
        f"Half the stiffness changes D by {found.damage_change(HALF):+.2f} %, the peak "
        f"transmission force by "
        f"{change(half.transmission_peak, now.transmission_peak):+.1f} % and the peak "
        f"collision force by {change(half.collision_peak, now.collision_peak):+.1f} %.",
        f"{SLIGHTLY_STIFFER:g} times the stiffness changes D by "
        f"{found.damage_change(SLIGHTLY_STIFFER):+.2f} %, the peak transmission force "
        f"by {change(stiffer.transmission_peak, now.transmission_peak):+.1f} % and the "
        f"peak collision force by "
        f"{change(stiffer.collision_peak, now.collision_peak):+.1f} %.",
        f"D is least at {found.multipliers[best]:.2f} times and has {valleys} inner "
        f"local minima at {len(values)} multipliers.",
    )


STUDY = Study("Influence of stiffness (fig. 9)", examine, tables, figures, findings)

if __name__ == "__main__":
    leave(STUDY)

"""Influence of the key gap: the paper's table 3 and figure 10.

Claims: damage rises linearly with the gap, by 19.68 % at 0.3 mm over a tight fit; the
peak-to-peak of the transmission force rises a little, that of the collision force much.
"""

from __future__ import annotations

import functools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.figure import Figure
from rich.table import Table

from coupling_design.arithmetic import FloatArray
from coupling_design.line.contact import SHARP
from coupling_design.machine.machine import Case
from coupling_design.report.words.numbers import percent, significant
from studies.command import Study, leave, table
from studies.drawing import BLUE, GREEN, GREY, ORANGE, canvas
from studies.forces import Forces, change, deviation_from_line, forces, reversals
from studies.machine import present, present_point, present_tightly_fitted

LARGEST = 0.3e-3
# The paper's cases beside the tight fit [m], by name.
CASES = {"spline": 0.01e-3, "key, as built": 0.28e-3, "key, largest": LARGEST}
SWEEP = tuple(LARGEST * i / 30 for i in range(31))


@dataclass(frozen=True)
class GapInfluence:
    """What a tight fit, the paper's other cases and a fine sweep of gaps do.

    `smoothing` [1/m] is the case's, to tell where a gap is too small for it.
    """

    tight: Forces
    cases: tuple[Forces, ...]
    gaps: tuple[float, ...]
    sweep: tuple[Forces, ...]
    smoothing: float

    @property
    def damages(self) -> FloatArray:
        """Damage of the sweep, in the paper's unit."""
        return np.array([point.damage_e6 for point in self.sweep])

    @property
    def damage_change(self) -> float:
        """Change of damage at the largest gap against a tight fit [%]."""
        return change(self.sweep[-1].damage_e6, self.tight.damage_e6)

    @property
    def deviation(self) -> float:
        """Largest distance of D from a straight line over the gap, of its range [%]."""
        return deviation_from_line(np.array(self.gaps), self.damages)


@functools.cache
def examine(case: Case, gaps: tuple[float, ...] = SWEEP) -> GapInfluence:
    """Return the influence of the gap at the present stiffness."""
    stiffness, _ = present_point(case)
    cases = [(stiffness, gap) for gap in CASES.values()]
    return GapInfluence(
        tight=forces(present_tightly_fitted(case), [(stiffness, 0.0)])[0],
        cases=forces(present(case), cases),
        gaps=gaps,
        sweep=forces(present(case), [(stiffness, gap) for gap in gaps]),
        smoothing=case.hub_seat.smoothing or 0.0,
    )


def tables(found: GapInfluence) -> Sequence[Table]:
    """Return damage and peak-to-peak forces of the paper's cases."""
    made = table(
        "Influence of the key gap (table 3, fig. 10)",
        "case",
        "gap, mm",
        "D, 1e-6",
        "change, %",
        "Fc peak to peak, kN",
        "collision force p-p, kN",
    )
    for name, point in (
        ("tight fit", found.tight),
        *zip(CASES, found.cases, strict=True),
        ("key, gap closed", found.sweep[0]),
    ):
        made.add_row(
            name,
            f"{point.gap * 1e3:.2f}",
            significant(point.damage_e6),
            percent(change(point.damage_e6, found.tight.damage_e6) / 100),
            significant(point.transmission_range / 1e3),
            significant(point.collision_range / 1e3),
        )
    return [made]


def figures(found: GapInfluence) -> Mapping[str, Figure]:
    """Return damage and peak-to-peak forces over the gap."""
    figure, (damage, peaks) = canvas(1, 2, height=3.2)
    x, points = 1e3 * np.array(found.gaps), found.sweep
    line = np.polynomial.Polynomial.fit(x, found.damages, 1)
    damage.plot(x, found.damages, ".", color=BLUE, label="key")
    damage.plot(x, line(x), color=GREY, linewidth=0.8, label="straight line")
    damage.plot(0.0, found.tight.damage_e6, "s", color=ORANGE, label="tight fit")
    damage.set_ylabel("D, 1e-6")
    for name, color, values in (
        ("transmission force", ORANGE, [p.transmission_range for p in points]),
        ("collision force", GREEN, [p.collision_range for p in points]),
    ):
        peaks.plot(x, np.array(values) / 1e3, ".-", color=color, label=name)
    peaks.set_ylabel("peak to peak, kN")
    peaks.set_ylim(bottom=0.0)
    for axes in (damage, peaks):
        axes.set_xlabel("key gap, mm")
        axes.legend()
    return {"gap": figure}


def findings(found: GapInfluence) -> Sequence[str]:
    """Return what the figure shows, and how smooth it is."""
    falls, largest = reversals(list(found.damages))
    blunt = 2 * SHARP / found.smoothing if found.smoothing else 0.0
    return (
        f"From a tight fit to {found.gaps[-1] * 1e3:g} mm D changes by "
        f"{found.damage_change:+.2f} %. It keeps within {found.deviation:.1f} % of its "
        f"range of a straight line over the gap.",
        "D falls with every step as the gap closes."
        if falls == 0
        else f"As the gap closes, D rises in {falls} of {len(found.gaps) - 1} steps, "
        f"by at most {largest:.3f} %.",
        f"Gaps below {blunt * 1e3:.2g} mm are too small for the smoothing: their "
        "rattle is understated. The collision force of a gap of zero is what the "
        f"separation leaks, {found.tight.collision_range / 1e3:.2f} kN for the tight "
        "fit.",
    )


STUDY = Study("Influence of the key gap (fig. 10)", examine, tables, figures, findings)

if __name__ == "__main__":
    leave(STUDY)

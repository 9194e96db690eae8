"""Transmission force with the high-stiffness coupling: the paper's figure 13(a).

Claims: neither resonance nor collision; the peak of 33 926.07 N is below the limit, D
falls by 43.19 % to 0.0023.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.figure import Figure
from rich.table import Table

from coupling_design.arithmetic import FloatArray
from coupling_design.machine.machine import Case
from coupling_design.parts.bearing.contact_stress import permissible_transmission_force
from coupling_design.parts.bearing.damage import PAPER_UNIT
from coupling_design.report.words.numbers import percent, significant
from coupling_design.signals.history import History
from coupling_design.signals.resonance import Swing, largest_swing
from coupling_design.wear.performance import Performance
from studies.command import Study, leave, table
from studies.drawing import BLUE, ORANGE, canvas, limits, trace
from studies.forces import change
from studies.machine import (
    high_stiffness_history,
    high_stiffness_performance,
    present_history,
    present_performance,
)


@dataclass(frozen=True)
class TwoCouplings:
    """The present coupling and the high-stiffness one over the same run-down.

    Forces [N] are (n_steps,); `swings` are over a period of the present driveline.
    """

    time: FloatArray
    present_force: FloatArray
    stiff_force: FloatArray
    present: Performance
    stiff: Performance
    swings: tuple[Swing, Swing]
    permissible: float

    @property
    def damage_change(self) -> float:
        """Change of damage by the high-stiffness coupling [%]."""
        return change(self.stiff.damage, self.present.damage)


def examine(case: Case) -> TwoCouplings:
    """Return both run-downs, the stiff coupling at the lowest stiffness of step 4."""
    before, after = present_history(case), high_stiffness_history(case)
    performance = present_performance(case)
    omega = 2 * math.pi * float(performance.natural_frequency)

    def swing(history: History) -> Swing:
        return largest_swing(history, omega)

    return TwoCouplings(
        time=before.time,
        present_force=before.transmission_force,
        stiff_force=after.transmission_force,
        present=performance,
        stiff=high_stiffness_performance(case),
        swings=(swing(before), swing(after)),
        permissible=float(permissible_transmission_force(case.shaft, case.bearings)),
    )


def tables(found: TwoCouplings) -> Sequence[Table]:
    """Return both couplings side by side."""
    made = table(
        "Present and high-stiffness coupling (fig. 13)", "", "present", "high stiffness"
    )
    pair = (found.present, found.stiff)
    made.add_row(
        "stiffness, MN m/rad",
        *(significant(p.torsional_stiffness / 1e6, 5) for p in pair),
    )
    made.add_row(
        "natural frequency, Hz", *(significant(p.natural_frequency, 5) for p in pair)
    )
    made.add_row("peak Fc, N", *(f"{p.peak_transmission_force:.0f}" for p in pair))
    made.add_row(
        "largest swing of Fc, N", *(f"{s.amplitude:.0f}" for s in found.swings)
    )
    made.add_row("D, 1e-6", *(significant(PAPER_UNIT * p.damage) for p in pair))
    made.add_row("change of D, %", "", percent(found.damage_change / 100))
    return [made]


def figures(found: TwoCouplings) -> Mapping[str, Figure]:
    """Return both transmission forces over time, on one scale."""
    figure, axes = canvas(2)
    largest = 1.1 * max(np.abs(found.present_force).max(), found.permissible) / 1e3
    for part, force, color, name in (
        (axes[0], found.present_force, ORANGE, "present coupling"),
        (axes[1], found.stiff_force, BLUE, "high-stiffness coupling, tight fit"),
    ):
        trace(part, found.time, force / 1e3, color=color, label=name)
        limits(part, found.permissible / 1e3, "permissible", both=True)
        part.set_ylabel("Fc, kN")
        part.set_ylim(-largest, largest)
        part.legend(loc="upper left", ncols=2)
    axes[1].set_xlabel("time, s")
    return {"high_stiffness": figure}


def findings(found: TwoCouplings) -> Sequence[str]:
    """Return what the figure shows."""
    peak = float(found.stiff.peak_transmission_force)
    side = "below" if peak <= found.permissible else "above"
    return (
        f"The high-stiffness coupling peaks at {peak:.0f} N, {side} the permissible "
        f"{found.permissible:.2f} N, and changes D by {found.damage_change:+.2f} %. "
        f"The force swings by {found.swings[1].amplitude:.0f} N at most, instead of "
        f"{found.swings[0].amplitude:.0f} N.",
    )


STUDY = Study(
    "Transmission force with the high-stiffness coupling (fig. 13)",
    examine,
    tables,
    figures,
    findings,
)

if __name__ == "__main__":
    leave(STUDY)

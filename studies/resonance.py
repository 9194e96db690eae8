"""Fluctuation of the flywheel's speed at resonance: the paper's figure 4.

Claims: the run-down shows as many swings as the test; the resonance lies at 100 to
140 rpm. The measured values (table 2) are lost, so ours are given without a judgement.
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
from coupling_design.report.words.numbers import significant
from coupling_design.signals.detrending import (
    SPEED_WINDOW,
    ResonanceFluctuation,
    detrend,
    resonance_fluctuation,
)
from coupling_design.signals.resonance import Swing, largest_swing
from studies.command import Study, leave, table
from studies.drawing import BLUE, GREY, ORANGE, canvas, trace
from studies.machine import present_history, present_performance

RPM = 30 / math.pi
# In periods of the natural frequency: the chosen one and its neighbours.
WINDOWS = (SPEED_WINDOW / 2, SPEED_WINDOW, 2 * SPEED_WINDOW)


@dataclass(frozen=True)
class Resonance:
    """The speed's fluctuation over time, and its swings for each of WINDOWS."""

    time: FloatArray
    engine_speed: FloatArray
    fluctuation: FloatArray
    swings: tuple[ResonanceFluctuation, ...]
    force_swing: Swing

    @property
    def chosen(self) -> ResonanceFluctuation:
        """The swings found with the chosen window."""
        return self.swings[WINDOWS.index(SPEED_WINDOW)]

    @property
    def speeds_rpm(self) -> tuple[float, float]:
        """Mean speed of the engine at the first and the last of its swings."""
        trend = self.engine_speed - self.fluctuation
        ends = np.interp([self.chosen.start, self.chosen.end], self.time, trend)
        return float(ends[0]) * RPM, float(ends[1]) * RPM


def examine(case: Case) -> Resonance:
    """Return the fluctuation at resonance of the present coupling."""
    history = present_history(case)
    omega = 2 * math.pi * float(present_performance(case).natural_frequency)
    step = float(history.time[1] - history.time[0])
    samples = round(SPEED_WINDOW * 2 * math.pi / omega / step)
    return Resonance(
        time=history.time,
        engine_speed=history.engine_speed,
        fluctuation=detrend(history.engine_speed, samples, overlap=0.5).fluctuation,
        swings=tuple(resonance_fluctuation(history, omega, w) for w in WINDOWS),
        force_swing=largest_swing(history, omega),
    )


def tables(found: Resonance) -> Sequence[Table]:
    """Return number, frequency and amplitude of the swings for each window."""
    made = table(
        "Fluctuation of the flywheel's speed at resonance (fig. 4)",
        "window, natural periods",
        "swings",
        "frequency, Hz",
        "amplitude, rpm",
        "from, s",
        "to, s",
    )
    for window, swings in zip(WINDOWS, found.swings, strict=True):
        made.add_row(
            f"{window:g}",
            str(swings.number),
            significant(swings.frequency),
            significant(swings.amplitude * RPM),
            significant(swings.start),
            significant(swings.end),
        )
    return [made]


def figures(found: Resonance) -> Mapping[str, Figure]:
    """Return the run-down and its fluctuation about the trend."""
    figure, (speed, fluctuation) = canvas(2)
    swings = found.chosen
    trace(speed, found.time, found.engine_speed * RPM, color=BLUE)
    speed.set_ylabel("flywheel speed, rpm")
    near = np.abs(found.time - (swings.start + swings.end) / 2) < 1.5 * (
        swings.end - swings.start
    )
    trace(fluctuation, found.time[near], found.fluctuation[near] * RPM, color=BLUE)
    fluctuation.set_ylabel("fluctuation, rpm")
    fluctuation.set_xlabel("time, s")
    for axes in (speed, fluctuation):
        axes.axvspan(swings.start, swings.end, color=ORANGE, alpha=0.15, linewidth=0)
    fluctuation.axhline(0.0, color=GREY, linewidth=0.7)
    return {"resonance": figure}


def findings(found: Resonance) -> Sequence[str]:
    """Return what the figure shows."""
    swings, (fast, slow) = found.chosen, found.speeds_rpm
    return (
        f"{swings.number} swings in a row reach half the largest, from {fast:.1f} to "
        f"{slow:.1f} rpm, at {swings.frequency:.2f} Hz; the largest has an amplitude "
        f"of {swings.amplitude * RPM:.2f} rpm. The force swings most at "
        f"{found.force_swing.speed * RPM:.1f} rpm.",
    )


STUDY = Study("Speed at resonance (fig. 4)", examine, tables, figures, findings)

if __name__ == "__main__":
    leave(STUDY)

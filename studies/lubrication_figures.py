"""The figures of the lubrication study."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from coupling_design.arithmetic import FloatArray
from studies.drawing import BLUE, GREEN, GREY, ORANGE, canvas, limits, trace


def draw_lubrication(
    speed: FloatArray, kappa: FloatArray, e_C: FloatArray, initial_speed: float
) -> Figure:
    """Return kappa over speed [rpm] and e_C over kappa, as in figure 6."""
    figure, (left, right) = canvas(1, 2, height=2.9)
    left.plot(speed, kappa, color=BLUE)
    left.axvline(initial_speed, color=GREY, linewidth=0.7)
    left.annotate(" start of the run-down", (initial_speed, 0.15), color=GREY)
    left.set_xlabel("speed, rpm")
    left.set_ylabel("viscosity ratio kappa")
    right.plot(kappa, e_C, color=GREEN)
    right.set_xlabel("viscosity ratio kappa")
    right.set_ylabel("contamination factor e_C")
    return figure


def draw_loads(
    time: FloatArray,
    loads: tuple[FloatArray, FloatArray],
    load_limits: tuple[float, float],
) -> Figure:
    """Return both combined loads [N] against F_min, as in figure 7."""
    figure, axes = canvas(2)
    for i, (part, load, limit) in enumerate(
        zip(axes, loads, load_limits, strict=True), start=1
    ):
        trace(part, time, load / 1e3, color=BLUE)
        limits(part, limit / 1e3, "F_min")
        part.set_ylabel(f"load of bearing {i}, kN")
        part.set_ylim(0.0, 1.25 * max(load.max(), limit) / 1e3)
        part.legend(loc="upper left")
    axes[-1].set_xlabel("time, s")
    return figure


def draw_life(
    time: FloatArray,
    indices: Mapping[str, FloatArray],
    stages: tuple[float, float, float],
) -> Figure:
    """Return the indices over time with both stages marked, as in figure 8."""
    figure, axes = canvas(len(indices))
    for part, (name, values) in zip(axes, indices.items(), strict=True):
        trace(part, time, values, color=BLUE)
        part.set_yscale("log")
        part.set_ylabel(name)
        mark_stages(part, stages)
    axes[-1].set_xlabel("time, s")
    return figure


def mark_stages(axes: Axes, stages: tuple[float, float, float]) -> None:
    """Shade stage I and stage II and name them at the top."""
    for name, left, right, color in (
        ("Stage I", stages[0], stages[1], ORANGE),
        ("Stage II", stages[1], stages[2], GREY),
    ):
        if np.isfinite([left, right]).all():
            axes.axvspan(left, right, color=color, alpha=0.15, linewidth=0)
            axes.annotate(
                name,
                ((left + right) / 2, 1.0),
                xycoords=("data", "axes fraction"),
                ha="center",
                va="bottom",
            )

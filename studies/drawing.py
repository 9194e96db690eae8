"""Figures that look alike, and files that come out the same each time."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from coupling_design.arithmetic import FloatArray

BLUE, ORANGE, GREEN, RED, GREY = "#1f5f99", "#d1741a", "#3a7d44", "#b02a30", "#777777"

# Matplotlib types the keys of its settings as one long literal.
_STYLE: Any = {
    "axes.grid": True,
    "axes.spines.right": False,
    "axes.spines.top": False,
    "font.size": 9,
    "grid.color": "#dddddd",
    "legend.frameon": False,
    "lines.linewidth": 1.2,
    # Identifiers inside an SVG, which are random otherwise.
    "svg.hashsalt": "studies",
}
# Columns that a curve is drawn with: about those of a page, and small files.
_COLUMNS = 500


def canvas(
    rows: int, columns: int = 1, height: float = 2.4
) -> tuple[Figure, list[Axes]]:
    """Return a figure of a page's width and its axes, row by row."""
    mpl.rcParams.update(_STYLE)
    figure = Figure(figsize=(8.0, height * rows + 0.3), layout="constrained")
    axes = figure.subplots(rows, columns, squeeze=False)
    return figure, list(axes.flat)


def trace(
    axes: Axes, time: FloatArray, signal: FloatArray, color: str, label: str = ""
) -> None:
    """Draw a long signal by its extremes per column, so that no peak is lost."""
    length = max(len(time) // _COLUMNS, 2)
    n = len(time) // length * length
    blocks = signal[:n].reshape(-1, length)
    extremes = np.column_stack([blocks.argmin(axis=1), blocks.argmax(axis=1)])
    places = np.sort(extremes, axis=1) + np.arange(0, n, length)[:, np.newaxis]
    shown = places.ravel()
    axes.plot(time[shown], signal[shown], linewidth=0.7, color=color, label=label)


def limits(axes: Axes, value: float, label: str, both: bool = False) -> None:
    """Draw a limit, on both sides of zero if so wanted."""
    for i, level in enumerate((value, -value) if both else (value,)):
        axes.axhline(
            level, color=RED, linestyle="--", linewidth=1, label=None if i else label
        )


def save(figure: Figure, folder: Path, name: str, kind: str = "svg") -> Path:
    """Write a figure without date or version and return its path."""
    path = folder / f"{name}.{kind}"
    folder.mkdir(parents=True, exist_ok=True)
    nothing = {"Date": None, "Creator": None} if kind == "svg" else {"Software": None}
    figure.savefig(path, dpi=110, metadata=nothing)
    return path

"""What a figure is made of: rows of curves over a common axis, in Plotly's terms."""

from __future__ import annotations

import base64
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from coupling_design.report.page.typography import typeset

Floats = NDArray[np.float64]

# After Okabe and Ito: told apart by colour-blind readers, and by lightness in grey.
ORANGE, BLUE, BLACK, GREY = "#e69f00", "#00558b", "#000000", "#6b6b6b"
ROLE_COLOURS = {"present": ORANGE, "chosen": BLUE, "nearest": BLUE}
# The present one lies below: it must show where the two are alike.
ROLE_WIDTHS = {"present": 2.2, "chosen": 1.0, "nearest": 1.0}
_ROW_HEIGHT, _MARGIN = 160, 110
_AIR = 0.12  # of an ordinate's range, above and below, where limits have their words
_BETWEEN_ROWS = 0.12  # of a row's height
_SMALL = 11
_TICKS = 6  # powers of ten on one axis, at most
_DECADES = 3  # more of them have room for powers of ten only


@dataclass(frozen=True)
class Curve:
    """One line: its name in the legend, what it shows, and how."""

    name: str
    x: Floats
    y: Floats
    colour: str
    width: float = 1.2
    has_markers: bool = False


@dataclass(frozen=True)
class Limit:
    """A level to stay below or above, with the words beside it, if any."""

    text: str
    value: float


@dataclass(frozen=True)
class Row:
    """Curves that share an ordinate; `label` names quantity and unit."""

    label: str
    curves: tuple[Curve, ...]
    limits: tuple[Limit, ...] = ()
    is_logarithmic: bool = False


@dataclass(frozen=True)
class Figure:
    """A figure as Plotly draws it, with its words.

    `closer` is a range of the abscissa worth zooming to. `traces` and `layout` hold
    JSON values only.
    """

    key: str
    title: str
    caption: str
    note: str
    height: int
    traces: list[dict[str, Any]] = field(repr=False)
    layout: dict[str, Any] = field(repr=False)
    closer: tuple[float, float] | None = None


def packed(values: Floats) -> dict[str, str]:
    """Return numbers as Plotly's typed array: seven digits in a third of the space."""
    content = np.ascontiguousarray(values, dtype="<f4").tobytes()
    array = {"dtype": "f4", "bdata": base64.b64encode(content).decode("ascii")}
    shape = ", ".join(str(length) for length in values.shape)
    return array if values.ndim == 1 else array | {"shape": shape}


def stack(
    rows: Sequence[Row], abscissa: str
) -> tuple[list[dict[str, Any]], dict[str, Any], int]:
    """Return traces, layout and height of rows one above the other."""
    height = 1 / (len(rows) + _BETWEEN_ROWS * (len(rows) - 1))
    layout = base_layout(abscissa)
    traces: list[dict[str, Any]] = []
    told: set[str] = set()
    for number, row in enumerate(rows, start=1):
        top = 1 - (number - 1) * height * (1 + _BETWEEN_ROWS)
        layout[_axis("yaxis", number)] = axis(
            row.label,
            domain=[max(top - height, 0.0), top],
            **_ordinate(row),
        )
        traces += _traces(row, _axis("y", number), told)
    layout["xaxis"] |= {"anchor": _axis("y", len(rows)), "mirror": "all"}
    pixels = _MARGIN + _ROW_HEIGHT * len(rows)
    return traces, layout | {"height": pixels}, pixels


def base_layout(abscissa: str) -> dict[str, Any]:
    """Return what all figures have in common."""
    return {
        "font": {"family": "Arial, Helvetica, sans-serif", "size": 12, "color": BLACK},
        "paper_bgcolor": "white",
        "plot_bgcolor": "white",
        # Fixed: margins that grow with their labels are late when a page is printed.
        "margin": {"l": 88, "r": 20, "t": 40, "b": 50, "autoexpand": False},
        "hovermode": "closest",
        "legend": {
            "orientation": "h",
            "x": 0,
            "y": 1,
            "yanchor": "bottom",
            "bgcolor": "rgba(255,255,255,0)",
        },
        "xaxis": axis(abscissa),
    }


def axis(label: str, **more: Any) -> dict[str, Any]:
    """Return an axis with a frame and a light grid."""
    return {
        "title": {"text": typeset(label), "standoff": 8},
        "showline": True,
        "mirror": True,
        "linecolor": GREY,
        "gridcolor": "#e0e0e0",
        "zeroline": False,
        "ticks": "outside",
        "exponentformat": "power",
        **more,
    }


def _axis(name: str, number: int) -> str:
    return name if number == 1 else f"{name}{number}"


def logarithmic(low: float, high: float) -> dict[str, Any]:
    """Return a logarithmic axis from `low` to `high` with ticks at round values."""
    ends = [float(np.log10(low)), float(np.log10(high))]
    if ends[1] - ends[0] > _DECADES:
        apart = int(np.ceil((ends[1] - ends[0]) / _TICKS))
        return {"type": "log", "range": ends, "dtick": apart}
    powers = range(int(np.floor(ends[0])), int(np.ceil(ends[1])) + 1)
    digits = (1, 2, 5) if ends[1] - ends[0] > 1 else (1, 1.5, 2, 3, 4, 5, 7)
    ticks = [digit * 10.0**power for power in powers for digit in digits]
    shown = [tick for tick in ticks if low <= tick <= high]
    words = [f"{tick:g}" for tick in shown]
    return {"type": "log", "range": ends, "tickvals": shown, "ticktext": words}


def _ordinate(row: Row) -> dict[str, Any]:
    """Return an axis with room for all curves and limits of a row."""
    lowest = min([float(c.y.min()) for c in row.curves] + [x.value for x in row.limits])
    highest = max(
        [float(c.y.max()) for c in row.curves] + [x.value for x in row.limits]
    )
    if row.is_logarithmic and lowest > 0:
        air = (highest / lowest) ** _AIR
        return logarithmic(lowest / air, highest * air)
    air = _AIR * (highest - lowest) or 1.0
    return {"range": [lowest - air, highest + air]}


def _traces(row: Row, ordinate: str, told: set[str]) -> Iterator[dict[str, Any]]:
    for curve in row.curves:
        yield {
            "type": "scatter",
            "mode": "lines+markers" if curve.has_markers else "lines",
            "marker": {"size": 4},
            "name": typeset(curve.name),
            "legendgroup": typeset(curve.name),
            "showlegend": curve.name not in told,
            "x": packed(curve.x),
            "y": packed(curve.y),
            "yaxis": ordinate,
            "line": {"color": curve.colour, "width": curve.width},
            "hovertemplate": "%{x:.4f}: %{y:.4g}",
        }
        told.add(curve.name)
    for number, limit in enumerate(row.limits):
        # Words at either end in turn, so that two limits close together can be read.
        at_start = number % 2 == 1
        ends = [min(c.x[0] for c in row.curves), max(c.x[-1] for c in row.curves)]
        yield {
            "type": "scatter",
            "mode": "lines+text",
            "x": [float(end) for end in ends],
            "y": [limit.value] * 2,
            "yaxis": ordinate,
            "line": {"color": BLACK, "width": 1.2, "dash": "dash"},
            "text": [typeset(limit.text), ""]
            if at_start
            else ["", typeset(limit.text)],
            "textposition": "top right" if at_start else "top left",
            "textfont": {"size": _SMALL, "color": BLACK},
            "showlegend": False,
            "hoverinfo": "skip",
        }

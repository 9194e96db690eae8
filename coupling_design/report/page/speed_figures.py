"""Campbell diagram and steady vibratory torque over the speed range."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from coupling_design.flow.speed_map import CouplingSpeeds, SpeedMap
from coupling_design.machine.words import Plan
from coupling_design.report.page.figure import (
    BLACK,
    GREY,
    ROLE_COLOURS,
    Curve,
    Figure,
    Row,
    axis,
    base_layout,
    stack,
)
from coupling_design.report.page.typography import typeset
from coupling_design.report.words.units import displayed

_SPEED = "mean speed [rpm]"
_HEIGHT = 430
_EXACT = "Every computed point is drawn."


def speed_figures(speed_map: SpeedMap) -> tuple[Figure, ...]:
    """Return the figures of a speed map."""
    return _campbell(speed_map), _vibration(speed_map)


def _couplings(speed_map: SpeedMap) -> tuple[CouplingSpeeds, ...]:
    both = (speed_map.present, speed_map.chosen)
    return tuple(coupling for coupling in both if coupling is not None)


def _campbell(speed_map: SpeedMap) -> Figure:
    layout = base_layout(_SPEED) | {"height": _HEIGHT}
    speeds = displayed(speed_map.speeds, "rad/s")
    lowest_modes = [c.natural_frequencies[0] for c in _couplings(speed_map)]
    top = 1.08 * float(max(speed_map.order_lines.max(), *lowest_modes))
    layout["xaxis"]["range"] = [float(speeds[0]), float(speeds[-1])]
    layout["yaxis"] = axis("frequency [Hz]", range=[0.0, top])
    layout["shapes"] = [_working_range(speed_map)]
    traces = [*_orders(speed_map, speeds)]
    for coupling in _couplings(speed_map):
        traces += [
            *_forbidden(coupling, speed_map),
            *_modes(coupling, speeds, top),
            _critical(coupling),
        ]
    caption = (
        "Excitation orders (grey) against natural frequencies, undamped, gap closed. "
        "Shaded: working speeds. Broad along an order: where it is within sqrt 2 of "
        "the lowest mode, forbidden to that coupling's plan. A circle marks a critical "
        "speed far enough from them, a cross one that is not."
    )
    return Figure(
        "campbell", "Campbell diagram", caption, _EXACT, _HEIGHT, traces, layout
    )


def _orders(speed_map: SpeedMap, speeds: Any) -> Iterator[dict[str, Any]]:
    for order, line in _lines(speed_map):
        yield {
            "type": "scatter",
            "mode": "lines+text",
            "x": [float(speed) for speed in speeds],
            "y": [float(frequency) for frequency in line],
            "text": ["", f"order {order:g}"],
            "textposition": "top left",
            "line": {"color": GREY, "width": 1.2},
            "showlegend": False,
            "hoverinfo": "skip",
        }


def _forbidden(
    coupling: CouplingSpeeds, speed_map: SpeedMap
) -> Iterator[dict[str, Any]]:
    """Yield the part of each order's line that is forbidden to the coupling."""
    slowest, fastest = (float(speed) for speed in speed_map.speeds)
    for band in coupling.forbidden_bands:
        is_soft = band.plan is Plan.ELASTIC
        ends = (slowest, band.border) if is_soft else (band.border, fastest)
        inside = [min(max(end, slowest), fastest) for end in ends]
        if inside[0] == inside[1]:
            continue
        yield {
            "type": "scatter",
            "mode": "lines",
            "x": [float(displayed(speed, "rad/s")) for speed in inside],
            "y": [
                float(np.interp(speed, speed_map.speeds, line))
                for speed in inside
                for order, line in _lines(speed_map)
                if order == band.order
            ],
            "line": {"color": ROLE_COLOURS[coupling.name], "width": 7},
            "opacity": 0.35,
            "showlegend": False,
            "hoverinfo": "skip",
        }


def _lines(speed_map: SpeedMap) -> Iterator[tuple[float, Any]]:
    yield from zip(speed_map.orders, speed_map.order_lines, strict=True)


def _modes(
    coupling: CouplingSpeeds, speeds: Any, top: float
) -> Iterator[dict[str, Any]]:
    shown = [float(f) for f in coupling.natural_frequencies if f <= top]
    for mode, frequency in enumerate(shown, start=1):
        yield {
            "type": "scatter",
            "mode": "lines",
            "name": typeset(f"{coupling.name}: {coupling.label}"),
            "showlegend": mode == 1,
            "x": [float(speed) for speed in speeds],
            "y": [frequency] * len(speeds),
            "line": {"color": ROLE_COLOURS[coupling.name], "width": 2},
            "hovertemplate": f"mode {mode}: %{{y:.4g}} Hz<extra></extra>",
        }


def _critical(coupling: CouplingSpeeds) -> dict[str, Any]:
    critical = coupling.critical_speeds
    return {
        "type": "scatter",
        "mode": "markers",
        "x": [float(displayed(c.speed, "rad/s")) for c in critical],
        "y": [c.natural_frequency for c in critical],
        "text": [f"order {c.order:g}, mode {c.mode}" for c in critical],
        "marker": {
            "symbol": ["circle" if c.passes else "x" for c in critical],
            "size": 10,
            "color": ROLE_COLOURS[coupling.name],
            "line": {"color": BLACK, "width": 1.5},
        },
        "showlegend": False,
        "hovertemplate": "%{text}: %{x:.4g} rpm, %{y:.4g} Hz<extra></extra>",
    }


def _vibration(speed_map: SpeedMap) -> Figure:
    curves = tuple(
        Curve(
            f"{coupling.name}: {coupling.label}",
            displayed(coupling.vibration.speeds, "rad/s"),
            displayed(coupling.vibration.vibratory_torque_sum, "N*m"),
            ROLE_COLOURS[coupling.name],
            2.0,
        )
        for coupling in _couplings(speed_map)
    )
    row = Row("T_W, sum of all orders [kN*m]", curves, is_logarithmic=True)
    traces, layout, height = stack([row], _SPEED)
    height += 100
    layout |= {"height": height, "shapes": [_working_range(speed_map)]}
    ends = displayed(np.asarray(speed_map.speeds, dtype=float), "rad/s")
    layout["xaxis"]["range"] = [float(end) for end in ends]
    caption = (
        "Vibratory torque T_W in the coupling after DIN 740-2, steady and linear, gap "
        "closed, as if the crests of all orders met; from the orders of the case and "
        "no others. Shaded: working speeds."
    )
    return Figure(
        "vibration",
        "Steady vibratory torque",
        caption,
        _EXACT,
        height,
        traces,
        layout,
    )


def _working_range(speed_map: SpeedMap) -> dict[str, Any]:
    lowest, highest = (displayed(w, "rad/s") for w in speed_map.working_speed)
    return {
        "type": "rect",
        "x0": lowest,
        "x1": highest,
        "y0": 0,
        "y1": 1,
        "yref": "paper",
        "fillcolor": "#ececec",
        "line": {"width": 0},
        "layer": "below",
    }

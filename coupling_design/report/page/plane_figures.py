"""Damage and peak force over the design space, with limits and points of note."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from coupling_design.flow.outcome import DesignOutcome
from coupling_design.report.console.maps import time_step_note
from coupling_design.report.page.figure import (
    BLACK,
    GREY,
    Curve,
    Figure,
    Limit,
    Row,
    axis,
    base_layout,
    packed,
    stack,
)
from coupling_design.report.page.run_down_figures import force_limits
from coupling_design.report.page.stiffness_span import (
    left_out,
    plane_label,
    stiffness_axis,
)
from coupling_design.report.page.typography import typeset
from coupling_design.report.words.units import displayed
from coupling_design.search.design_map import DesignMap
from coupling_design.wear.performance import Performance

_STIFFNESS = "C_Tdyn [MN*m/rad]"
_DAMAGE = "D [-]"
_PEAK = "peak F_c [kN]"
_SYMBOLS = {"present": "circle", "optimum": "diamond", "chosen": "star"}
_PANEL = 280  # pixels
_CAPTION = (
    "Damage of the bearing that suffers more and peak transmission force of one "
    "run-down. {points} Grey: stiffnesses of the type that the limits on the natural "
    "frequency leave out."
)


@dataclass(frozen=True)
class _Point:
    """A design marked in a plane."""

    name: str
    performance: Performance


def plane_figure(outcome: DesignOutcome, map_: DesignMap, key: str) -> Figure:
    """Return a map as a figure: over stiffness alone where the gap is fixed."""
    points = tuple(_points(outcome, map_))
    limits = tuple(force_limits(outcome))
    if len(map_.key_gap) == 1:
        return _over_stiffness(outcome, map_, key, points, limits)
    return _over_plane(outcome, map_, key, points, limits)


def _points(outcome: DesignOutcome, map_: DesignMap) -> Iterator[_Point]:
    """Yield the designs that lie in the plane of a map."""
    baseline, chosen = outcome.baseline, outcome.chosen
    if map_.name == plane_label(baseline.coupling_type, baseline.connection):
        yield _Point("present", baseline.performance)
    for step in outcome.steps:
        best = step.optimum
        if map_ not in step.maps or best is None:
            continue
        if map_.name == plane_label(best.coupling_type, best.connection):
            yield _Point("optimum", best.performance)
    if chosen:
        name = chosen.size or chosen.coupling_type
        if map_.name == plane_label(name, chosen.connection):
            yield _Point("chosen", chosen.performance)


def _over_stiffness(
    outcome: DesignOutcome,
    map_: DesignMap,
    key: str,
    points: Sequence[_Point],
    limits: tuple[Limit, ...],
) -> Figure:
    stiffness = displayed(np.array(map_.torsional_stiffness), "N*m/rad")
    force = displayed(np.array(map_.peak_transmission_force[0]), "N")
    damage = np.array(map_.damage[0])
    rows = (
        Row(_DAMAGE, (Curve("rolled out", stiffness, damage, GREY, has_markers=True),)),
        Row(
            _PEAK,
            (Curve("rolled out", stiffness, force, GREY, has_markers=True),),
            limits,
        ),
    )
    traces, layout, height = stack(rows, _STIFFNESS)
    for point in points:
        traces += [_marker(point, _damage(point), "y", "x")]
        traces += [_marker(point, _force(point), "y2", "x") | {"showlegend": False}]
    layout["xaxis"] |= stiffness_axis(outcome, map_)
    layout["shapes"] = left_out(outcome, map_)
    said = f"{len(stiffness)} stiffnesses at a gap of {_gap(map_.key_gap[0])} mm."
    note = "Every point is one run-down; between two points the line only joins them."
    caption = _CAPTION.format(points=said)
    return Figure(key, _title(map_), caption, note, height, traces, layout)


def _over_plane(
    outcome: DesignOutcome,
    map_: DesignMap,
    key: str,
    points: Sequence[_Point],
    limits: tuple[Limit, ...],
) -> Figure:
    layout = base_layout(_STIFFNESS)
    layout["xaxis"] |= stiffness_axis(outcome, map_) | {"anchor": "y2"}
    layout["yaxis"] = axis("gap [mm]", domain=[0.55, 1.0])
    layout["yaxis2"] = axis("gap [mm]", domain=[0.0, 0.45])
    damage = np.array(map_.damage)
    force = displayed(np.array(map_.peak_transmission_force), "N")
    traces = [
        _heat(map_, damage, _DAMAGE, "y", 0.775),
        _heat(map_, force, _PEAK, "y2", 0.225),
        *(_border(map_, force, limit) for limit in limits),
    ]
    for point in points:
        gap = displayed(float(point.performance.key_gap), "m")
        traces += [_marker(point, gap, "y", "x")]
        traces += [_marker(point, gap, "y2", "x") | {"showlegend": False}]
    layout["shapes"] = left_out(outcome, map_)
    said = f"{len(map_.torsional_stiffness)} stiffnesses at {len(map_.key_gap)} gaps."
    note = (
        "Every cell is one run-down, nothing between is smoothed. Lines mark where "
        "peak F_c meets a limit; a limit without a line is met everywhere or nowhere. "
        f"{time_step_note(map_)}"
    )
    caption = _CAPTION.format(points=said)
    height = 2 * _PANEL
    layout["height"] = height
    layout["margin"] |= {"r": 110}
    return Figure(key, _title(map_), caption, note, height, traces, layout)


def _heat(
    map_: DesignMap, values: Any, label: str, ordinate: str, middle: float
) -> dict[str, Any]:
    return {
        "type": "heatmap",
        **_place(map_, ordinate),
        "z": packed(values),
        "colorscale": "Cividis",
        "colorbar": {
            "title": {"text": typeset(label), "side": "top"},
            "len": 0.45,
            "y": middle,
            "thickness": 14,
            "exponentformat": "power",
        },
        "hovertemplate": "%{x:.4g} MN*m/rad, %{y:.4g} mm: %{z:.4g}<extra></extra>",
    }


def _border(map_: DesignMap, force: Any, limit: Limit) -> dict[str, Any]:
    return {
        "type": "contour",
        **_place(map_, "y2"),
        "z": packed(force),
        "contours": {
            "start": limit.value,
            "end": limit.value,
            "size": 1,
            "coloring": "none",
            "showlabels": True,
        },
        "line": {"color": "white", "width": 2.5},
        "name": limit.text,
        "showlegend": False,
        "showscale": False,
        "hoverinfo": "skip",
    }


def _place(map_: DesignMap, ordinate: str) -> dict[str, Any]:
    return {
        "x": packed(displayed(np.array(map_.torsional_stiffness), "N*m/rad")),
        "y": packed(displayed(np.array(map_.key_gap), "m")),
        "yaxis": ordinate,
    }


def _marker(
    point: _Point, height: float, ordinate: str, abscissa: str
) -> dict[str, Any]:
    stiffness = float(point.performance.torsional_stiffness)
    return {
        "type": "scatter",
        "mode": "markers",
        "name": point.name,
        "x": [displayed(stiffness, "N*m/rad")],
        "y": [height],
        "xaxis": abscissa,
        "yaxis": ordinate,
        "marker": {
            "symbol": _SYMBOLS[point.name],
            "size": 13,
            "color": "white",
            "line": {"color": BLACK, "width": 2},
        },
        "cliponaxis": False,
    }


def _damage(point: _Point) -> float:
    return point.performance.damage


def _force(point: _Point) -> float:
    return float(displayed(float(point.performance.peak_transmission_force), "N"))


def _gap(gap: float) -> str:
    return f"{displayed(gap, 'm'):.4g}"


def _title(map_: DesignMap) -> str:
    return f"Design space of {map_.name}"

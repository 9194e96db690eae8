"""How far along stiffness a map's figure reaches, and what the limits leave out."""

from __future__ import annotations

from typing import Any

from coupling_design.flow.outcome import DesignOutcome
from coupling_design.report.page.figure import logarithmic
from coupling_design.report.words.names import words
from coupling_design.report.words.units import displayed
from coupling_design.search.design_map import DesignMap


def stiffness_axis(outcome: DesignOutcome, map_: DesignMap) -> dict[str, Any]:
    """Return what sets the axis of stiffness apart from others."""
    low, high = _span(outcome, map_)
    return logarithmic(displayed(low, "N*m/rad"), displayed(high, "N*m/rad"))


def left_out(outcome: DesignOutcome, map_: DesignMap) -> list[dict[str, Any]]:
    """Return grey areas over the stiffnesses of the type that the map leaves out.

    One for each of the two rows of the figure.
    """
    low, high = _span(outcome, map_)
    first, last = map_.torsional_stiffness[0], map_.torsional_stiffness[-1]
    return [
        {
            "type": "rect",
            "x0": displayed(start, "N*m/rad"),
            "x1": displayed(end, "N*m/rad"),
            "y0": 0,
            "y1": 1,
            "xref": "x",
            "yref": reference,
            "fillcolor": "#d9d9d9",
            "line": {"width": 0},
            "layer": "below",
        }
        for start, end in ((low, first), (last, high))
        for reference in ("y domain", "y2 domain")
        if end > start
    ]


def _span(outcome: DesignOutcome, map_: DesignMap) -> tuple[float, float]:
    """Return the stiffness that a figure spans: all that the type is made with."""
    first, last = map_.torsional_stiffness[0], map_.torsional_stiffness[-1]
    for kind in outcome.case.coupling_types:
        labels = {plane_label(kind.name, each) for each in kind.connections}
        if map_.name in labels:
            low, high = kind.stiffness_range
            return min(low, first), max(high, last)
    return first, last


def plane_label(coupling_type: str, connection: str) -> str:
    """Return the name that a map of this type and connection has."""
    return f"{coupling_type}, {words(connection)}"

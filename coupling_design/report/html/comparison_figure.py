"""The present design against the one beside it, quantity by quantity."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from coupling_design.design.results import DesignOutcome, Performance
from coupling_design.report.html.figure import (
    ROLE_COLOURS,
    Figure,
    axis,
    base_layout,
)
from coupling_design.report.html.typography import typeset
from coupling_design.report.units import display_unit, displayed, quantity

_HEIGHT = 300
_BETWEEN = 0.02
_ROOM = 1.15


def comparison_figure(outcome: DesignOutcome) -> Figure | None:
    """Return bars of damage and peaks, None where nothing stands beside the present."""
    other = outcome.chosen or outcome.nearest
    if other is None:
        return None
    role = "chosen" if outcome.chosen else "nearest"
    designs = {"present": outcome.baseline.performance, role: other.performance}
    panels = list(
        zip(*(list(_quantities(outcome, d)) for d in designs.values()), strict=True)
    )
    layout = base_layout("") | {"height": _HEIGHT, "showlegend": False}
    layout["margin"] |= {"l": 10, "r": 10, "t": 20, "b": 70}
    width = (1 - _BETWEEN * (len(panels) - 1)) / len(panels)
    traces: list[dict[str, Any]] = []
    for n, panel in enumerate(panels):
        start, suffix = n * (width + _BETWEEN), str(n + 1) if n else ""
        label, unit, _ = panel[0]
        layout[f"xaxis{suffix}"] = axis(
            label,
            domain=[start, start + width],
            anchor=f"y{suffix}",
            type="category",
            tickangle=0,
        )
        layout[f"xaxis{suffix}"]["title"]["text"] += f"<br>[{display_unit(unit)}]"
        layout[f"yaxis{suffix}"] = axis(
            "", range=_range(panel), anchor=f"x{suffix}", showticklabels=False
        )
        traces.append(_bars(list(designs), panel, suffix))
    return Figure(
        "comparison",
        "Damage and peaks",
        "Damage per run-down and largest force and loads, each over its own scale.",
        "Numbers on the bars are those of the table.",
        _HEIGHT,
        traces,
        layout,
    )


def _quantities(
    outcome: DesignOutcome, performance: Performance
) -> Iterator[tuple[str, str, float]]:
    names = [bearing.name for bearing in outcome.case.bearings]
    for name, damage in zip(names, performance.damages, strict=True):
        yield f"D, {name}", "", float(damage)
    yield "peak F_c", "N", float(performance.peak_transmission_force)
    for name, load in zip(names, performance.peak_combined_load, strict=True):
        yield f"peak F_l, {name}", "N", float(load)


def _range(panel: tuple[tuple[str, str, float], ...]) -> list[float]:
    """Return an ordinate from zero, with room for the number above the tallest bar."""
    return [0.0, _ROOM * max(displayed(value, unit) for _, unit, value in panel)]


def _bars(
    roles: list[str], panel: tuple[tuple[str, str, float], ...], suffix: str
) -> dict[str, Any]:
    return {
        "type": "bar",
        "x": roles,
        "y": [displayed(value, unit) for _, unit, value in panel],
        "text": [typeset(quantity(value, unit)) for _, unit, value in panel],
        "textposition": "outside",
        "textangle": 0,
        "constraintext": "none",
        "cliponaxis": False,
        "marker": {"color": [ROLE_COLOURS[role] for role in roles]},
        "xaxis": f"x{suffix}",
        "yaxis": f"y{suffix}",
        "hovertemplate": "%{x}: %{y:.4g}<extra></extra>",
    }

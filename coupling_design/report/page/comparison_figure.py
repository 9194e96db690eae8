"""The present design against the one beside it, quantity by quantity."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from coupling_design.flow.outcome import DesignOutcome
from coupling_design.report.console.performances import Measured
from coupling_design.report.page.figure import (
    ROLE_COLOURS,
    Figure,
    axis,
    base_layout,
)
from coupling_design.report.page.tables import compared_designs
from coupling_design.report.page.typography import typeset
from coupling_design.report.words.damages import damage
from coupling_design.report.words.units import display_unit, displayed, quantity

_HEIGHT = 300
_BETWEEN = 0.02  # of the figure's width
_ROOM = 1.15  # of the tallest bar, for the number above it


@dataclass(frozen=True)
class _Bar:
    """One quantity of one design; `value` in the unit shown, `text` as in the table."""

    label: str
    unit: str
    role: str
    value: float
    text: str


def comparison_figure(outcome: DesignOutcome) -> Figure | None:
    """Return bars of damage and peaks, None where nothing stands beside the present."""
    designs = tuple(compared_designs(outcome))
    if len(designs) < 2:
        return None
    panels = list(zip(*(_bars(outcome, design) for design in designs), strict=True))
    layout = base_layout("") | {"height": _HEIGHT, "showlegend": False}
    layout["margin"] |= {"l": 10, "r": 10, "t": 20, "b": 70}
    width = (1 - _BETWEEN * (len(panels) - 1)) / len(panels)
    for n, panel in enumerate(panels):
        suffix, start = _suffix(n), n * (width + _BETWEEN)
        layout |= _axes(panel, suffix, [start, start + width])
    return Figure(
        "comparison",
        "Damage and peaks",
        "Damage per run-down and largest force and loads, each over its own scale.",
        "Numbers on the bars are those of the table.",
        _HEIGHT,
        [_trace(panel, _suffix(n)) for n, panel in enumerate(panels)],
        layout,
    )


def _bars(outcome: DesignOutcome, design: Measured) -> Iterator[_Bar]:
    names = [bearing.name for bearing in outcome.case.bearings]
    performance, role = design.performance, design.heading
    for name, sum_ in zip(names, performance.damages, strict=True):
        text = damage(sum_, design.digits)
        yield _Bar(f"D, {name}", "-", role, float(sum_), text)
    forces = (
        ("peak F_c", performance.peak_transmission_force),
        *zip(
            (f"peak F_l, {name}" for name in names),
            performance.peak_combined_load,
            strict=True,
        ),
    )
    for label, force in forces:
        value = displayed(float(force), "N")
        yield _Bar(label, display_unit("N"), role, value, quantity(force, "N"))


def _suffix(number: int) -> str:
    return str(number + 1) if number else ""


def _axes(panel: Sequence[_Bar], suffix: str, domain: list[float]) -> dict[str, Any]:
    """Return a panel's axes, the ordinate from zero."""
    abscissa = axis(
        panel[0].label,
        domain=domain,
        anchor=f"y{suffix}",
        type="category",
        tickangle=0,
    )
    abscissa["title"]["text"] += f"<br>[{panel[0].unit}]"
    ordinate = axis(
        "",
        range=[0.0, _ROOM * max(bar.value for bar in panel)],
        anchor=f"x{suffix}",
        showticklabels=False,
    )
    return {f"xaxis{suffix}": abscissa, f"yaxis{suffix}": ordinate}


def _trace(panel: Sequence[_Bar], suffix: str) -> dict[str, Any]:
    return {
        "type": "bar",
        "x": [bar.role for bar in panel],
        "y": [bar.value for bar in panel],
        "text": [typeset(bar.text) for bar in panel],
        "textposition": "outside",
        "textangle": 0,
        "constraintext": "none",
        "cliponaxis": False,
        "marker": {"color": [ROLE_COLOURS[bar.role] for bar in panel]},
        "xaxis": f"x{suffix}",
        "yaxis": f"y{suffix}",
        "hovertemplate": "%{x}: %{y:.4g}<extra></extra>",
    }

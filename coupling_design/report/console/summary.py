"""The chosen design against every limit in one table, and the strict reading."""

from __future__ import annotations

from rich.panel import Panel
from rich.text import Text

from coupling_design.flow.outcome import ChosenDesign, DesignOutcome
from coupling_design.flow.outcome import LoadReading as StrictReading
from coupling_design.report.console.blocks import panel
from coupling_design.report.console.limits import render_criteria
from coupling_design.report.words.chances import describe_at_once
from coupling_design.report.words.names import VERDICT_STYLES, words
from coupling_design.report.words.units import quantity
from coupling_design.report.words.verdicts import describe_strict


def render_summary(outcome: DesignOutcome, chosen: ChosenDesign) -> Panel:
    """Return every limit of the chosen design: value, limit, margin, verdict."""
    bound = describe_at_once(outcome.case, chosen)
    return panel(
        "Summary: the chosen coupling against its limits",
        (
            render_criteria(
                f"Load limit read as {words(outcome.case.reading)}",
                chosen.criteria,
            ),
            Text(bound) if bound else None,
        ),
        style="green",
    )


def render_strict_reading(outcome: DesignOutcome, strict: StrictReading) -> Panel:
    """Return the design's verdict when the load limit is read strictly."""
    style = "green" if strict.passes else "red"
    shown = outcome.chosen or outcome.nearest
    word = "PASS" if strict.passes else "FAIL"
    parts = [Text(describe_strict(strict), style=VERDICT_STYLES[word])]
    if shown is not None:
        whose = "chosen" if outcome.chosen else "nearest"
        force = quantity(shown.performance.peak_transmission_force, "N")
        parts.append(
            Text(
                f"The limits above are read as {words(outcome.case.reading)}. The "
                f"{whose} design's F_c reaches {force} kN; at the bearings that makes:"
            )
        )
    return panel(
        f"Strict reading of the load limit: {word}",
        (*parts, render_criteria("Limits", strict.criteria)),
        style=style,
    )

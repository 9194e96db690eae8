"""The whole report, from the question to the run time."""

from __future__ import annotations

from collections.abc import Iterable

from rich.console import Group, RenderableType
from rich.text import Text

from coupling_design.flow.outcome import DesignOutcome
from coupling_design.report.console.assumptions import render_assumptions
from coupling_design.report.console.blocks import titled
from coupling_design.report.console.designs import (
    render_baseline,
    render_chosen,
    render_nearest,
)
from coupling_design.report.console.header import render_header
from coupling_design.report.console.sizes import render_catalogue
from coupling_design.report.console.steps import render_step
from coupling_design.report.console.summary import render_strict_reading, render_summary
from coupling_design.report.console.validity import render_validity
from coupling_design.report.words.effort import effort_sentence
from coupling_design.report.words.verdicts import render_verdict


def render_outcome(outcome: DesignOutcome) -> Group:
    """Return the report of a run."""
    return Group(*_parts(outcome))


def _parts(outcome: DesignOutcome) -> Iterable[RenderableType]:
    yield render_header(outcome)
    yield render_baseline(outcome)
    yield from map(render_step, outcome.steps)
    if outcome.chosen is None:
        yield render_nearest(outcome)
    else:
        yield render_chosen(outcome, outcome.chosen)
        yield render_summary(outcome, outcome.chosen)
    if outcome.catalogue_choice is not None:
        yield render_catalogue(outcome.catalogue_choice)
    if outcome.strict_reading is not None:
        yield render_strict_reading(outcome, outcome.strict_reading)
    yield render_assumptions(outcome.case, outcome.assumptions)
    yield render_validity(outcome)
    yield titled("Result", render_verdict(outcome))
    yield Text(effort_sentence(outcome))

"""A panel per step of the flow: question, what was examined, limits, caveats."""

from __future__ import annotations

from collections.abc import Iterable

from rich.console import Group
from rich.panel import Panel
from rich.text import Text

from coupling_design.report.console.blocks import bullets, facts, panel, titled
from coupling_design.report.console.limits import render_criteria
from coupling_design.report.console.maps import render_map
from coupling_design.report.console.performances import (
    render_alternatives,
    render_design,
)
from coupling_design.report.words.damages import damage_e6
from coupling_design.report.words.names import words
from coupling_design.report.words.numbers import change
from coupling_design.search.optimum import Optimum
from coupling_design.steps.step_result import Decision, StepResult
from coupling_design.wear.conditioning import Conditioning

_BORDERS = {Decision.PASS: "green", Decision.FAIL: "red", Decision.SKIPPED: "none"}


def render_step(result: StepResult) -> Panel:
    """Return what a step asked, examined and decided."""
    return panel(
        f"Step {result.step}: {result.title} - {result.decision.upper()}",
        (
            Text(result.question, style="italic"),
            bullets("Examined", result.findings),
            render_alternatives(result.alternatives),
            *(render_map(map_) for map_ in result.maps),
            None if result.optimum is None else render_optimum(result.optimum),
            render_criteria("Limits", result.criteria),
            bullets("Caveats", result.caveats),
        ),
        style=_BORDERS[result.decision],
    )


def render_optimum(optimum: Optimum) -> Group:
    """Return where an optimisation ended and how far that can be trusted."""
    digits = None if optimum.conditioning is None else optimum.conditioning.digits
    name = f"{optimum.coupling_type}, {words(optimum.connection)}"
    return titled(
        f"Optimum: least {optimum.objective}",
        Group(
            render_design(name, optimum.performance, digits),
            Text(),
            facts(evidence(optimum, digits)),
        ),
    )


def _agreement(optimum: Optimum) -> Iterable[tuple[str, str]]:
    """Yield what was compared: ends of starts, or valleys of which one is lowest."""
    if optimum.method == "bounded search":
        others = optimum.starts - optimum.starts_agreeing
        yield (
            "valleys",
            f"{optimum.starts} of the smallest load compared; {others} are higher",
        )
    else:
        yield "starts agreed", f"{optimum.starts_agreeing} of {optimum.starts}"


def describe_conditioning(conditioning: Conditioning) -> str:
    """Return how far damage and peak move, and how many digits that leaves."""
    by_start = change(conditioning.damage_change_by_start)
    by_step = change(conditioning.damage_change_by_step)
    peak = change(conditioning.peak_change_by_step)
    return (
        f"{_digits(conditioning.digits)}; the damage moves by {by_start} (relative) "
        f"when the start is shifted by 1e-12 rad and by {by_step} when the time step "
        f"is halved, the peak force then by {peak}"
    )


def _digits(digits: int) -> str:
    return f"{digits} digit{'' if digits == 1 else 's'} of the damage stand"


def evidence(optimum: Optimum, digits: int | None) -> Iterable[tuple[str, str]]:
    """Yield how an optimum was found and how firmly it stands."""
    yield "paper's unit", f"D x 1e6 = {damage_e6(optimum.performance.damage, digits)}"
    if optimum.method == "scan":
        yield "method", "best verified point of the scan; Ipopt gave nothing better"
    else:
        yield "method", "Ipopt" if optimum.method == "ipopt" else optimum.method
    yield "solver status", optimum.solver_status
    yield from _agreement(optimum)
    yield "effort", f"{optimum.scan_points} scan points, {optimum.rollouts} rollouts"
    residual = optimum.kkt_residual
    yield "KKT residual", "not available" if residual is None else change(residual)[1:]
    yield "held by", optimum.held_by
    if optimum.conditioning is None:
        yield "conditioning", "not examined for this point"
    else:
        yield "conditioning", describe_conditioning(optimum.conditioning)

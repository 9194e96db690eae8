"""The present coupling, the chosen one beside it, or the one that came nearest."""

from __future__ import annotations

from collections.abc import Iterable

from rich.console import RenderableType
from rich.panel import Panel
from rich.text import Text

from coupling_design.flow.outcome import ChosenDesign, DesignOutcome
from coupling_design.machine.coupling_type import CouplingType
from coupling_design.machine.machine import Case
from coupling_design.report.console.blocks import facts, panel
from coupling_design.report.console.limits import render_criteria
from coupling_design.report.console.performances import (
    Measured,
    render_design,
    render_quantities,
)
from coupling_design.report.console.sizes import describe_size
from coupling_design.report.console.steps import describe_conditioning
from coupling_design.report.words.chances import (
    describe_chances,
    describe_moves,
)
from coupling_design.report.words.names import words
from coupling_design.report.words.units import as_given
from coupling_design.report.words.verdicts import describe_reduction
from coupling_design.search.optimum import Optimum
from coupling_design.steps.baseline import Baseline


def render_baseline(outcome: DesignOutcome) -> Panel:
    """Return what the present coupling does."""
    baseline = outcome.baseline
    return panel(
        "Present coupling",
        (
            Text(f"{baseline.coupling_type}, {words(baseline.connection)}"),
            render_quantities([_present(baseline)], _bearings(outcome.case)),
            facts(trust(baseline)),
        ),
    )


def render_chosen(outcome: DesignOutcome, chosen: ChosenDesign) -> Panel:
    """Return the chosen coupling beside the present one."""
    baseline = outcome.baseline
    column = Measured("chosen", chosen.performance, chosen.rundown, chosen.digits)
    reduction = describe_reduction(chosen, baseline.digits)
    return panel(
        "Chosen coupling",
        (
            facts(chosen_facts(outcome.case, chosen)),
            render_quantities([_present(baseline), column], _bearings(outcome.case)),
            Text(f"Damage per run-down {reduction}.", style="bold"),
            facts(
                (
                    ("if inputs move", describe_moves(chosen.sensitivity)),
                    ("conditioning", describe_conditioning(chosen.conditioning)),
                )
            ),
        ),
        style="green",
    )


def render_nearest(outcome: DesignOutcome) -> Panel:
    """Return that there is no design, and how near the nearest came."""
    parts: list[RenderableType | None] = [
        Text(
            "No design meets the limits. The steps above say where each candidate "
            "fails."
        )
    ]
    if outcome.nearest is not None:
        parts += _nearest(outcome.nearest)
    parts.append(render_criteria("Its limits", outcome.nearest_criteria))
    return panel("No design meets the limits", parts, style="red")


def _nearest(nearest: Optimum) -> Iterable[RenderableType]:
    yield Text("Nearest to its limits came:")
    name = f"{nearest.coupling_type}, {words(nearest.connection)}"
    yield render_design(name, nearest.performance, None)


def _present(baseline: Baseline) -> Measured:
    return Measured("present", baseline.performance, baseline.rundown, baseline.digits)


def _bearings(case: Case) -> tuple[str, str]:
    first, second = case.bearings
    return first.name, second.name


def trust(baseline: Baseline) -> Iterable[tuple[str, str]]:
    """Yield how firmly the present coupling's numbers stand."""
    yield "judged over", describe_chances(baseline.performance)
    yield "if inputs move", describe_moves(baseline.sensitivity)
    yield "conditioning", describe_conditioning(baseline.conditioning)
    yield (
        "time step",
        f"{baseline.time_step:g} s; the largest stable one is "
        f"{baseline.largest_stable_step:.3g} s",
    )


def chosen_facts(case: Case, chosen: ChosenDesign) -> Iterable[tuple[str, str]]:
    """Yield what the chosen coupling is."""
    yield "plan", words(chosen.plan)
    yield "coupling type", chosen.coupling_type
    for kind in case.coupling_types:
        if kind.name == chosen.coupling_type:
            low, high = (as_given(k, "N*m/rad") for k in kind.stiffness_range)
            yield "", kind.description
            if kind.sizes:
                yield from _size_facts(kind, chosen.size)
                continue
            yield (
                "",
                f"T_KN {as_given(kind.nominal_torque, 'N*m')} kN*m, T_Kmax "
                f"{as_given(kind.maximum_torque, 'N*m')} kN*m, n_max "
                f"{as_given(kind.maximum_speed, 'rad/s')} rpm, C_Tdyn {low} to {high} "
                "MN*m/rad",
            )
    yield "connection", words(chosen.connection)


def _size_facts(series: CouplingType, chosen: str | None) -> Iterable[tuple[str, str]]:
    if chosen is None:
        low, high = (as_given(k, "N*m/rad") for k in series.stiffness_range)
        sizes = f"{len(series.sizes)} sizes, C_Tdyn {low} to {high} MN*m/rad"
        yield "", f"a series of {sizes}; the stiffness chosen lies between them"
    for size in series.sizes:
        if size.name == chosen:
            yield "size", size.name
            yield "", describe_size(size)

"""What goes with a design: what to read first, its bound, where it was cut off."""

from __future__ import annotations

from collections.abc import Iterator

from coupling_design.checks.crank import too_few_inertias
from coupling_design.checks.warnings import (
    case_warnings,
    run_down_warnings,
    stop_remark,
)
from coupling_design.flow.outcome import ChosenDesign
from coupling_design.line.parameters import FuelCutStart
from coupling_design.search.optimum import Optimum
from coupling_design.steps.so_far import FlowState
from coupling_design.wear.evaluator import Evaluator
from coupling_design.wear.performance import Performance


def outcome_warnings(
    state: FlowState, chosen: ChosenDesign | None, shown: ChosenDesign | Optimum | None
) -> Iterator[str]:
    """Yield what must be read first: of the case, of both couplings, of the model."""
    case = state.case
    yield from case_warnings(case)
    yield from run_down_warnings(case, state.baseline.performance, "Present coupling")
    if shown is None:
        return
    whose = "Chosen coupling" if chosen else "Nearest coupling"
    yield from run_down_warnings(case, shown.performance, whose)
    chain = too_few_inertias(case, float(shown.performance.natural_frequency))
    if chain is not None:
        yield f"{whose}: {chain}"


def outcome_remarks(state: FlowState, chosen: ChosenDesign | None) -> Iterator[str]:
    """Yield where a run-down was cut off."""
    shown = [("Present coupling", state.baseline.performance)]
    if chosen is not None:
        shown.append(("Chosen coupling", chosen.performance))
    for whose, performance in shown:
        told = stop_remark(state.case, performance)
        if told is not None:
            yield f"{whose}: {told}."


def fuel_cut_at_once(
    evaluator: Evaluator, performance: Performance
) -> Performance | None:
    """Return what a design does if the fuel's torque goes at once, the bound.

    None where the run-down has another equation, its fuel being cut over a time.
    """
    if evaluator.case.shutdown.fuel_cut_time:
        return None
    point = performance.torsional_stiffness, performance.key_gap
    columns = evaluator.run_downs.variables.columns([point], evaluator.chances)
    return evaluator.performances_from(columns, FuelCutStart(0.0))[0]

"""What is to be said of a design as a whole: what to read first, what was cut off."""

from __future__ import annotations

from collections.abc import Iterator

from coupling_design.design.chain_check import too_few_inertias
from coupling_design.design.results import ChosenDesign, Optimum
from coupling_design.design.state import FlowState
from coupling_design.design.warnings import (
    case_warnings,
    run_down_warnings,
    stop_remark,
)


def warnings_on(
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


def remarks_on(state: FlowState, chosen: ChosenDesign | None) -> Iterator[str]:
    """Yield where a run-down was cut off."""
    shown = [("Present coupling", state.baseline.performance)]
    if chosen is not None:
        shown.append(("Chosen coupling", chosen.performance))
    for whose, performance in shown:
        told = stop_remark(state.case, performance)
        if told is not None:
            yield f"{whose}: {told}."

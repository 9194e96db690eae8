"""What a search found, on the screen."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from rich.table import Table

from coupling_design.machine.machine import Case
from coupling_design.report.words.numbers import significant
from studies.command import table
from studies.identification.parameters import QUANTITIES, SMOOTH_CONTACT, Inputs
from studies.identification.targets import (
    TARGETS,
    misfit,
    residuals,
    targets_over_phases,
)

_PHASES = 8


def tables_of(case: Case, candidates: Mapping[str, Inputs]) -> Iterator[Table]:
    """Yield inputs that were found, and their results averaged over the crank angle."""
    sets = list(candidates.values())
    inputs = table("Inputs found", "input", "unit", *candidates)
    for q in QUANTITIES:
        shown = (significant(q.from_si(each[q.name]), 7) for each in sets)
        inputs.add_row(q.words, q.unit or "-", *shown)
    inputs.add_row("cleanliness", "", *(each.cleanliness.value for each in sets))
    yield inputs
    refinement = 1 + any(each["contact_stiffness"] > SMOOTH_CONTACT for each in sets)
    values = targets_over_phases(case, sets, _PHASES, refinement).mean(axis=1)
    off = residuals(values)
    title = "Mean over the crank angle (tolerances off)"
    made = table(title, "result", "paper", *candidates)
    for i, target in enumerate(TARGETS):
        cells = (f"{values[j, i]:.4g} ({off[j, i]:+.1f})" for j in range(len(sets)))
        made.add_row(f"{target.name}, {target.unit}", target.paper, *cells)
    made.add_row("misfit", "0", *(f"{total:.2f}" for total in misfit(values)))
    yield made

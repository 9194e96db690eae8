"""Refusing a time step at which the integration could not stay bounded."""

from __future__ import annotations

import math
from itertools import product

from coupling_design.errors import CaseError
from coupling_design.line.modes import largest_stable_step
from coupling_design.machine.candidate import Candidate, candidate_driveline
from coupling_design.machine.machine import Case


def check_time_step(case: Case) -> None:
    """Return nothing if the time step suits every candidate's stiffest driveline.

    Raises CaseError with the step that would work.
    """
    limits = {
        candidate.label: stable_step(case, candidate) for candidate in candidates(case)
    }
    label, largest = min(limits.items(), key=lambda item: item[1])
    if case.shutdown.time_step > largest:
        raise CaseError(
            [
                f"{case.place('shutdown.time_step')}: found "
                f"{case.shutdown.time_step:.4g} s, allowed at most "
                f"{_rounded_down(largest):.3g} s. "
                f"Above that the integration of {label} at its stiffest is unstable; "
                "take a smaller step, or a softer contact."
            ]
        )


def candidates(case: Case) -> tuple[Candidate, ...]:
    """Return every coupling type of a case in every connection it may have."""
    return tuple(
        Candidate(coupling_type, option)
        for coupling_type, option in product(case.coupling_types, case.connections)
        if option.kind in coupling_type.connections
    )


def stable_step(case: Case, candidate: Candidate) -> float:
    """Return the largest stable step [s] over a candidate's stiffness range."""
    return min(
        largest_stable_step(candidate_driveline(case, candidate, stiffness, 0.0))
        for stiffness in candidate.coupling_type.stiffness_range
    )


def _rounded_down(step: float) -> float:
    """Return a step to three digits, never above it: what is proposed must work."""
    unit: float = 10.0 ** (math.floor(math.log10(step)) - 2)
    return math.floor(step / unit) * unit

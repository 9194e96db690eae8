"""The couplings that every study compares, as evaluators of a case."""

from __future__ import annotations

import functools
import math

import numpy as np

from coupling_design.events.recording import simulate
from coupling_design.line.motion import reduced_inertia
from coupling_design.machine.candidate import Candidate
from coupling_design.machine.machine import Case
from coupling_design.machine.words import ConnectionKind, Plan
from coupling_design.signals.history import History
from coupling_design.steps.limits import high_frequency_constraint
from coupling_design.steps.present import present_candidate
from coupling_design.steps.so_far import connection_option
from coupling_design.wear.evaluator import Evaluator
from coupling_design.wear.performance import Performance

# Stiffnesses, spaced by ratio, at which an elastic type is looked at.
ELASTIC_POINTS = 41


@functools.cache
def evaluator(case: Case, candidate: Candidate) -> Evaluator:
    """Return the evaluator of a candidate, built once."""
    return Evaluator(case, candidate)


def present(case: Case) -> Evaluator:
    """Return the present coupling in the present connection."""
    return evaluator(case, present_candidate(case))


def present_tightly_fitted(case: Case) -> Evaluator:
    """Return the present coupling with its hub shrunk on: no key, no gap."""
    tight = connection_option(case, ConnectionKind.TIGHT_FIT)
    return evaluator(case, Candidate(present_candidate(case).coupling_type, tight))


def present_point(case: Case) -> tuple[float, float]:
    """Return present stiffness [N m/rad] and gap [m]."""
    driveline = case.driveline
    return driveline.coupling.torsional_stiffness, getattr(
        driveline.connection, "gap", 0.0
    )


@functools.cache
def present_performance(case: Case) -> Performance:
    """Return what the present coupling does."""
    return present(case).performance(*present_point(case))


def high_stiffness(case: Case) -> Evaluator:
    """Return the first coupling of the high-stiffness plan, tightly fitted."""
    stiff = next(t for t in case.coupling_types if t.plan is Plan.HIGH_STIFFNESS)
    tight = connection_option(case, ConnectionKind.TIGHT_FIT)
    return evaluator(case, Candidate(stiff, tight))


def required_stiffness(case: Case) -> float:
    """Return the lowest stiffness that step 4 admits in a tight fit [N m/rad]."""
    omega = 2 * math.pi * float(high_frequency_constraint(case).limit)
    return omega**2 * float(reduced_inertia(case.driveline))


@functools.cache
def high_stiffness_performance(case: Case) -> Performance:
    """Return what the high-stiffness coupling does at the lowest stiffness admitted."""
    return high_stiffness(case).performance(required_stiffness(case), 0.0)


def history_of(candidate: Evaluator, stiffness: float, gap: float) -> History:
    """Return the history of a design point's run-down."""
    return simulate(candidate.driveline(stiffness, gap), candidate.case.shutdown)


@functools.cache
def present_history(case: Case) -> History:
    """Return the history of the present coupling's run-down."""
    return history_of(present(case), *present_point(case))


@functools.cache
def high_stiffness_history(case: Case) -> History:
    """Return the history with the high-stiffness coupling."""
    return history_of(high_stiffness(case), required_stiffness(case), 0.0)


@functools.cache
def least_elastic_peak(case: Case) -> tuple[float, float]:
    """Return at which stiffness [N m/rad] the elastic type peaks least, and that [N].

    Over the type's whole range, as built and in a tight fit.
    """
    low, high = present_candidate(case).coupling_type.stiffness_range
    span = [float(k) for k in np.geomspace(low, high, ELASTIC_POINTS)]
    _, built = present_point(case)
    found = [
        *present(case).performances([(k, built) for k in span]),
        *present_tightly_fitted(case).performances([(k, 0.0) for k in span]),
    ]
    least = min(found, key=lambda p: float(p.peak_transmission_force))
    return float(least.torsional_stiffness), float(least.peak_transmission_force)

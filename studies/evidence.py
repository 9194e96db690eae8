"""Rollouts that several results rest on, done once, and what explains a difference."""

from __future__ import annotations

import dataclasses
import functools

import numpy as np

from coupling_design.case.case import Case
from coupling_design.design.baseline import present_candidate
from coupling_design.design.evaluation import Evaluator
from studies import gap, stiffness
from studies.forces import change
from studies.machine import present, present_point, present_tightly_fitted

# A contact [N m/rad] so hard that half the stiffness costs more nearly what the paper
# says, and the lightest at which rattling has been found chaotic.
HARD_CONTACT = 4e8
_ELASTIC_POINTS = 41


@functools.cache
def stiffness_influence(case: Case) -> stiffness.StiffnessInfluence:
    """Return the study of stiffness."""
    return stiffness.examine(case)


@functools.cache
def gap_influence(case: Case) -> gap.GapInfluence:
    """Return the study of the gap."""
    return gap.examine(case)


@functools.cache
def least_elastic_peak(case: Case) -> tuple[float, float]:
    """Return at which stiffness [N m/rad] the elastic type peaks least, and that [N].

    Over the type's whole range, as built and in a tight fit.
    """
    low, high = present_candidate(case).coupling_type.stiffness_range
    span = [float(k) for k in np.geomspace(low, high, _ELASTIC_POINTS)]
    _, built = present_point(case)
    found = [
        *present(case).performances([(k, built) for k in span]),
        *present_tightly_fitted(case).performances([(k, 0.0) for k in span]),
    ]
    least = min(found, key=lambda p: float(p.peak_transmission_force))
    return float(least.torsional_stiffness), float(least.peak_transmission_force)


@functools.cache
def change_at_half(case: Case, contact: float) -> tuple[float, float]:
    """Return by how much half the stiffness changes D [%] with a contact [N m/rad].

    At the case's time step, and at half of it.
    """
    joint = dataclasses.replace(case.joint, contact_stiffness=contact)
    keyed = Evaluator(dataclasses.replace(case, joint=joint), present_candidate(case))
    now, built = present_point(case)
    points = [(stiffness.HALF * now, built), (now, built)]
    coarse, fine = (
        change(half.damage, full.damage)
        for half, full in (
            keyed.performances(points),
            keyed.refined.performances(points),
        )
    )
    return coarse, fine


def why_not_half(case: Case) -> str:
    """Return what half the stiffness does with the case's contact and a hard one."""
    contact = case.joint.contact_stiffness or 0.0
    ours, hard = (change_at_half(case, c) for c in (contact, HARD_CONTACT))
    return (
        f"With the contact of {contact / 1e6:.4g} MN m/rad half the stiffness changes "
        f"D by {ours[0]:+.2f} % ({ours[1]:+.2f} % with half the time step), with one "
        f"of {HARD_CONTACT / 1e6:.0f} MN m/rad by {hard[0]:+.2f} % ({hard[1]:+.2f} %). "
        + (
            "The result nearer to the paper's is one that the time step does not "
            "resolve."
            if abs(hard[1] - hard[0]) > 10 * abs(ours[1] - ours[0])
            else ""
        )
    ).rstrip()

"""Keeping the lowest stiffness where a stiffer coupling would gain next to nothing."""

from __future__ import annotations

from dataclasses import replace

from coupling_design.machine.words import Plan
from coupling_design.steps.so_far import FlowState, Solution
from coupling_design.wear.conditioning import conditioning

# Our choice, not the paper's: a high-stiffness coupling is stiffened beyond what its
# limits ask only for this much less damage, relative. Step 4 is after the lowest
# stiffness, and above the excitation damage hardly depends on it.
WORTH_A_CHANGE = 0.003


def keep_lowest_stiffness(
    state: FlowState, before: Solution, optimum: Solution
) -> Solution:
    """Return the optimum, or the earlier stiffness in its place if that does as well.

    Only in the high-stiffness plan, whose earlier step looked for the lowest stiffness.
    """
    if optimum.plan is not Plan.HIGH_STIFFNESS:
        return optimum
    least = optimum.optimum.performance
    stiffness = before.optimum.performance.torsional_stiffness
    evaluator = state.bench.evaluator(optimum.candidate)
    kept = evaluator.performance(stiffness, least.key_gap)
    passes = all(float(c.excess(kept)) <= 0.0 for c in optimum.constraints)
    if not passes or kept.damage > least.damage * (1 + WORTH_A_CHANGE):
        return optimum
    return replace(
        optimum,
        optimum=replace(
            optimum.optimum,
            performance=kept,
            method=before.optimum.method,
            conditioning=conditioning(evaluator, kept),
        ),
    )


def kept_finding(kept: Solution, optimum: Solution) -> str:
    """Return in words what keeping the lowest stiffness costs."""
    least, chosen = optimum.optimum.performance, kept.optimum.performance
    return (
        f"Least damage is at {least.torsional_stiffness / 1e6:.5g} MN*m/rad, "
        f"{1 - least.damage / chosen.damage:.2%} below that at the lowest stiffness "
        f"the limits allow, {chosen.torsional_stiffness / 1e6:.5g} MN*m/rad: not worth "
        f"a stiffer coupling (our choice: {WORTH_A_CHANGE:.1%}). The lowest is kept."
    )

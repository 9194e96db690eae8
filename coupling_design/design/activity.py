"""Which bounds and limits hold a design where it is."""

from __future__ import annotations

from coupling_design.design.problem import DesignProblem
from coupling_design.design.results import Performance

# A bound or constraint holds the point if it is this near, in scaled terms.
_ACTIVE = 1e-4


def active_constraints(
    problem: DesignProblem, performance: Performance
) -> tuple[str, ...]:
    """Return the names of the bounds and limits that a point stands on."""
    names = ["torsional stiffness", "key gap"]
    scaled = problem.space.scaled(performance.torsional_stiffness, performance.key_gap)
    active = [
        f"{name} at its {'upper' if value > 0.5 else 'lower'} bound"
        for name, value in zip(names, scaled, strict=False)
        if min(value, 1 - value) <= _ACTIVE
    ]
    active += [
        c.name for c in problem.binding if abs(float(c.excess(performance))) <= _ACTIVE
    ]
    return tuple(active)

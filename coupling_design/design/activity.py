"""What holds a design where it is: a bound, a limit, or nothing."""

from __future__ import annotations

import math
from collections.abc import Iterator

from coupling_design.design.problem import DesignProblem, Objective
from coupling_design.design.results import Performance

# A bound or constraint holds the point if it is this near, in scaled terms.
_ACTIVE = 1e-4
# An objective that is no more than this above that at a bound, a logarithm, does not
# tell the two apart.
_FLAT = 1e-4
_NAMES = ("torsional stiffness", "key gap")


def active_constraints(
    problem: DesignProblem, performance: Performance
) -> tuple[str, ...]:
    """Return the names of the bounds and limits that a point stands on."""
    scaled = problem.space.scaled(performance.torsional_stiffness, performance.key_gap)
    active = [
        f"{name} at its {'upper' if value > 0.5 else 'lower'} bound"
        for name, value in zip(_NAMES, scaled, strict=False)
        if min(value, 1 - value) <= _ACTIVE
    ]
    active += [
        c.name for c in problem.binding if abs(float(c.excess(performance))) <= _ACTIVE
    ]
    return tuple(active)


def what_holds(problem: DesignProblem, performance: Performance) -> str:
    """Return in words what holds a point.

    An inner minimum is one only if the objective is larger at every bound, which is
    rolled out; otherwise it goes on falling towards one.
    """
    active = active_constraints(problem, performance)
    if active:
        return "; ".join(active)
    if problem.objective is Objective.STIFFNESS:
        return "no constraint and no bound, within what they are known to"
    value = float(problem.value(performance))
    falls = [
        f"its {name} bound, where there is {_less(value - below)}"
        for name, below in _at_bounds(problem, performance)
        if below <= value + _FLAT
    ]
    if falls:
        return (
            f"nothing: stopped short, {problem.objective.value} falls on towards "
            f"{'; '.join(falls)}"
        )
    return "no constraint and no bound: an inner minimum, larger at each bound"


def _at_bounds(
    problem: DesignProblem, performance: Performance
) -> Iterator[tuple[str, float]]:
    """Yield each feasible bound, the other variable kept: its name, the objective."""
    space = problem.space
    k, gap = float(performance.torsional_stiffness), float(performance.key_gap)
    places = [
        (f"{end} {_NAMES[0]}", (bound, gap))
        for end, bound in zip(("lower", "upper"), space.stiffness, strict=True)
    ]
    if space.gap_is_free:
        places += [
            (f"{end} {_NAMES[1]}", (k, bound))
            for end, bound in zip(("lower", "upper"), space.gap, strict=True)
        ]
    found = problem.evaluator.performances([point for _, point in places])
    for (name, _), there in zip(places, found, strict=True):
        if problem.is_feasible(there):
            yield name, float(problem.value(there))


def _less(difference: float) -> str:
    """Return in words how much less there is by a logarithm's difference."""
    if abs(difference) <= _FLAT:
        return "as much to 1e-4"
    return f"{-math.expm1(-difference):.2%} less"

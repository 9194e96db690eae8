"""What holds a design where it is: a bound, a limit, or nothing."""

from __future__ import annotations

import math

from coupling_design.search.program import DesignProblem, Objective
from coupling_design.search.reach import reachable_stiffness
from coupling_design.wear.performance import Performance

# A bound or constraint holds the point if it is this near, in scaled terms.
_ACTIVE = 1e-4
# An objective that is no more than this above that at a bound, a logarithm, does not
# tell the two apart.
_FLAT = 1e-4
# A fall of less than this is none: a damage is known to five or six digits.
_SAME = 1e-5
# How far beside a point it is looked whether the objective falls on, in scaled terms.
_BESIDE = 0.02
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

    An inner minimum is one only if the objective is larger at every bound, and no
    smaller a little to each side: all of these are rolled out. Otherwise it goes on
    falling.
    """
    active = active_constraints(problem, performance)
    if active:
        return "; ".join(active)
    if problem.objective is Objective.STIFFNESS:
        return "no constraint and no bound, within what they are known to"
    # At a bound it has to be larger, beside the point no smaller.
    falls = _falls(problem, performance, _bounds(problem, performance), _FLAT) or (
        _falls(problem, performance, _beside(problem, performance), -_FLAT)
    )
    if falls:
        return f"nothing: {problem.objective.value} {'; '.join(falls)}"
    return "no constraint and no bound: an inner minimum, larger at each bound"


_Places = dict[str, tuple[float, float]]


def _falls(
    problem: DesignProblem, performance: Performance, places: _Places, enough: float
) -> list[str]:
    """Return the feasible places whose objective is at most `enough` above a point's.

    Each with how much less there is.
    """
    value = float(problem.value(performance))
    found = problem.evaluator.performances(list(places.values()))
    return [
        _falling(name, value - float(problem.value(there)))
        for name, there in zip(places, found, strict=True)
        if problem.is_feasible(there) and float(problem.value(there)) <= value + enough
    ]


def _bounds(problem: DesignProblem, performance: Performance) -> _Places:
    """Return the bounds, the other variable kept: (stiffness, gap) by name.

    The stiffness goes as far as limits on the natural frequency leave it.
    """
    space, limits = problem.space, problem.binding
    k, gap = float(performance.torsional_stiffness), float(performance.key_gap)
    left = reachable_stiffness(problem.evaluator, limits, space.stiffness)
    low, high = left or space.stiffness
    stiffness, clearance = _NAMES
    places = {
        f"its lower {stiffness} bound": (low, gap),
        f"its upper {stiffness} bound": (high, gap),
    }
    if space.gap_is_free:
        places[f"its lower {clearance} bound"] = (k, space.gap[0])
        places[f"its upper {clearance} bound"] = (k, space.gap[1])
    return places


def _beside(problem: DesignProblem, performance: Performance) -> _Places:
    """Return points a little to each side of one, as far as there are bounds."""
    space = problem.space
    at = space.scaled(performance.torsional_stiffness, performance.key_gap)
    places = {}
    for i, name in enumerate(_NAMES[: len(at)]):
        for word, step in (("smaller", -_BESIDE), ("larger", _BESIDE)):
            scaled = [*at]
            scaled[i] = min(max(at[i] + step, 0.0), 1.0)
            stiffness, gap = space.point(scaled)
            places[f"a {word} {name}"] = (float(stiffness), float(gap))
    return places


def _falling(name: str, difference: float) -> str:
    """Return in words how an objective goes on towards a place; of its logarithm."""
    if difference <= _SAME:
        return f"is flat towards {name}: as much to {_FLAT:g}"
    less = f"{-100 * math.expm1(-difference):.3g} % less"
    return f"falls on towards {name}, where there is {less}: stopped short"

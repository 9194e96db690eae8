"""One operation of a step, and what is known of its value before it is computed."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

# Kinds whose value is a yes or no; all others are numbers.
MASKS = frozenset({"less", "less_equal", "equal", "not", "both", "either"})

_INFINITY = math.inf
_ANYTHING = (-_INFINITY, _INFINITY)

# Bounds of computed values are taken this much wider than exact ones.
_SLACK = 1e-12


@dataclass(frozen=True)
class Value:
    """One operation.

    Attributes
    ----------
    kind : name of the operation
    args : places of its arguments in the graph
    number : a constant's value, or a state's or parameter's index
    lower, upper : bounds, unless it is NaN
    is_positive : cannot be zero unless it underflows
    moves : depends on the state, so it changes from step to step
    is_shared : the same in all lanes, made of constants only
    """

    kind: str
    args: tuple[int, ...]
    number: float
    lower: float
    upper: float
    is_positive: bool
    moves: bool
    is_shared: bool


def known_value(
    kind: str, places: tuple[int, ...], args: Sequence[Value], number: float
) -> Value:
    """Return an operation with what its arguments say about it."""
    if kind == "constant":
        lower = upper = number
    else:
        lower, upper = _BOUNDS[kind](*args) if kind in _BOUNDS else _ANYTHING
    return Value(
        kind,
        places,
        number,
        lower,
        upper,
        lower > 0 or _is_positive(kind, args),
        kind == "state" or any(arg.moves for arg in args),
        kind not in ("state", "parameter") and all(arg.is_shared for arg in args),
    )


def _is_positive(kind: str, args: Sequence[Value]) -> bool:
    positive = [arg.is_positive for arg in args]
    if kind in ("mul", "div", "sqrt", "fmin"):
        return all(positive)
    if kind == "choose":
        return all(positive[1:])
    return kind == "exp" or (kind == "fmax" and any(positive))


def _of_sum(a: Value, b: Value) -> tuple[float, float]:
    return a.lower + b.lower, a.upper + b.upper


def _of_difference(a: Value, b: Value) -> tuple[float, float]:
    return a.lower - b.upper, a.upper - b.lower


def _of_product(a: Value, b: Value) -> tuple[float, float]:
    corners = [
        0.0 if 0.0 in (x, y) else x * y
        for x in (a.lower, a.upper)
        for y in (b.lower, b.upper)
    ]
    return min(corners), max(corners)


def _of_quotient(a: Value, b: Value) -> tuple[float, float]:
    if a.lower < 0 or not b.is_positive:
        return _ANYTHING
    lower = a.lower / b.upper if b.upper > 0 else 0.0
    return lower, a.upper / b.lower if b.lower > 0 else _INFINITY


def _of_exp(a: Value) -> tuple[float, float]:
    upper = math.exp(a.upper) * (1 + _SLACK) if a.upper < 709 else _INFINITY
    return math.exp(min(a.lower, 709)) * (1 - _SLACK), upper


def _of_log(a: Value) -> tuple[float, float]:
    lower = math.log(a.lower) if a.lower > 0 else -_INFINITY
    upper = math.log(a.upper) if a.upper > 0 else -_INFINITY
    return lower - _SLACK * (1 + abs(lower)), upper + _SLACK * (1 + abs(upper))


_BOUNDS: dict[str, Callable[..., tuple[float, float]]] = {
    "add": _of_sum,
    "sub": _of_difference,
    "neg": lambda a: (-a.upper, -a.lower),
    "mul": _of_product,
    "div": _of_quotient,
    "exp": _of_exp,
    "log": _of_log,
    "sqrt": lambda a: (math.sqrt(max(a.lower, 0)), math.sqrt(max(a.upper, 0))),
    "fabs": lambda a: (0.0, max(-a.lower, a.upper)),
    "fmax": lambda a, b: (max(a.lower, b.lower), max(a.upper, b.upper)),
    "fmin": lambda a, b: (min(a.lower, b.lower), min(a.upper, b.upper)),
    "choose": lambda _, a, b: (min(a.lower, b.lower), max(a.upper, b.upper)),
    "keep": lambda _, a: (min(a.lower, 0.0), max(a.upper, 0.0)),
}

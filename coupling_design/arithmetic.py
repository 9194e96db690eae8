"""Elementary functions of floats, NumPy arrays and CasADi symbols alike.

An equation written with these exists once: given numbers it returns numbers, given
arrays it works element by element, given CasADi symbols it returns an expression.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import casadi as ca
import numpy as np
from numpy.typing import NDArray

# A float, an array of floats, or a CasADi expression. CasADi's operators are not
# typed closely enough for a union to help: every mixed product would need a cast.
Scalar = Any
FloatArray = NDArray[np.float64]

_SYMBOLIC = (ca.SX, ca.MX, ca.DM)


def is_symbolic(*values: Scalar) -> bool:
    """Return whether any value is a CasADi expression."""
    return any(isinstance(value, _SYMBOLIC) for value in values)


def _unary(casadi_name: str, numpy_name: str, value: Scalar) -> Scalar:
    if is_symbolic(value):
        return getattr(ca, casadi_name)(value)
    return getattr(np, numpy_name)(value)


def sqrt(value: Scalar) -> Scalar:
    """Return the square root."""
    return _unary("sqrt", "sqrt", value)


def sin(value: Scalar) -> Scalar:
    """Return the sine of an angle [rad]."""
    return _unary("sin", "sin", value)


def cos(value: Scalar) -> Scalar:
    """Return the cosine of an angle [rad]."""
    return _unary("cos", "cos", value)


def tanh(value: Scalar) -> Scalar:
    """Return the hyperbolic tangent."""
    return _unary("tanh", "tanh", value)


def absolute(value: Scalar) -> Scalar:
    """Return the absolute value."""
    return _unary("fabs", "abs", value)


def sign(value: Scalar) -> Scalar:
    """Return -1, 0 or 1."""
    return _unary("sign", "sign", value)


def maximum(first: Scalar, second: Scalar) -> Scalar:
    """Return the larger of two values, element by element."""
    if is_symbolic(first, second):
        return ca.fmax(first, second)
    return np.maximum(first, second)


def minimum(first: Scalar, second: Scalar) -> Scalar:
    """Return the smaller of two values, element by element."""
    if is_symbolic(first, second):
        return ca.fmin(first, second)
    return np.minimum(first, second)


def clip(value: Scalar, lower: float, upper: float) -> Scalar:
    """Return the value held between `lower` and `upper`."""
    return minimum(maximum(value, lower), upper)


def where(condition: Scalar, if_true: Scalar, if_false: Scalar) -> Scalar:
    """Return `if_true` where the condition holds, else `if_false`.

    Both branches are evaluated: clamp their arguments so that neither is NaN.
    """
    if is_symbolic(condition, if_true, if_false):
        return ca.if_else(condition, if_true, if_false)
    return np.where(condition, if_true, if_false)


def entries(vector: Scalar) -> list[Scalar]:
    """Return the entries of a CasADi vector, or the rows of an array."""
    return list(ca.vertsplit(vector) if is_symbolic(vector) else vector)


def stacked(*values: Scalar) -> Scalar:
    """Return a CasADi vector of its entries, or an array of its rows."""
    return ca.vertcat(*values) if is_symbolic(*values) else np.stack(values)


def matrix(rows: Sequence[Sequence[Scalar]]) -> Scalar:
    """Return a matrix of its rows: an array of floats, or a CasADi expression."""
    if is_symbolic(*(entry for row in rows for entry in row)):
        return ca.vertcat(*(ca.horzcat(*row) for row in rows))
    return np.array(rows, dtype=float)

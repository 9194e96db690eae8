"""SI values in the units an engineer reads them in."""

from __future__ import annotations

import math
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from coupling_design.parts.criterion import Criterion
from coupling_design.report.words.numbers import DIGITS, significant

Value = TypeVar("Value", float, NDArray[np.float64])

# What a report shows for an SI unit, and how many SI units one of it is.
_DISPLAY = {
    "": ("-", 1.0),
    "m": ("mm", 1e-3),
    "N": ("kN", 1e3),
    "N*m": ("kN*m", 1e3),
    "N*m/rad": ("MN*m/rad", 1e6),
    "rad/s": ("rpm", math.pi / 30),
}
_MOST_DIGITS = 17  # tells any two different floats apart


def display_unit(unit: str) -> str:
    """Return the unit a report shows for an SI unit."""
    return _DISPLAY.get(unit, (unit, 1.0))[0]


def displayed(value: Value, unit: str) -> Value:
    """Return an SI value, or an array of them, in the unit `display_unit` names."""
    return value / _DISPLAY.get(unit, (unit, 1.0))[1]


def quantity(value: float, unit: str, digits: int = DIGITS) -> str:
    """Return an SI value as a number in the unit that `display_unit` names."""
    return significant(displayed(value, unit), digits)


def as_given(value: float, unit: str) -> str:
    """Return an SI value of the case file in display units, without idle zeros."""
    text = quantity(value, unit)
    return text.rstrip("0").rstrip(".") if "." in text and "e" not in text else text


def value_and_limit(criterion: Criterion) -> tuple[str, str]:
    """Return both numbers of a criterion; alike only where the value is its limit."""
    known = [each for each in (criterion.value, criterion.limit) if each is not None]
    shown: list[str] = []
    for digits in range(DIGITS, _MOST_DIGITS + 1):
        shown = [quantity(each, criterion.unit, digits) for each in known]
        if len(set(shown)) == len(set(known)):
            break
    value = shown[0] if criterion.value is not None else "-"
    limit = f"{criterion.sense} {shown[-1]}" if criterion.limit is not None else "-"
    return value, limit

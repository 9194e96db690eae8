"""Numbers as an engineer reads them: SI values in display units, digits that stand."""

from __future__ import annotations

import math

from coupling_design.design.results import Criterion

DIGITS = 4

# What a report shows for an SI unit, and how many SI units one of it is.
_DISPLAY = {
    "": ("-", 1.0),
    "m": ("mm", 1e-3),
    "N": ("kN", 1e3),
    "N*m": ("kN*m", 1e3),
    "N*m/rad": ("MN*m/rad", 1e6),
    "rad/s": ("rpm", math.pi / 30),
}
_DAMAGE_DIGITS = 3  # where nothing is known of how firmly a damage stands
_MOST_DIGITS = 17  # tells any two different floats apart


def display_unit(unit: str) -> str:
    """Return the unit a report shows for an SI unit."""
    return _DISPLAY.get(unit, (unit, 1.0))[0]


def significant(value: float, digits: int = DIGITS) -> str:
    """Return a number with so many significant digits, plain while it is short."""
    if value == 0 or not math.isfinite(value):
        return f"{value:g}"
    mantissa, _, power = f"{value:.{digits - 1}e}".partition("e")
    exponent = int(power)
    if -4 <= exponent < 7:
        return f"{value:.{max(digits - 1 - exponent, 0)}f}"
    return f"{mantissa}e{exponent}"


def quantity(value: float, unit: str, digits: int = DIGITS) -> str:
    """Return an SI value as a number in the unit that `display_unit` names."""
    return significant(value / _DISPLAY.get(unit, (unit, 1.0))[1], digits)


def as_given(value: float, unit: str) -> str:
    """Return an SI value of the case file in display units, without idle zeros."""
    text = quantity(value, unit)
    return text.rstrip("0").rstrip(".") if "." in text and "e" not in text else text


def value_and_limit(criterion: Criterion) -> tuple[str, str]:
    """Return both numbers of a criterion; never alike if the value is off its limit."""
    for digits in range(DIGITS, _MOST_DIGITS + 1):
        value = quantity(criterion.value, criterion.unit, digits)
        limit = quantity(criterion.limit, criterion.unit, digits)
        if criterion.passes or value != limit:
            break
    return value, f"{criterion.sense} {limit}"


def percent(fraction: float) -> str:
    """Return a fraction in percent, signed; two decimals, more if they would be 0."""
    text = f"{100 * fraction:+.2f}"
    if fraction != 0 and float(text) == 0:
        return f"{100 * fraction:+.0e}".replace("e-0", "e-")
    return "0" if fraction == 0 else text


def damage(value: float, digits: int | None = None) -> str:
    """Return a Miner sum, with no more digits than stand."""
    mantissa, _, power = f"{value:.{_standing(digits) - 1}e}".partition("e")
    return f"{mantissa}e{int(power)}" if value else "0"


def damage_e6(value: float, digits: int | None = None) -> str:
    """Return a Miner sum in the paper's unit, times 1e6."""
    return significant(value * 1e6, _standing(digits))


def change(relative: float) -> str:
    """Return a small relative change: its sign, one decimal, its power of ten."""
    mantissa, _, power = f"{relative:+.1e}".partition("e")
    return f"{mantissa}e{int(power)}" if relative else "0"


def _standing(digits: int | None) -> int:
    return _DAMAGE_DIGITS if digits is None else min(digits, DIGITS)

"""Numbers as text: significant digits, percentages, small changes."""

from __future__ import annotations

import math

DIGITS = 4


def significant(value: float, digits: int = DIGITS) -> str:
    """Return a number with so many significant digits, plain while it is short."""
    if value == 0 or not math.isfinite(value):
        return f"{value:g}"
    mantissa, _, power = f"{value:.{digits - 1}e}".partition("e")
    exponent = int(power)
    if -4 <= exponent < 7:
        return f"{value:.{max(digits - 1 - exponent, 0)}f}"
    return f"{mantissa}e{exponent}"


def percent(fraction: float) -> str:
    """Return a fraction in percent, signed; two decimals, more if they would be 0."""
    text = f"{100 * fraction:+.2f}"
    if fraction != 0 and float(text) == 0:
        return f"{100 * fraction:+.0e}".replace("e-0", "e-")
    return "0" if fraction == 0 else text


def change(relative: float) -> str:
    """Return a small relative change: its sign, one decimal, its power of ten."""
    mantissa, _, power = f"{relative:+.1e}".partition("e")
    return f"{mantissa}e{int(power)}" if relative else "0"

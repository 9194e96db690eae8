"""How many significant digits a relative change leaves standing."""

from __future__ import annotations

import math

_MOST_DIGITS = 6


def standing_digits(relative_change: float) -> int:
    """Return how many significant digits a relative change leaves, 1 to 6.

    A change of 5e-4 leaves 3: the third digit moves by one half at the most.
    """
    if relative_change <= 0.0:
        return _MOST_DIGITS
    digits = math.floor(-math.log10(2 * relative_change) + 1e-9)
    return min(max(digits, 1), _MOST_DIGITS)

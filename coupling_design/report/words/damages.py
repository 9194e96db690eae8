"""Miner sums, true and in the paper's unit, with the digits that stand."""

from __future__ import annotations

from coupling_design.report.words.numbers import DIGITS, significant

_UNKNOWN = 3  # digits, where nothing is known of how firmly a damage stands


def damage(value: float, digits: int | None = None) -> str:
    """Return a Miner sum, with no more digits than stand."""
    mantissa, _, power = f"{value:.{_standing(digits) - 1}e}".partition("e")
    return f"{mantissa}e{int(power)}" if value else "0"


def damage_e6(value: float, digits: int | None = None) -> str:
    """Return a Miner sum in the paper's unit, times 1e6."""
    return significant(value * 1e6, _standing(digits))


def _standing(digits: int | None) -> int:
    return _UNKNOWN if digits is None else min(digits, DIGITS)

"""A published result beside ours, with the words for the case that they differ."""

from __future__ import annotations

from dataclasses import dataclass

from tests.verification.comparison import Comparison

PAPER = "paper"
SHARE = 0.1  # of a published value that ours may differ by


@dataclass(frozen=True)
class Contrast:
    """One question answered after two readings of a source that contradicts itself.

    `first` and `second` are the values of the readings named, both in `unit`; `ours`
    says which one this program takes; `remark` what follows.
    """

    question: str
    first_reading: str
    first: float
    second_reading: str
    second: float
    unit: str
    ours: str
    remark: str


def within_share(
    quantity: str, where: str, published: float, ours: float, unit: str, why: str = ""
) -> Comparison:
    """Return a comparison that holds within a tenth of the published value.

    `why` is said only where it does not hold.
    """
    return within(quantity, where, published, ours, unit, SHARE * abs(published), why)


def within(
    quantity: str,
    where: str,
    published: float,
    ours: float,
    unit: str,
    tolerance: float,
    why: str = "",
) -> Comparison:
    """Return a comparison with a tolerance of its own in `unit`."""
    arguments = (quantity, f"{PAPER}, {where}", published, ours, unit, tolerance)
    held = Comparison(*arguments)
    return held if held.agrees else Comparison(*arguments, why)


def direction(
    quantity: str, where: str, published: int, ours: float, numbers: str
) -> Comparison:
    """Return a comparison of signs: +1 more or above, -1 less or below."""
    sign = (ours > 0) - (ours < 0)
    return Comparison(
        quantity, f"{PAPER}, {where}", published, sign, "sign", 0.0, numbers
    )

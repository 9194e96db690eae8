"""What a run-down leaves behind: each quantity declared once, in the order of a state.

A quantity adds up over the steps or is the largest of them; from that follow its
accumulation in the step and what counts of many run-downs that differ by chance.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from enum import StrEnum

from coupling_design.arithmetic import Scalar, maximum


class Gathering(StrEnum):
    """How a quantity gathers over the steps of a run-down."""

    ADDS_UP = "adds up"
    LARGEST = "largest"


@dataclass(frozen=True)
class Segment:
    """What acts during one time step; values or symbols.

    Attributes
    ----------
    transmission_force : F_c [N]
    combined_loads : of each bearing [N]
    damage_increments : of each bearing [-]
    """

    transmission_force: Scalar
    combined_loads: Sequence[Scalar]
    damage_increments: Sequence[Scalar]


@dataclass(frozen=True)
class Quantity:
    """One entry of what a run-down leaves behind.

    Attributes
    ----------
    name : of the entry
    unit : SI, "-" for none
    gathering : how it accumulates
    of : what a segment gives it
    """

    name: str
    unit: str
    gathering: Gathering
    of: Callable[[Segment], Scalar]

    def gather(self, before: Scalar, segment: Segment) -> Scalar:
        """Return the quantity after a segment, from what it was before it."""
        if self.gathering is Gathering.ADDS_UP:
            return before + self.of(segment)
        return maximum(before, self.of(segment))


def _damage(k: int) -> Quantity:
    """Return the Miner sum of a bearing, counted from 0."""
    return Quantity(
        f"damage_{k + 1}", "-", Gathering.ADDS_UP, lambda at: at.damage_increments[k]
    )


def _peak_load(k: int) -> Quantity:
    """Return the largest combined load of a bearing, counted from 0."""
    return Quantity(
        f"peak_combined_load_{k + 1}",
        "N",
        Gathering.LARGEST,
        lambda at: at.combined_loads[k],
    )


PEAK_FORCE = Quantity(
    "peak_transmission_force",
    "N",
    Gathering.LARGEST,
    lambda at: abs(at.transmission_force),
)
DAMAGES = (_damage(0), _damage(1))
PEAK_LOADS = (_peak_load(0), _peak_load(1))
QUANTITIES = (*DAMAGES, PEAK_FORCE, *PEAK_LOADS)
TOTALS = tuple(quantity.name for quantity in QUANTITIES)


def place_of(quantity: Quantity) -> int:
    """Return where a quantity stands among the totals."""
    return TOTALS.index(quantity.name)

"""What one coupling does in one run-down, and a value held against its limit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

from coupling_design.arithmetic import Scalar
from coupling_design.design.chance import Spread


class Sense(StrEnum):
    """Which side of its limit a value must lie on."""

    AT_MOST = "<="
    AT_LEAST = ">="


@dataclass(frozen=True)
class Criterion:
    """A value held against its limit.

    `margin` is the distance to the limit relative to it, positive on the good side;
    `unit` is SI; `source` says where the limit comes from.
    """

    name: str
    value: float
    limit: float
    sense: Sense
    unit: str
    passes: bool
    margin: float
    source: str


@dataclass(frozen=True)
class Performance:
    """What one run-down with one coupling does; numbers, or symbols inside the NLP.

    Attributes
    ----------
    torsional_stiffness : k_dyn [N m/rad]
    key_gap : Phi [m], 0 for a tight fit
    natural_frequency : lowest, gap closed, undamped [Hz]
    damages : Miner sum of bearing 1 and of bearing 2, mean over what is chance [-]
    peak_transmission_force : largest |F_c| of all crank angles [N]
    peak_combined_load : largest load of bearing 1 and of bearing 2 [N]
    spread : how far these reach over what is chance, None where that was not looked at
    """

    torsional_stiffness: Scalar
    key_gap: Scalar
    natural_frequency: Scalar
    damages: tuple[Scalar, Scalar]
    peak_transmission_force: Scalar
    peak_combined_load: tuple[Scalar, Scalar]
    spread: Spread | None = None

    @property
    def damage(self) -> float:
        """Miner sum of the bearing that suffers more [-]."""
        return float(max(self.damages))


def performance_of(
    torsional_stiffness: Scalar,
    key_gap: Scalar,
    natural_frequency: Scalar,
    totals: Scalar,
    spread: Spread | None = None,
) -> Performance:
    """Return a performance from the five totals of a rollout, numbers or symbols.

    The damages of both bearings [-], the peak force [N], their peak loads [N].
    """
    return Performance(
        torsional_stiffness=torsional_stiffness,
        key_gap=key_gap,
        natural_frequency=natural_frequency,
        damages=(totals[0], totals[1]),
        peak_transmission_force=totals[2],
        peak_combined_load=(totals[3], totals[4]),
        spread=spread,
    )

"""What one coupling does in one run-down."""

from __future__ import annotations

from dataclasses import dataclass

from coupling_design.arithmetic import Scalar
from coupling_design.wear.chance import Spread
from coupling_design.wear.quantities import (
    DAMAGES,
    PEAK_FORCE,
    PEAK_LOADS,
    place_of,
)


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
    """Return a performance from the TOTALS of a rollout, numbers or symbols."""
    damages = [totals[place_of(each)] for each in DAMAGES]
    loads = [totals[place_of(each)] for each in PEAK_LOADS]
    return Performance(
        torsional_stiffness=torsional_stiffness,
        key_gap=key_gap,
        natural_frequency=natural_frequency,
        damages=(damages[0], damages[1]),
        peak_transmission_force=totals[place_of(PEAK_FORCE)],
        peak_combined_load=(loads[0], loads[1]),
        spread=spread,
    )

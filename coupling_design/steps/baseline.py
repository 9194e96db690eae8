"""What the present coupling does, as everything else is held to it."""

from __future__ import annotations

from dataclasses import dataclass

from coupling_design.wear.conditioning import Conditioning
from coupling_design.wear.performance import Performance
from coupling_design.wear.sensitivity import Sensitivity
from coupling_design.wear.signals import Rundown


@dataclass(frozen=True)
class Baseline:
    """The present coupling in the present connection."""

    performance: Performance
    connection: str
    coupling_type: str
    rundown: Rundown
    conditioning: Conditioning
    time_step: float
    largest_stable_step: float
    sensitivity: Sensitivity

    @property
    def digits(self) -> int:
        """Digits of the damage that stand, numerically and when inputs move."""
        return min(self.conditioning.digits, self.sensitivity.digits)

"""What describes an engine: one cylinder, its charge, its cycle, and who fires when.

All values are SI; angles are radians of the crankshaft.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import StrEnum


class Cycle(StrEnum):
    """How many strokes a working cycle has."""

    FOUR_STROKE = "four_stroke"
    TWO_STROKE = "two_stroke"

    @property
    def turns(self) -> int:
        """Turns of the crankshaft in one cycle."""
        return 2 if self is Cycle.FOUR_STROKE else 1

    @property
    def angle(self) -> float:
        """Angle of one cycle [rad]."""
        return 2 * math.pi * self.turns


@dataclass(frozen=True)
class Cylinder:
    """One cylinder and its central slider-crank.

    Attributes
    ----------
    bore, stroke : of the piston [m]
    rod_length : between the eyes of the connecting rod [m], above stroke / 2
    compression_ratio : largest volume over smallest [-]
    reciprocating_mass : piston, pin, and the rod's share at the pin [kg]
    """

    bore: float
    stroke: float
    rod_length: float
    compression_ratio: float
    reciprocating_mass: float

    @property
    def crank_radius(self) -> float:
        """Half the stroke [m]."""
        return self.stroke / 2

    @property
    def piston_area(self) -> float:
        """Area the gas presses on [m^2]."""
        return math.pi / 4 * self.bore**2

    @property
    def displacement(self) -> float:
        """Swept volume [m^3]."""
        return self.piston_area * self.stroke

    @property
    def clearance_volume(self) -> float:
        """Volume at top dead centre [m^3]."""
        return self.displacement / (self.compression_ratio - 1)


@dataclass(frozen=True)
class Charge:
    """The gas: absolute pressures [Pa] and polytropic exponents [-].

    `intake_pressure` holds during the strokes that exchange the gas and when
    compression begins; `crankcase_pressure` is behind the piston.
    """

    intake_pressure: float
    crankcase_pressure: float
    compression_exponent: float
    expansion_exponent: float


@dataclass(frozen=True)
class IndicatedCombustion:
    """Combustion that reaches an indicated mean pressure [Pa], in Wiebe's form.

    `start` and `duration` are crank angles [rad], the start from top dead centre and
    negative before it; `shape` is Wiebe's exponent m [-]. The defaults are a choice
    for medium-speed diesel engines. Orders up to 2 hardly depend on them, order 4 by
    a sixth, order 8 by a factor of 2 and more: for those give a pressure trace.
    """

    mean_pressure: float
    start: float = math.radians(-5.0)
    duration: float = math.radians(70.0)
    shape: float = 1.0


@dataclass(frozen=True)
class PressureTrace:
    """A measured cycle: crank angles from firing dead centre [rad], pressures [Pa].

    Both are (n_points,).
    """

    angles: tuple[float, ...]
    pressures: tuple[float, ...]


Combustion = IndicatedCombustion | PressureTrace


@dataclass(frozen=True)
class Engine:
    """Like cylinders on one crankshaft.

    Attributes
    ----------
    firing_angles : crank angle of each cylinder's firing top dead centre
        (n_cylinders,) [rad]
    combustion : None while the engine is motored, fuel off
    misfiring : indices of cylinders that compress but do not fire
    reference_speed : at which the inertia torque is worked out [rad/s]
    """

    cylinder: Cylinder
    charge: Charge
    cycle: Cycle
    firing_angles: tuple[float, ...]
    reference_speed: float
    combustion: Combustion | None = None
    misfiring: tuple[int, ...] = ()

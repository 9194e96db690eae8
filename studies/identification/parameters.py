"""The inputs that the paper's lost tables held, their physical bounds, and named sets.

Sources
-------
[1] Advances in Mechanical Engineering 2023, doi 10.1177/16878132231190062.
"""

from __future__ import annotations

import functools
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
import yaml

from coupling_design.arithmetic import FloatArray
from coupling_design.case.values.units import from_si, to_si
from coupling_design.parts.bearing.parameters import Cleanliness

SETS_FILE = Path(__file__).with_name("sets.yaml")
SHIPPED = "smooth"


@dataclass(frozen=True)
class Quantity:
    """A lost input: its bounds in `unit`, and why they are what is possible.

    A quantity that may be nought is searched evenly, one that may not evenly in its
    logarithm.
    """

    name: str
    words: str
    unit: str
    si_unit: str
    lowest: float
    highest: float
    reason: str

    @property
    def logarithmic(self) -> bool:
        """Whether it is searched evenly in its logarithm."""
        return self.name in ("stiffness", "damping_factor", "contact_stiffness")

    def to_si(self, number: float) -> float:
        """Return a value in `unit` in SI."""
        value = to_si(number, self.unit, self.si_unit)
        return float("nan") if value is None else value

    def from_si(self, value: float) -> float:
        """Return an SI value in `unit`."""
        return from_si(value, self.unit)


_TORQUE = ("kN*m", "N*m")
_VISCOUS = ("N*m*s/rad", "N*m*s/rad")
_STIFFNESS = ("MN*m/rad", "N*m/rad")
QUANTITIES = (
    Quantity(
        *("initial_speed", "initial speed", "rpm", "rad/s", 400.0, 520.0),
        "Idle of an engine of this size: from 1000 rpm in 12 s the key would carry "
        "more than the paper's peak.",
    ),
    Quantity(
        *("stiffness", "coupling stiffness", *_STIFFNESS, 0.24, 0.60),
        "Order 4 meets the natural frequency at 100 rpm with 0.241 and at 158 rpm with "
        "0.60; run down through a gap, the torque culminates up to a sixth below.",
    ),
    Quantity(
        *("damping_factor", "damping factor kappa0", "", "", 0.2, 1.5),
        "Oil-damped steel springs: damping ratio 0.02 to 0.13 at 8 Hz.",
    ),
    Quantity(
        *("order_4", "amplitude of order 4", *_TORQUE, 0.0, 3.0),
        "Motored compression of sixteen such cylinders gives 1.6 with a bank lag of 50 "
        "degrees, about nothing with 45.",
    ),
    Quantity(
        *("order_8", "amplitude of order 8", *_TORQUE, 0.0, 2.5),
        "As order 4: 1.4 with both banks in step.",
    ),
    Quantity(
        *("phase_8", "phase of order 8", "rad", "rad", 0.0, 2 * np.pi),
        "Any; order 4 has none, compression being a pure sine from top dead centre.",
    ),
    Quantity(
        *("viscous", "engine's viscous resistance", *_VISCOUS, 0.0, 100.0),
        "At 520 rpm at most 5.4 kN m, more than brings the set to rest in 12 s.",
    ),
    Quantity(
        *("friction", "engine's dry friction", *_TORQUE, 0.0, 4.5),
        "3.5 alone brings the set to rest from 520 rpm in 12 s.",
    ),
    Quantity(
        *("generator_friction", "generator's dry friction", *_TORQUE, 0.0, 2.0),
        "Two roller bearings, seals and slip rings: small, but the paper gives none.",
    ),
    Quantity(
        *("generator_viscous", "generator's viscous resistance", *_VISCOUS, 0.0, 20.0),
        "The fan: at 520 rpm at most 1.1 kN m.",
    ),
    Quantity(
        *("contact_stiffness", "contact stiffness", *_STIFFNESS, 10.0, 500.0),
        "Stiff as steel from 10 on; above 100 rattling with a coupling of half the "
        "stiffness is chaotic, at 500 the hub swings on its key in 4 of the paper's "
        "steps.",
    ),
)
NAMES = tuple(quantity.name for quantity in QUANTITIES)
# Up to this contact stiffness [N m/rad] a run-down is smooth in its inputs.
SMOOTH_CONTACT = 1e8
STIFFEST_CONTACT = 5e8


@dataclass(frozen=True)
class Inputs:
    """One value of each of QUANTITIES, SI, and the class of cleanliness.

    `start` is the crank angle at the start and gravity's direction then [rad].
    """

    values: tuple[float, ...]
    cleanliness: Cleanliness
    start: tuple[float, float] = (0.0, 0.0)

    def __getitem__(self, name: str) -> float:
        """Return the value of a quantity by its name."""
        return self.values[NAMES.index(name)]

    def started_at(self, crank_angle: float, gravity_angle: float) -> Inputs:
        """Return the inputs from another crank angle and gravity's direction [rad]."""
        return replace(self, start=(crank_angle, gravity_angle))

    def of_class(self, cleanliness: Cleanliness) -> Inputs:
        """Return the inputs with another cleanliness."""
        return replace(self, cleanliness=cleanliness)


@dataclass(frozen=True)
class NamedSet:
    """Inputs with a name, and what they are kept for."""

    name: str
    purpose: str
    inputs: Inputs


@functools.cache
def named_sets() -> Mapping[str, NamedSet]:
    """Return the sets of `sets.yaml` by name, in its order."""
    entries: dict[str, dict[str, Any]] = yaml.safe_load(
        SETS_FILE.read_text(encoding="utf-8")
    )
    return {name: _named_set(name, entry) for name, entry in entries.items()}


def shipped() -> Inputs:
    """Return the inputs that the shipped case carries."""
    return named_sets()[SHIPPED].inputs


def to_unit(values: FloatArray) -> FloatArray:
    """Return SI values (n, 11) as shares of their bounds, in the search's scale."""
    low, high, logarithmic = _bounds()
    shares: FloatArray = (_scaled(values, logarithmic) - low) / (high - low)
    return shares


def from_unit(shares: FloatArray) -> FloatArray:
    """Return the SI values (n, 11) that shares of the bounds stand for."""
    low, high, logarithmic = _bounds()
    scaled = low + shares * (high - low)
    return np.where(logarithmic, np.exp(np.where(logarithmic, scaled, 0.0)), scaled)


@functools.cache
def _bounds() -> tuple[FloatArray, FloatArray, FloatArray]:
    logarithmic = np.array([quantity.logarithmic for quantity in QUANTITIES])
    low = np.array([quantity.to_si(quantity.lowest) for quantity in QUANTITIES])
    high = np.array([quantity.to_si(quantity.highest) for quantity in QUANTITIES])
    return _scaled(low, logarithmic), _scaled(high, logarithmic), logarithmic


def _scaled(values: FloatArray, logarithmic: FloatArray) -> FloatArray:
    return np.where(logarithmic, np.log(np.where(logarithmic, values, 1.0)), values)


def _named_set(name: str, entry: dict[str, Any]) -> NamedSet:
    values = tuple(quantity.to_si(entry[quantity.name]) for quantity in QUANTITIES)
    inputs = Inputs(values, Cleanliness(entry["cleanliness"]))
    return NamedSet(name, " ".join(entry["purpose"].split()), inputs)

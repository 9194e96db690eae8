"""A size of a coupling catalogue, as plain SI values."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

from coupling_design.line.parameters import DampingLaw


class CouplingKind(StrEnum):
    """What a coupling's elastic part is."""

    STEEL_SPRING = "steel_spring"
    RUBBER = "rubber"
    SILICONE = "silicone"
    POLYURETHANE = "polyurethane"
    DISC = "disc"
    DIAPHRAGM = "diaphragm"
    OTHER = "other"

    @property
    def is_elastomer(self) -> bool:
        """Whether warmth weakens it, so that a temperature factor holds."""
        return self in (self.RUBBER, self.SILICONE, self.POLYURETHANE)


@dataclass(frozen=True)
class CouplingSize:
    """One size of a series, as its maker's sheet gives it.

    Attributes
    ----------
    name, series, kind : what it is called and made of
    nominal_torque, maximum_torque : T_KN, T_Kmax (T_Kmax1) [N m]
    rare_maximum_torque : T_Kmax2, for a few events in its life [N m]
    vibratory_torque : T_KW, permissible amplitude at 10 Hz [N m]
    power_loss : P_KV, permissible heat from damping [W]
    maximum_speed : n_max [rad/s]
    torsional_stiffness : C_Tdyn [N m/rad]
    damping_law : with its relative damping, loss factor or kappa0 and omega0
    driving_inertia, driven_inertia : of its two sides, hubs included [kg m^2]
    source, note : where its data come from

    What a sheet does not give is None.
    """

    name: str
    series: str
    kind: CouplingKind
    nominal_torque: float
    maximum_torque: float
    rare_maximum_torque: float | None
    vibratory_torque: float | None
    power_loss: float | None
    maximum_speed: float
    torsional_stiffness: float
    damping_law: DampingLaw
    driving_inertia: float | None
    driven_inertia: float | None
    source: str
    note: str


@dataclass(frozen=True)
class CatalogueFile:
    """A catalogue that was read: its file, its hash, its name."""

    file: str
    sha256: str
    name: str

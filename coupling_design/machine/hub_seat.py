"""The seat of the hub on the generator shaft, and the connections it may take."""

from __future__ import annotations

from dataclasses import dataclass

from coupling_design.errors import CaseError
from coupling_design.line.parameters import Connection, KeyedConnection, TightFit
from coupling_design.machine.words import ConnectionKind


@dataclass(frozen=True)
class HubSeat:
    """The seat of the hub on the generator shaft, whatever connection it gets.

    `radius` [m] holds for all; contact stiffness [N m/rad], oil damping [N m s/rad]
    and smoothing [1/m] are None where no key or spline is considered.
    """

    radius: float
    contact_stiffness: float | None
    oil_damping: float | None
    smoothing: float | None

    def connect(self, kind: ConnectionKind, gap: float) -> Connection:
        """Return the connection of that kind, with a gap [m] where it has one."""
        if kind is ConnectionKind.TIGHT_FIT:
            return TightFit(radius=self.radius)
        contact = (self.contact_stiffness, self.oil_damping, self.smoothing)
        if None in contact:
            raise CaseError(
                [
                    f"driveline.connection: a {kind} needs contact_stiffness, "
                    "oil_damping and smoothing, which this case does not give"
                ]
            )
        return KeyedConnection(
            radius=self.radius,
            gap=gap,
            contact_stiffness=self.contact_stiffness,
            oil_damping=self.oil_damping,
            smoothing=self.smoothing,
        )


@dataclass(frozen=True)
class ConnectionOption:
    """A kind of connection the design may take, and its total gap [m]."""

    kind: ConnectionKind
    minimum_gap: float
    maximum_gap: float

"""A design case: what a case file says, as plain SI values."""

from __future__ import annotations

from dataclasses import dataclass

from coupling_design.line.parameters import (
    Driveline,
    ExcitationOrder,
    Shutdown,
)
from coupling_design.machine.coupling_size import CatalogueFile
from coupling_design.machine.coupling_type import CouplingType
from coupling_design.machine.duty import Duty
from coupling_design.machine.hub_seat import ConnectionOption, HubSeat
from coupling_design.machine.sourced_value import SourcedValue
from coupling_design.machine.words import (
    Choice,
    ConnectionKind,
    LoadLimitReading,
    Source,
)
from coupling_design.parts.bearing.parameters import Bearing, Lubrication, ShaftGeometry


@dataclass(frozen=True)
class Case:
    """A machine, its run-down and what may be chosen for it.

    `driveline` holds the present coupling and connection; `present_coupling_type`
    and `present_connection` name what they are among the choices.
    `present_driving_inertia` [kg m^2] is what the present coupling's driving half has
    of the engine's inertia, None if not stated. `overrides` are the values, each
    `path=value`, that replaced those of the file `sha256` belongs to.
    `stated_working_excitation` are the orders at working speed, none where the case
    gives none of their own; `works_fired` says that they are a fired engine's.
    `crank_mode` is the estimated first mode of a described engine's crank [Hz].
    `unused` are the values that nothing uses: path, and why.
    """

    name: str
    description: str
    file: str
    sha256: str
    reading: LoadLimitReading
    driveline: Driveline
    hub_seat: HubSeat
    present_coupling_type: str
    present_connection: ConnectionKind
    shutdown: Shutdown
    shaft: ShaftGeometry
    bearings: tuple[Bearing, Bearing]
    lubrication: Lubrication
    reliability: float
    duty: Duty
    coupling_types: tuple[CouplingType, ...]
    connections: tuple[ConnectionOption, ...]
    provenance: tuple[SourcedValue, ...]
    catalogues: tuple[CatalogueFile, ...] = ()
    choose: Choice = Choice.OPTIMUM
    present_driving_inertia: float | None = None
    overrides: tuple[str, ...] = ()
    stated_working_excitation: tuple[ExcitationOrder, ...] = ()
    works_fired: bool = False
    crank_mode: float | None = None
    unused: tuple[tuple[str, str], ...] = ()

    @property
    def working_excitation(self) -> tuple[ExcitationOrder, ...]:
        """The orders at working speed; those of the run-down where none are stated."""
        return self.stated_working_excitation or self.driveline.excitation

    def place(self, path: str) -> str:
        """Return a value's path as messages begin with it: file, line, path."""
        lines = (v.line for v in self.provenance if v.path == path and v.line)
        line = next(lines, None)
        return f"{self.file}:{line}: {path}" if line else f"{self.file}: {path}"

    @property
    def assumptions(self) -> tuple[SourcedValue, ...]:
        """The values that rest on nothing but judgement: assumed, fitted, invented."""
        judged = (Source.ASSUMED, Source.FITTED, Source.INVENTED)
        return tuple(value for value in self.provenance if value.source in judged)

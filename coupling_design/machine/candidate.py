"""A coupling type in one connection, and the driveline it makes of a design point."""

from __future__ import annotations

from dataclasses import dataclass, replace

from coupling_design.arithmetic import Scalar
from coupling_design.line.parameters import Coupling, Driveline
from coupling_design.machine.coupling_size import CouplingSize
from coupling_design.machine.coupling_type import CouplingType
from coupling_design.machine.hub_seat import ConnectionOption
from coupling_design.machine.machine import Case


@dataclass(frozen=True)
class Candidate:
    """What the two design variables, stiffness and gap, belong to.

    A real `size` brings damping and inertias of its own.
    """

    coupling_type: CouplingType
    connection: ConnectionOption
    size: CouplingSize | None = None

    @property
    def label(self) -> str:
        """Type and connection, as a report names them."""
        name = self.size.name if self.size else self.coupling_type.name
        return f"{name}, {self.connection.kind.replace('_', ' ')}"


def candidate_driveline(
    case: Case, candidate: Candidate, torsional_stiffness: Scalar, key_gap: Scalar
) -> Driveline:
    """Return the case's driveline with the candidate in it.

    Parameters
    ----------
    torsional_stiffness : [N m/rad], value or symbol; damping follows by the type's law
    key_gap : [m], value or symbol; unused for a tight fit
    """
    size = candidate.size
    law = size.damping_law if size else candidate.coupling_type.damping_law
    driveline = _with_inertias(case, size) if size else case.driveline
    return replace(
        driveline,
        coupling=Coupling(torsional_stiffness, law),
        connection=case.hub_seat.connect(candidate.connection.kind, key_gap),
    )


def _with_inertias(case: Case, size: CouplingSize) -> Driveline:
    """Return the driveline with what a size gives of its two sides.

    The driving half is exchanged within the engine's inertia, where the case says how
    much of that the present one is; the driven half is all of the coupling's.
    """
    driveline = case.driveline
    if size.driven_inertia is not None:
        driveline = replace(driveline, coupling_inertia=size.driven_inertia)
    present = case.present_driving_inertia
    if size.driving_inertia is None or present is None:
        return driveline
    engine = driveline.engine_inertia - present + size.driving_inertia
    return replace(driveline, engine_inertia=engine)

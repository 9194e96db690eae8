"""A coupling type in one connection, and the driveline it makes of a design point."""

from __future__ import annotations

from dataclasses import dataclass, replace

from coupling_design.arithmetic import Scalar
from coupling_design.case.case import Case, ConnectionOption, CouplingType
from coupling_design.driveline.parameters import Coupling, Driveline


@dataclass(frozen=True)
class Candidate:
    """What the two design variables, stiffness and gap, belong to."""

    coupling_type: CouplingType
    connection: ConnectionOption

    @property
    def label(self) -> str:
        """Type and connection, as a report names them."""
        return f"{self.coupling_type.name}, {self.connection.kind.replace('_', ' ')}"


def candidate_driveline(
    case: Case, candidate: Candidate, torsional_stiffness: Scalar, key_gap: Scalar
) -> Driveline:
    """Return the case's driveline with the candidate in it.

    Parameters
    ----------
    torsional_stiffness : [N m/rad], value or symbol; damping follows by the type's law
    key_gap : [m], value or symbol; unused for a tight fit
    """
    coupling = Coupling(torsional_stiffness, candidate.coupling_type.damping_law)
    connection = case.joint.connect(candidate.connection.kind, key_gap)
    return replace(case.driveline, coupling=coupling, connection=connection)

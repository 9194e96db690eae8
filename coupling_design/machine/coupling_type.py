"""A family of couplings to choose from, or a series of a catalogue."""

from __future__ import annotations

from dataclasses import dataclass, replace

from coupling_design.line.parameters import DampingLaw
from coupling_design.machine.coupling_size import CouplingSize
from coupling_design.machine.words import ConnectionKind, Plan

_SAME_STIFFNESS = 1e-6  # of a size and of what a case says the present one has


@dataclass(frozen=True)
class CouplingType:
    """A family of couplings to choose from.

    Attributes
    ----------
    name, description : as the report calls it
    plan : the plan of the design flow it belongs to
    nominal_torque, maximum_torque : T_KN, T_Kmax [N m]
    maximum_speed : [rad/s]
    stiffness_range : lowest and highest dynamic stiffness of the family [N m/rad]
    damping_law : how its damping follows its stiffness
    connections : kinds of hub it is made with
    sizes : the real ones, softest first, where it is a series of a catalogue
    """

    name: str
    description: str
    plan: Plan
    nominal_torque: float
    maximum_torque: float
    maximum_speed: float
    stiffness_range: tuple[float, float]
    damping_law: DampingLaw
    connections: tuple[ConnectionKind, ...]
    sizes: tuple[CouplingSize, ...] = ()

    def size_of(self, torsional_stiffness: float) -> CouplingSize | None:
        """Return the size of a stiffness [N m/rad], None if there is none."""
        same = (
            size
            for size in self.sizes
            if abs(size.torsional_stiffness / torsional_stiffness - 1)
            <= _SAME_STIFFNESS
        )
        return next(same, None)

    def with_sizes(self, sizes: tuple[CouplingSize, ...]) -> CouplingType:
        """Return the series of these sizes: their span, and what each of them takes."""
        ordered = tuple(sorted(sizes, key=lambda size: size.torsional_stiffness))
        return replace(
            self,
            nominal_torque=min(size.nominal_torque for size in ordered),
            maximum_torque=min(size.maximum_torque for size in ordered),
            maximum_speed=min(size.maximum_speed for size in ordered),
            stiffness_range=(
                ordered[0].torsional_stiffness,
                ordered[-1].torsional_stiffness,
            ),
            sizes=ordered,
        )

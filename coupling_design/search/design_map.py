"""A map of damage and peak force over the plane, and how good it is."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class CoarseStep:
    """A time step longer than the case's own, and how far it is off.

    Attributes
    ----------
    times : how many times longer
    time_step : [s]
    checked : points that were rolled out with both
    damage_error, peak_error : largest relative differences between the two
    """

    times: int
    time_step: float
    checked: int
    damage_error: float
    peak_error: float


@dataclass(frozen=True)
class DesignMap:
    """Damage [-] and peak force [N] over stiffness [N m/rad] and gap [m].

    The two have a row for each gap, with an entry for each stiffness. `coarse` is the
    time step of all rows but the first and the last, None where it is the case's own.
    """

    name: str
    torsional_stiffness: tuple[float, ...]
    key_gap: tuple[float, ...]
    damage: tuple[tuple[float, ...], ...]
    peak_transmission_force: tuple[tuple[float, ...], ...]
    coarse: CoarseStep | None = None

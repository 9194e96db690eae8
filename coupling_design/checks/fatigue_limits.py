"""The two fatigue limits of a bearing side by side."""

from __future__ import annotations

from dataclasses import dataclass

from coupling_design.machine.machine import Case
from coupling_design.parts.bearing.contact_stress import minimum_load
from coupling_design.parts.bearing.life import fatigue_load_limit
from coupling_design.parts.bearing.parameters import Bearing, Contact

_LAWS = {
    Contact.LINE: "square root, a line contact's law",
    Contact.POINT: "cube root, a point contact's law",
}


@dataclass(frozen=True)
class FatigueLimits:
    """What a bearing bears without fatigue, read in two ways.

    Attributes
    ----------
    bearing : its name
    minimum_load : F_min, from S_min and K1; the load limit of the method [N]
    C_u : ISO 281's fatigue load limit, in the life [N]
    law : how K1 takes stress to grow with the load
    is_a_ball_by_the_line_law : whether that is not the law of its rolling elements
    """

    bearing: str
    minimum_load: float
    C_u: float
    law: str
    is_a_ball_by_the_line_law: bool


def fatigue_limits(case: Case) -> tuple[FatigueLimits, ...]:
    """Return both limits of each bearing of a case."""
    return tuple(map(_limits, case.bearings))


def _limits(bearing: Bearing) -> FatigueLimits:
    return FatigueLimits(
        bearing=bearing.name,
        minimum_load=float(minimum_load(bearing)),
        C_u=float(fatigue_load_limit(bearing)),
        law=_LAWS[bearing.contact],
        is_a_ball_by_the_line_law=bearing.is_a_ball_by_the_line_law,
    )

"""The shape of the run-down in a case file."""

from __future__ import annotations

from typing import Annotated, Any

from pydantic import Discriminator, Tag

from coupling_design.case.values.kinds import (
    Angle,
    AngularSpeed,
    CrankAngles,
    CutTime,
    Time,
)
from coupling_design.case.values.stated import Section, Stated
from coupling_design.machine.words import StartWord


class FuelCut(Section):
    """How the fuel's torque goes: evenly over a time, or one working cycle."""

    over: Stated[CutTime]


class FuelCutSection(Section):
    """A start settled at idle, from which the fuel is taken away."""

    fuel_cut: FuelCut


def _form_of_start(written: Any) -> str:
    is_cut = isinstance(written, FuelCutSection) or (
        isinstance(written, dict) and "value" not in written
    )
    return "fuel_cut" if is_cut else "word"


StartOfShutdown = Annotated[
    Annotated[Stated[StartWord], Tag("word")]
    | Annotated[FuelCutSection, Tag("fuel_cut")],
    Discriminator(_form_of_start),
]


class ShutdownSection(Section):
    """The run-down to simulate, from where, and over which chances it is judged."""

    initial_speed: Stated[AngularSpeed]
    duration: Stated[Time]
    time_step: Stated[Time]
    start: StartOfShutdown | None = None
    crank_angle: Stated[Angle] | None = None
    gravity_angle: Stated[Angle] | None = None
    crank_angles: Stated[CrankAngles] | None = None

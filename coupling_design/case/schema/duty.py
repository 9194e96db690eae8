"""The shape of what a set works at in a case file."""

from __future__ import annotations

from typing import Annotated

from pydantic import Discriminator, Tag

from coupling_design.case.schema.engine import WorkingEngineExcitation
from coupling_design.case.schema.excitation import Orders, form_of_excitation
from coupling_design.case.values.kinds import AngularSpeed, Factor, PositiveTorque
from coupling_design.case.values.stated import Section, Stated


class SpeedRange(Section):
    """A range of speeds."""

    lowest: Stated[AngularSpeed]
    highest: Stated[AngularSpeed]


class ShortCircuitSection(Section):
    """A short circuit at the generator's terminals."""

    air_gap_torque: Stated[PositiveTorque]
    sudden_load_factor: Stated[Factor]


WorkingExcitation = Annotated[
    Annotated[Orders, Tag("orders")]
    | Annotated[WorkingEngineExcitation, Tag("engine")],
    Discriminator(form_of_excitation),
]


class DutySection(Section):
    """What the set works at."""

    working_speed: SpeedRange
    rated_torque: Stated[PositiveTorque]
    peak_torque: Stated[PositiveTorque]
    service_factor: Stated[Factor]
    rare_torque: Stated[PositiveTorque] | None = None
    short_circuit: ShortCircuitSection | None = None
    temperature_factor: Stated[Factor] | None = None
    start_factor: Stated[Factor] | None = None
    excitation: WorkingExcitation | None = None

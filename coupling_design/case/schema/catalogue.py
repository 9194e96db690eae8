"""The shape of a catalogue file: series of couplings, each with its sizes."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from coupling_design.case.schema.machine import LossFactor, Proportional, Relative, Text
from coupling_design.case.values.kinds import (
    AngularSpeed,
    Inertia,
    PositiveTorque,
    Power,
    Stiffness,
)
from coupling_design.case.values.stated import Section, Stated
from coupling_design.machine.coupling_size import CouplingKind
from coupling_design.machine.words import ConnectionKind, Plan, Source


class SizeSection(Section):
    """One size; what it does not say of damping and source, its series says."""

    name: Text
    nominal_torque: Stated[PositiveTorque]
    maximum_torque: Stated[PositiveTorque]
    rare_maximum_torque: Stated[PositiveTorque] | None = None
    vibratory_torque: Stated[PositiveTorque] | None = None
    power_loss: Stated[Power] | None = None
    maximum_speed: Stated[AngularSpeed]
    torsional_stiffness: Stated[Stiffness]
    damping: Proportional | LossFactor | Relative | None = Field(
        default=None, discriminator="law"
    )
    driving_inertia: Stated[Inertia] | None = None
    driven_inertia: Stated[Inertia] | None = None
    source: Source | None = None
    note: str = ""


class SeriesSection(Section):
    """Sizes of one build: a type of coupling for the design."""

    name: Text
    description: str = ""
    type: CouplingKind
    plan: Plan
    source: Source
    note: str = ""
    damping: Annotated[Proportional | LossFactor | Relative, Field(discriminator="law")]
    connections: Annotated[tuple[ConnectionKind, ...], Field(min_length=1)]
    sizes: Annotated[tuple[SizeSection, ...], Field(min_length=1)]


class CatalogueSection(Section):
    """A whole catalogue file."""

    name: Text
    description: str = ""
    series: Annotated[tuple[SeriesSection, ...], Field(min_length=1)]

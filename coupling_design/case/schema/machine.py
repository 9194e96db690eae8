"""The shape of a case file.

Only its form: which keys, of which kind, within which limits. What holds between
values is in `relations`.
"""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from coupling_design.case.schema.duty import DutySection
from coupling_design.case.schema.excitation import Excitation
from coupling_design.case.schema.shutdown import ShutdownSection
from coupling_design.case.values.kinds import (
    AngularSpeed,
    Damping,
    Force,
    Friction,
    Gap,
    Inertia,
    Length,
    Number,
    PerLength,
    PositiveTorque,
    Psi,
    Reliability,
    Stiffness,
    Stress,
    StressCoefficient,
    Viscosity,
)
from coupling_design.case.values.stated import Section, Stated
from coupling_design.machine.words import Choice, ConnectionKind, LoadLimitReading, Plan
from coupling_design.parts.bearing.parameters import BearingType, Cleanliness

Text = Annotated[str, Field(min_length=1)]


class PresentCoupling(Section):
    """The coupling the machine has: its type's name and its stiffness."""

    type: Text
    torsional_stiffness: Stated[Stiffness]
    driving_inertia: Stated[Inertia] | None = None


class PresentConnection(Section):
    """The connection the machine has, and what any connection there would share."""

    kind: Stated[ConnectionKind]
    radius: Stated[Length]
    gap: Stated[Gap] | None = None
    contact_stiffness: Stated[Stiffness] | None = None
    oil_damping: Stated[Damping] | None = None
    smoothing: Stated[PerLength] | None = None


class ShaftResistance(Section):
    """What brakes one shaft."""

    viscous: Stated[Damping]
    friction: Stated[Friction]
    transition_speed: Stated[AngularSpeed]


class DrivelineSection(Section):
    """Inertias, present coupling and connection, what drives and brakes them."""

    engine_inertia: Stated[Inertia]
    coupling_inertia: Stated[Inertia]
    generator_inertia: Stated[Inertia]
    coupling: PresentCoupling
    connection: PresentConnection
    excitation: Excitation
    engine_resistance: ShaftResistance
    generator_resistance: ShaftResistance


class ShaftSection(Section):
    """Where the overhung generator shaft carries what."""

    hub_to_bearing_1: Stated[Length]
    bearing_1_to_rotor: Stated[Length]
    rotor_to_bearing_2: Stated[Length]
    rotor_weight: Stated[Force]


class BearingSection(Section):
    """One bearing of the generator."""

    name: Text
    designation: Text
    type: Stated[BearingType]
    dynamic_load_rating: Stated[Force]
    static_load_rating: Stated[Force]
    pitch_diameter: Stated[Length]
    stress_coefficient: Stated[StressCoefficient]
    minimum_stress: Stated[Stress]


class LubricationSection(Section):
    """Grease, its cleanliness, and the reliability asked for."""

    viscosity: Stated[Viscosity]
    cleanliness: Stated[Cleanliness]
    reliability: Stated[Reliability]


class StiffnessRange(Section):
    """A range of dynamic stiffness."""

    lowest: Stated[Stiffness]
    highest: Stated[Stiffness]


class Proportional(Section):
    """Damping proportional to stiffness: kappa0 and omega0."""

    law: Literal["proportional"]
    damping_factor: Stated[Number]
    characteristic_frequency: Stated[AngularSpeed]


class LossFactor(Section):
    """Damping from a loss factor."""

    law: Literal["loss_factor"]
    loss_factor: Stated[Number]


class Relative(Section):
    """Damping from DIN 740's relative damping psi."""

    law: Literal["relative_damping"]
    relative_damping: Stated[Psi]


class CouplingTypeSection(Section):
    """A family of couplings to choose from."""

    name: Text
    description: str = ""
    plan: Plan
    nominal_torque: Stated[PositiveTorque]
    maximum_torque: Stated[PositiveTorque]
    maximum_speed: Stated[AngularSpeed]
    stiffness: StiffnessRange
    damping: Annotated[Proportional | LossFactor | Relative, Field(discriminator="law")]
    connections: Annotated[tuple[ConnectionKind, ...], Field(min_length=1)]


class GapRange(Section):
    """The gaps a key or a spline can be made with."""

    minimum_gap: Stated[Gap]
    maximum_gap: Stated[Gap]


class NoGap(Section):
    """A tight fit has nothing to choose: `{}`."""


class ConnectionChoices(Section):
    """The kinds of connection the design may take."""

    key: GapRange | None = None
    spline: GapRange | None = None
    tight_fit: NoGap | None = None


class DesignSpace(Section):
    """What the design may choose besides the coupling."""

    connections: ConnectionChoices
    choose: Choice = Choice.OPTIMUM


class CaseSection(Section):
    """A whole case file."""

    name: Text
    description: str
    reading: Stated[LoadLimitReading]
    driveline: DrivelineSection
    shutdown: ShutdownSection
    shaft: ShaftSection
    bearings: tuple[BearingSection, ...]
    lubrication: LubricationSection
    duty: DutySection
    coupling_types: Annotated[tuple[CouplingTypeSection, ...], Field(min_length=1)] = ()
    catalogue: Annotated[tuple[Text, ...], Field(min_length=1)] = ()
    design_space: DesignSpace

"""The shape of an engine in a case file, from which the orders are worked out."""

from __future__ import annotations

import math
from enum import StrEnum
from typing import Annotated

from pydantic import Field

from coupling_design.case.values.kinds import (
    ANGLE,
    NUMBER,
    CompressionRatio,
    Count,
    CycleAngle,
    EngineLength,
    EngineSpeed,
    Exponent,
    HighestOrder,
    Mass,
    Pressure,
    Share,
)
from coupling_design.case.values.stated import Section, Stated
from coupling_design.engine import Cycle

Name = Annotated[str, Field(min_length=1)]
Names = Annotated[tuple[Name, ...], Field(min_length=1)]
Angles = Annotated[tuple[CycleAngle, ...], Field(min_length=1)]


# Within these, combustion always does some of its work in the expansion.
BurnStart = Annotated[float, ANGLE.between(-math.pi / 2, math.pi / 2)]
BurnDuration = Annotated[float, ANGLE.between(math.radians(1.0), math.pi)]
BurnShape = Annotated[float, NUMBER.between(0.1, 10.0)]


class EngineMode(StrEnum):
    """Whether fuel is injected."""

    MOTORED = "motored"
    FIRED = "fired"


class CombustionSection(Section):
    """When and how the fuel burns, where a mean pressure is given."""

    start: Stated[BurnStart]
    duration: Stated[BurnDuration]
    shape: Stated[BurnShape]


class EngineSection(Section):
    """One cylinder, its cycle, who fires when, and which orders to keep.

    Only `fired` uses indicated_mean_pressure, combustion, pressure_trace and
    misfiring_cylinders, so that `mode` alone turns the fuel off.
    """

    cycle: Stated[Cycle]
    mode: Stated[EngineMode]
    bore: Stated[EngineLength]
    stroke: Stated[EngineLength]
    rod_length: Stated[EngineLength]
    reciprocating_mass: Stated[Mass]
    compression_ratio: Stated[CompressionRatio]
    polytropic_exponent: Stated[Exponent]
    expansion_exponent: Stated[Exponent] | None = None
    intake_pressure: Stated[Pressure]
    crankcase_pressure: Stated[Pressure] | None = None
    cylinders: Stated[Count]
    bank_angle: Stated[CycleAngle] | None = None
    firing_order: Stated[Names]
    firing_intervals: Stated[Angles] | None = None
    crank_angles: Stated[Angles] | None = None
    indicated_mean_pressure: Stated[Pressure] | None = None
    combustion: CombustionSection | None = None
    pressure_trace: Stated[Name] | None = None
    misfiring_cylinders: Stated[Names] | None = None
    reference_speed: Stated[EngineSpeed]
    highest_order: Stated[HighestOrder]
    threshold: Stated[Share] | None = None


class WorkingEngine(Section):
    """What differs at working speed; all else is as in driveline.excitation.engine."""

    mode: Stated[EngineMode]
    intake_pressure: Stated[Pressure] | None = None
    indicated_mean_pressure: Stated[Pressure] | None = None
    combustion: CombustionSection | None = None
    pressure_trace: Stated[Name] | None = None
    misfiring_cylinders: Stated[Names] | None = None
    reference_speed: Stated[EngineSpeed] | None = None
    highest_order: Stated[HighestOrder] | None = None
    threshold: Stated[Share] | None = None


class WorkingEngineExcitation(Section):
    """The same engine at work, as what differs from the run-down."""

    engine: WorkingEngine


class EngineExcitation(Section):
    """Orders that are worked out from engine data, not written down."""

    engine: EngineSection

"""The kinds of quantity a case file holds, as annotated types for its schema.

Limits are those of any machine at all: beyond them a digit, a prefix or a unit is
wrong, and numbers leave what a computer can add. What is merely unusual is warned of
instead, see `design.usual_ranges`.
"""

from __future__ import annotations

import math
from typing import Annotated

from coupling_design.case.values.quantity import Kind, KindOrWord, RelativeDampingKind

FACTOR = Kind(
    "a plain number",
    "",
    "1.3",
    lower=1.0,
    upper=20.0,
    remark="A factor of DIN 740-2 asks for more, never for less",
)
RELATIVE_DAMPING = RelativeDampingKind(
    "a plain number", "", "0.9", lower=1e-9, upper=2 * math.pi
)
GAP = Kind(
    "a length",
    "m",
    "0.28 mm",
    lower=0.0,
    upper=0.1,
    remark="A gap is the total tangential clearance at the radius of the key",
)
ANGLE = Kind("an angle", "rad", "0 deg")
ANGULAR_SPEED = Kind("an angular speed", "rad/s", "1000 rpm or 290 rad/s")
DAMPING = Kind("a torsional damping", "N*m*s/rad", "100 N*m*s/rad")
FORCE = Kind("a force", "N", "25.4 kN")
INERTIA = Kind("a moment of inertia", "kg*m^2", "177.65 kg*m^2")
COMPRESSION_RATIO = Kind("a plain number", "", "12.5", lower=1.1, upper=100.0)
EXPONENT = Kind("a plain number", "", "1.32", lower=1.0, upper=1.67)
LENGTH = Kind("a length", "m", "0.28 mm")
MASS = Kind("a mass", "kg", "60 kg")
NUMBER = Kind("a plain number", "", "4.0")
PER_LENGTH = Kind("a number per length", "1/m", "1000 1/mm")
POWER = Kind("a power", "W", "1.2 kW")
PRESSURE = Kind(
    "a pressure",
    "Pa",
    "1 bar",
    lower=1.0,
    upper=1e9,
    remark="Pressures are absolute",
)
PROBABILITY = Kind("a probability", "", "99 %")
STIFFNESS = Kind("a torsional stiffness", "N*m/rad", "0.347 MN*m/rad")
STRESS = Kind("a stress", "Pa", "800 MPa")
STRESS_COEFFICIENT = Kind(
    "a stress per root of force",
    "Pa/N^0.5",
    "3.62 MPa/N^0.5 or 93.4 MPa/N^(1/3)",
    other_unit="Pa/N^(1/3)",
)
TIME = Kind("a time", "s", "12 s")
CUT_TIME = KindOrWord(
    "a time or the words one cycle",
    "s",
    "0.2 s or one cycle",
    lower=0.0,
    word="one cycle",
)
TORQUE = Kind("a torque", "N*m", "35 kN*m")
VISCOSITY = Kind("a kinematic viscosity", "m^2/s", "39.6 mm^2/s")

Angle = Annotated[float, ANGLE]
# From one turn in a day to a turbocharger's.
AngularSpeed = Annotated[float, ANGULAR_SPEED.between(1e-4, 2e4)]
CompressionRatio = Annotated[float, COMPRESSION_RATIO]
Count = Annotated[float, NUMBER.between(1.0, 64.0)]
# 128 columns of a batch are as many as anybody has reason to ask for.
CrankAngles = Annotated[float, NUMBER.between(1.0, 128.0)]
CutTime = Annotated[float | str, CUT_TIME]
CycleAngle = Annotated[float, ANGLE.between(0.0, 4 * math.pi)]
Damping = Annotated[float, DAMPING.between(0.0, 1e9)]
EngineLength = Annotated[float, LENGTH.between(1e-3, 10.0)]
EngineSpeed = Annotated[float, ANGULAR_SPEED.between(0.0, 5e3)]
Exponent = Annotated[float, EXPONENT]
Factor = Annotated[float, FACTOR]
# From a watch's bearing to a thousand locomotives.
Force = Annotated[float, FORCE.between(1e-3, 1e9)]
Gap = Annotated[float, GAP]
HighestOrder = Annotated[float, NUMBER.between(0.5, 100.0)]
Inertia = Annotated[float, INERTIA.between(1e-6, 1e9)]
Length = Annotated[float, LENGTH.between(1e-6, 1e3)]
Mass = Annotated[float, MASS.between(0.0, 1e5)]
Number = Annotated[float, NUMBER.between(1e-9, 1e4)]
PerLength = Annotated[float, PER_LENGTH.between(1.0, 1e12)]
Power = Annotated[float, POWER.between(1e-6, 1e10)]
Pressure = Annotated[float, PRESSURE]
Psi = Annotated[float, RELATIVE_DAMPING]
Reliability = Annotated[float, PROBABILITY.between(0.90, 1.0)]
Share = Annotated[float, NUMBER.between(0.0, 1.0)]
# From a watch's spring to a shaft with no length.
Stiffness = Annotated[float, STIFFNESS.between(1e-3, 1e13)]
Stress = Annotated[float, STRESS.between(1e3, 1e12)]
StressCoefficient = Annotated[float, STRESS_COEFFICIENT.between(1.0, 1e12)]
Time = Annotated[float, TIME.between(1e-9, 1e5)]
Friction = Annotated[float, TORQUE.between(0.0, 1e10)]
PositiveTorque = Annotated[float, TORQUE.between(1e-6, 1e10)]
# A torque harmonic may be negative: the same as half a period of phase.
Torque = Annotated[float, TORQUE.between(-1e10, 1e10)]
Viscosity = Annotated[float, VISCOSITY.between(1e-9, 1.0)]

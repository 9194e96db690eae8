"""The kinds of quantity a case file holds, as annotated types for its schema."""

from __future__ import annotations

from typing import Annotated

from coupling_design.case.quantity import Kind

GAP = Kind(
    "a length",
    "m",
    "0.28 mm",
    lower=0.0,
    remark="A gap is the total tangential clearance at the radius of the key",
)
ANGLE = Kind("an angle", "rad", "0 deg")
ANGULAR_SPEED = Kind("an angular speed", "rad/s", "1000 rpm or 290 rad/s")
DAMPING = Kind("a torsional damping", "N*m*s/rad", "100 N*m*s/rad")
FORCE = Kind("a force", "N", "25.4 kN")
INERTIA = Kind("a moment of inertia", "kg*m^2", "177.65 kg*m^2")
LENGTH = Kind("a length", "m", "0.28 mm")
NUMBER = Kind("a plain number", "", "4.0")
PER_LENGTH = Kind("a number per length", "1/m", "1000 1/mm")
POWER = Kind("a power", "W", "1.2 kW")
PROBABILITY = Kind("a probability", "", "99 %")
STIFFNESS = Kind("a torsional stiffness", "N*m/rad", "0.347 MN*m/rad")
STRESS = Kind("a stress", "Pa", "800 MPa")
STRESS_COEFFICIENT = Kind("a stress per root of force", "Pa/N^0.5", "3.62 MPa/N^0.5")
TIME = Kind("a time", "s", "12 s")
TORQUE = Kind("a torque", "N*m", "35 kN*m")
VISCOSITY = Kind("a kinematic viscosity", "m^2/s", "39.6 mm^2/s")

Angle = Annotated[float, ANGLE]
AngularSpeed = Annotated[float, ANGULAR_SPEED.positive()]
Damping = Annotated[float, DAMPING.non_negative()]
Force = Annotated[float, FORCE.positive()]
Gap = Annotated[float, GAP]
Inertia = Annotated[float, INERTIA.positive()]
Length = Annotated[float, LENGTH.positive()]
Number = Annotated[float, NUMBER.positive()]
PerLength = Annotated[float, PER_LENGTH.positive()]
Power = Annotated[float, POWER.positive()]
Reliability = Annotated[float, PROBABILITY.between(0.90, 1.0)]
Stiffness = Annotated[float, STIFFNESS.positive()]
Stress = Annotated[float, STRESS.positive()]
StressCoefficient = Annotated[float, STRESS_COEFFICIENT.positive()]
Time = Annotated[float, TIME.positive()]
Friction = Annotated[float, TORQUE.non_negative()]
PositiveTorque = Annotated[float, TORQUE.positive()]
# A torque harmonic may be negative: the same as half a period of phase.
Torque = Annotated[float, TORQUE]
Viscosity = Annotated[float, VISCOSITY.positive()]

"""Torque on the crankshaft: gas and inertia, of a cylinder and of the engine.

Positive torque drives in the direction of rotation. Angles [rad] are the crank's; a
cylinder's own count from its firing top dead centre.

Sources
-------
[1] Den Hartog, Mechanical Vibrations, 4th edition, McGraw-Hill 1956, chapter 5:
    dynamics of the crank mechanism.
"""

from __future__ import annotations

import numpy as np

from coupling_design.arithmetic import FloatArray, Scalar
from coupling_design.engine.crank import lever_slope, piston_lever
from coupling_design.engine.parameters import Cylinder, Engine
from coupling_design.engine.pressure import cylinder_pressure


def gas_torque(
    angle: Scalar, pressure: Scalar, cylinder: Cylinder, crankcase_pressure: float
) -> Scalar:
    """Return the torque of the gas [N m]: by virtual work, (p - p_crankcase) dV/dtheta.

    [1]: piston force times piston speed over crank speed; exact, no small rod ratio. It
    is of the shape of its arguments.
    """
    force = (pressure - crankcase_pressure) * cylinder.piston_area
    return force * piston_lever(angle, cylinder)


def inertia_torque(angle: Scalar, cylinder: Cylinder, speed: Scalar) -> Scalar:
    """Return the torque of the reciprocating mass [N m] at a steady speed [rad/s].

    [1]: T = -m x'' x' omega^2, primes to the crank angle; the book goes on to
    1/2 m r^2 omega^2 (r/2l sin - sin 2 - 3r/2l sin 3), small r/l, which this is not.
    It is of the shape of its arguments.
    """
    m, omega = cylinder.reciprocating_mass, speed
    lever = piston_lever(angle, cylinder)
    return -m * lever_slope(angle, cylinder) * lever * omega**2


def cylinder_torque(angle: FloatArray, engine: Engine, fires: bool) -> FloatArray:
    """Return one cylinder's torque [N m] at its own cycle angles, of their shape."""
    pressure = cylinder_pressure(angle, engine, fires)
    crankcase = engine.charge.crankcase_pressure
    gas = gas_torque(angle, pressure, engine.cylinder, crankcase)
    inertia = inertia_torque(angle, engine.cylinder, engine.reference_speed)
    return np.asarray(gas + inertia)


def engine_torque(angle: FloatArray, engine: Engine) -> FloatArray:
    """Return the torque of all cylinders [N m] at crank angles [rad], mean included.

    It is of the shape of `angle`.
    """
    total = np.zeros_like(np.asarray(angle, dtype=float))
    for index, firing in enumerate(engine.firing_angles):
        fires = index not in engine.misfiring
        total = total + cylinder_torque(angle - firing, engine, fires)
    return total

"""The state a run-down starts from: turning evenly, twisted by its own deceleration.

Sources
-------
[1] Advances in Mechanical Engineering 2023, doi 10.1177/16878132231190062, eq. (1),
    solved for equal accelerations with the excitation's mean, which is zero.
"""

from __future__ import annotations

import casadi as ca

from coupling_design.arithmetic import Scalar, maximum, sign
from coupling_design.driveline.excitation import resistance_torque
from coupling_design.driveline.key_gap import (
    contact_deflection,
    contact_slope,
    half_gap_angle,
)
from coupling_design.driveline.parameters import Driveline, KeyedConnection

# Newton on the smoothed contact, from the sharp contact's solution: the distance
# squares each time, so this many reach rounding from anywhere on the flank.
_NEWTON_STEPS = 8

# The smoothed contact is nowhere less steep on the flank, and flat in the middle of
# the gap, where a key that carries nothing stays.
_LEAST_SLOPE = 0.5


def all_resistances(driveline: Driveline, speed: Scalar) -> Scalar:
    """Return what brakes both shafts together at a speed [rad/s], in [N m]."""
    return resistance_torque(speed, driveline.engine_resistance) + resistance_torque(
        speed, driveline.generator_resistance
    )


def quasi_steady_state(
    driveline: Driveline, initial_speed: Scalar, fuel_torque: Scalar = 0.0
) -> Scalar:
    """Return the initial state (n_states,), a CasADi expression or DM.

    All inertias turn at `initial_speed` [rad/s] and share the mean deceleration;
    coupling and key carry the torque that this takes. Starting untwisted instead
    would be a step of torque, whose ringing can exceed the resonance looked for.
    The generator's angle is zero. `fuel_torque` [N m] drives the engine besides: where
    it balances all resistances nothing slows down, and the line carries T_d alone.
    """
    J2, J3 = driveline.coupling_inertia, driveline.generator_inertia
    T_d = resistance_torque(initial_speed, driveline.generator_resistance)
    braking = all_resistances(driveline, initial_speed) - fuel_torque
    deceleration = -braking / (driveline.engine_inertia + J2 + J3)
    r_Fc = J3 * deceleration + T_d
    coupling_twist = (J2 * deceleration + r_Fc) / driveline.coupling.torsional_stiffness
    w = initial_speed
    if not isinstance(driveline.connection, KeyedConnection):
        return ca.vertcat(coupling_twist, 0.0, w, w)
    key_twist = _key_twist(r_Fc, driveline.connection)
    return ca.vertcat(coupling_twist + key_twist, key_twist, 0.0, w, w, w)


def _key_twist(torque: Scalar, connection: KeyedConnection) -> Scalar:
    """Return the twist x [rad] at which the key carries `torque` [N m] at rest."""
    pressed = torque / connection.contact_stiffness
    twist = pressed + half_gap_angle(connection) * sign(torque)
    for _ in range(_NEWTON_STEPS):
        error = contact_deflection(twist, connection) - pressed
        slope = maximum(contact_slope(twist, connection), _LEAST_SLOPE)
        twist = twist - error / slope
    return twist

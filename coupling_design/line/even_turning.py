"""A chain whose inertias all turn with one acceleration, twisted by what that takes.

Sources
-------
[1] Advances in Mechanical Engineering 2023, doi 10.1177/16878132231190062, eq. (1),
    solved for equal accelerations.
"""

from __future__ import annotations

from collections.abc import Sequence

from coupling_design.arithmetic import Scalar, maximum, sign
from coupling_design.line.chain import Chain, Contact, Elastic, Rigid
from coupling_design.line.contact import (
    contact_deflection,
    contact_slope,
    half_gap_angle,
)
from coupling_design.line.parameters import KeyedConnection

# Newton on the smoothed contact, from the sharp contact's solution: the distance
# squares each time, so this many reach rounding from anywhere on the flank.
_NEWTON_STEPS = 8

# The smoothed contact is nowhere less steep on the flank, and flat in the middle of
# the gap, where a key that carries nothing stays.
_LEAST_SLOPE = 0.5


def even_torques(
    chain: Chain, acceleration: Scalar, outer_torques: Sequence[Scalar]
) -> tuple[Scalar, ...]:
    """Return what each joint carries (n - 1,) [N m], rigid ones too, [1].

    Each joint turns all inertias behind it with the `acceleration` [rad/s^2], against
    the torques from outside (n,) on them [N m].
    """
    carried: list[Scalar] = []
    behind: Scalar = 0.0
    for J, T in zip(reversed(chain.inertias), reversed(outer_torques), strict=True):
        behind = J * acceleration - T + behind
        carried.append(behind)
    return tuple(reversed(carried[:-1]))


def even_angles(
    chain: Chain, acceleration: Scalar, outer_torques: Sequence[Scalar]
) -> tuple[Scalar, ...]:
    """Return the bodies' angles (n_bodies,) [rad], that of the last one zero."""
    torques = even_torques(chain, acceleration, outer_torques)
    angles: list[Scalar] = [0.0]
    for joint, torque in zip(reversed(chain.joints), reversed(torques), strict=True):
        if not isinstance(joint, Rigid):
            angles.append(angles[-1] + _twist(joint, torque))
    return tuple(reversed(angles))


def _twist(joint: Elastic | Contact, torque: Scalar) -> Scalar:
    if isinstance(joint, Contact):
        return contact_twist(torque, joint.connection)
    return torque / joint.slope(1.0)


def contact_twist(torque: Scalar, connection: KeyedConnection) -> Scalar:
    """Return the twist x [rad] at which a key carries `torque` [N m] at rest.

    It is of the shape of `torque`.
    """
    pressed = torque / connection.contact_stiffness
    twist = pressed + half_gap_angle(connection) * sign(torque)
    for _ in range(_NEWTON_STEPS):
        error = contact_deflection(twist, connection) - pressed
        slope = maximum(contact_slope(twist, connection), _LEAST_SLOPE)
        twist = twist - error / slope
    return twist

"""The state a run-down starts from: vibrating as it does when turned unfired for long.

Just before t = 0 every inertia is held at the mean speed by a constant torque J_i dec,
dec = (all resistances) / (sum of J), so that each joint carries on average what it
carries in the run-down; the orders push at the crank's mean position. At t = 0 these
torques go. With a joint that stays closed this is the linear forced response about the
mean torque [2]; where the gap opens see `periodic_orbit`.

Sources
-------
[1] Advances in Mechanical Engineering 2023, doi 10.1177/16878132231190062, eq. (1).
[2] Friswell, Penny, Garvey, Lees (2010), Dynamics of Rotating Machines: the receptance
    of a linear system.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from fractions import Fraction

import casadi as ca

from coupling_design.arithmetic import Scalar, cos, sin
from coupling_design.line.contact import contact_slope
from coupling_design.line.even_start import quasi_steady_state
from coupling_design.line.forced_response import angle_phasor
from coupling_design.line.motion import inertias
from coupling_design.line.parameters import (
    Driveline,
    ExcitationOrder,
    KeyedConnection,
)

# Orders come as halves, thirds, ... of a turn; more than so many turns is no period.
_FINEST_ORDER, _MOST_TURNS = 120, 8


def settled_state(
    driveline: Driveline,
    initial_speed: Scalar,
    crank_angle: Scalar = 0.0,
    fuel_torque: Scalar = 0.0,
) -> Scalar:
    """Return the settled state (n_states,) at a crank angle, joints closed, [2].

    Parameters
    ----------
    driveline : values or symbols
    initial_speed : mean speed, far above the resistances' transition speed [rad/s]
    crank_angle : mean position of the generator's end of the line [rad]; the crank's
        is ahead of it by the mean twist
    fuel_torque : on the engine besides the orders [N m]
    """
    mean = quasi_steady_state(driveline, initial_speed, fuel_torque)
    n = len(inertias(driveline))
    angles, speeds = mean[:n] + crank_angle, mean[n:]
    theta = crank_angle + mean[0]
    slope = _contact_slope(driveline, mean)
    for order in driveline.excitation:
        real, imaginary = angle_phasor(driveline, order, initial_speed, slope)
        i, w = order.order, order.order * initial_speed
        angles = angles + real * sin(i * theta) + imaginary * cos(i * theta)
        speeds = speeds + w * (real * cos(i * theta) - imaginary * sin(i * theta))
    return ca.vertcat(angles, speeds)


def _contact_slope(driveline: Driveline, mean: Scalar) -> Scalar:
    if not isinstance(driveline.connection, KeyedConnection):
        return 1.0
    return contact_slope(mean[1] - mean[2], driveline.connection)


def period_of(orders: Iterable[ExcitationOrder]) -> float:
    """Return the crank angle after which all orders together repeat [rad].

    Eight turns at most, for orders that have no common period.
    """
    fractions = [Fraction(o.order).limit_denominator(_FINEST_ORDER) for o in orders]
    numerator = math.gcd(*(each.numerator for each in fractions))
    denominator = math.lcm(*(each.denominator for each in fractions))
    # Of fractions in lowest terms this is the greatest common divisor.
    turns = denominator / numerator if numerator else 1.0
    return 2 * math.pi * min(turns, float(_MOST_TURNS))

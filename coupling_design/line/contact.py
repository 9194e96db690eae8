"""Torque through a key with clearance, smoothed so that it can be differentiated.

Sources
-------
[1] Advances in Mechanical Engineering 2023, doi 10.1177/16878132231190062,
    eqs. (2) and (3).
[2] Kim, Rook, Singh (2005), Effect of smoothening functions on the frequency response
    of an oscillator with clearance non-linearity, J. Sound Vib. 281.
"""

from __future__ import annotations

from coupling_design.arithmetic import Scalar, tanh
from coupling_design.line.parameters import KeyedConnection

# The smoothed contact is steeper than k_g just outside the gap: its slope is
# (1 + tanh u + u sech^2 u) / 2 with u = s (x - b), largest where u tanh u = 1.
LARGEST_RELATIVE_SLOPE = 1.09984
# Our choice: at s b = 100 the dip inside the edge spans 1 % of the gap.
SHARP = 100.0


def half_gap_angle(connection: KeyedConnection) -> Scalar:
    """Return b = Phi / (2 r), the angle from the middle of the gap to contact [rad].

    It is of the shape of the connection's values.
    """
    Phi, r = connection.gap, connection.radius
    return Phi / (2 * r)


def sharpness(connection: KeyedConnection) -> Scalar:
    """Return s b [-], half the gap over the width its edge is smoothed over.

    Below about `SHARP` the smoothing is a property of the machine, not of the solver.
    It is of the shape of the connection's values.
    """
    return connection.smoothing * connection.radius * half_gap_angle(connection)


def contact_deflection(twist: Scalar, connection: KeyedConnection) -> Scalar:
    """Return f(x), by how much the key is pressed at a twist x [rad], in [rad].

    [1] eq. (3), [2]: zero inside the gap, x -+ b outside, smoothed over a width 1/s.
    With no gap f(x) = x exactly, whatever the smoothing. Within about 1/s inside the
    edge f dips by up to 0.139/s: the price of the smoothing, small while s b >= 100.
    It is of the shape of `twist`.
    """
    x = twist
    b = half_gap_angle(connection)
    s = connection.smoothing * connection.radius
    return x + ((x - b) * tanh(s * (x - b)) - (x + b) * tanh(s * (x + b))) / 2


def contact_slope(twist: Scalar, connection: KeyedConnection) -> Scalar:
    """Return f'(x) [-], the derivative of `contact_deflection` in the twist [rad].

    It is of the shape of `twist`.
    """
    x = twist
    b = half_gap_angle(connection)
    s = connection.smoothing * connection.radius
    t_minus, t_plus = tanh(s * (x - b)), tanh(s * (x + b))
    flank_minus = t_minus + s * (x - b) * (1 - t_minus**2)
    flank_plus = t_plus + s * (x + b) * (1 - t_plus**2)
    return 1 + (flank_minus - flank_plus) / 2


def transmission_torque(
    twist: Scalar, twist_rate: Scalar, connection: KeyedConnection
) -> Scalar:
    """Return r F_c, the torque through the key [N m].

    [1] eqs. (2), (3): r F_c = k_g f(x) + c x', with x = theta_2 - theta_3 [rad]; the
    oil's drag c x' acts inside the gap too. It is of the shape of its arguments.
    """
    k_g, c = connection.contact_stiffness, connection.oil_damping
    return k_g * contact_deflection(twist, connection) + c * twist_rate

"""The slider-crank: where the piston is at a crank angle, and its derivatives.

Exact, for a piston whose line passes through the crankshaft; angles [rad] count from
top dead centre, travel from there too. Derivatives are to the angle, so that nothing
here depends on speed.

Sources
-------
[1] Heywood, Internal Combustion Engine Fundamentals, McGraw-Hill 1988, section 2.2.
"""

from __future__ import annotations

from coupling_design.arithmetic import Scalar, cos, sin, sqrt
from coupling_design.engine.parameters import Cylinder


def piston_travel(angle: Scalar, cylinder: Cylinder) -> Scalar:
    """Return how far the piston is below top dead centre [m].

    [1] eq. (2.5), s = a cos theta + sqrt(l^2 - a^2 sin^2 theta), as l + a - s;
    of the shape of `angle`.
    """
    theta, a, length = angle, cylinder.crank_radius, cylinder.rod_length
    s = a * cos(theta) + sqrt(length**2 - (a * sin(theta)) ** 2)
    return length + a - s


def piston_lever(angle: Scalar, cylinder: Cylinder) -> Scalar:
    """Return d travel / d angle [m/rad]: the lever arm of a force on the piston.

    The first derivative of [1] eq. (2.5), of the shape of `angle`.
    """
    theta, a, length = angle, cylinder.crank_radius, cylinder.rod_length
    rod_height = sqrt(length**2 - (a * sin(theta)) ** 2)
    return a * sin(theta) * (1 + a * cos(theta) / rod_height)


def lever_slope(angle: Scalar, cylinder: Cylinder) -> Scalar:
    """Return d^2 travel / d angle^2 [m/rad^2], the second derivative of eq. (2.5).

    It is of the shape of `angle`.
    """
    theta, a, length = angle, cylinder.crank_radius, cylinder.rod_length
    rod_height = sqrt(length**2 - (a * sin(theta)) ** 2)
    sway = a**2 * sin(theta) * cos(theta)
    return a * cos(theta) + a**2 * cos(2 * theta) / rod_height + sway**2 / rod_height**3


def cylinder_volume(angle: Scalar, cylinder: Cylinder) -> Scalar:
    """Return the volume of the gas [m^3], of the shape of `angle`, [1] eq. (2.4)."""
    travel = piston_travel(angle, cylinder)
    return cylinder.clearance_volume + cylinder.piston_area * travel

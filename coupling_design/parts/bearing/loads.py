"""Loads on the two bearings of an overhung shaft.

Sources
-------
[1] Advances in Mechanical Engineering 2023, doi 10.1177/16878132231190062,
    eqs. (4) to (6).
"""

from __future__ import annotations

from coupling_design import arithmetic as op
from coupling_design.arithmetic import Scalar
from coupling_design.parts.bearing.parameters import ShaftGeometry

# Smaller loads count as this one [N]: at zero load the direction of a vector sum has
# no slope and a life has no end.
SMALLEST_LOAD = 1e-3


def static_loads(shaft: ShaftGeometry) -> tuple[Scalar, Scalar]:
    """Return what each bearing carries of the rotor's weight.

    Parameters
    ----------
    shaft : ShaftGeometry

    Returns
    -------
    G_1, G_2 : static loads of bearings 1 and 2 [N]

    Notes
    -----
    [1] eq. (5).
    """
    l_2, l_3 = shaft.bearing_1_to_rotor, shaft.rotor_to_bearing_2
    G = shaft.rotor_weight
    G_1 = G * l_3 / (l_2 + l_3)
    G_2 = G * l_2 / (l_2 + l_3)
    return G_1, G_2


def rotational_loads(
    transmission_force: Scalar, shaft: ShaftGeometry
) -> tuple[Scalar, Scalar]:
    """Return what each bearing carries of the force that turns with the shaft.

    Parameters
    ----------
    transmission_force : F_c at the coupling hub [N]
    shaft : ShaftGeometry

    Returns
    -------
    F_r1, F_r2 : rotational loads of bearings 1 and 2, each of the shape of
        `transmission_force` [N]

    Notes
    -----
    [1] eq. (4) gives their sizes. Both count along the direction in which F_c pushes:
    moments about bearing 1 turn bearing 2's over, the rigid shaft being a lever, and
    F_r1 + F_r2 = F_c.
    """
    l_1 = shaft.hub_to_bearing_1
    l_2, l_3 = shaft.bearing_1_to_rotor, shaft.rotor_to_bearing_2
    F_c = transmission_force
    F_r1 = F_c * (l_1 + l_2 + l_3) / (l_2 + l_3)
    F_r2 = -F_c * l_1 / (l_2 + l_3)
    return F_r1, F_r2


def combined_load(
    rotational_load: Scalar, static_load: Scalar, angle: Scalar
) -> Scalar:
    """Return the vector sum of a rotational and a static load.

    Without axial force it is the equivalent load P as well.

    Parameters
    ----------
    rotational_load : F_r, along the direction in which F_c pushes [N]
    static_load : G, along gravity [N]
    angle : beta from that direction to gravity: the rotation of the shaft since t = 0,
        and what it was then [rad]

    Returns
    -------
    F_l : combined load, of the shape of the arguments [N]

    Notes
    -----
    [1] eq. (6), which covers both of its situations: F_r > G turns with the shaft,
    F_r < G swings. Not less than `SMALLEST_LOAD`, with zero slope there.
    """
    F_r, G, beta = rotational_load, static_load, angle
    F_l_squared = F_r**2 + G**2 + 2 * F_r * G * op.cos(beta)
    return op.sqrt(op.maximum(F_l_squared, SMALLEST_LOAD**2))


def combined_loads(
    transmission_force: Scalar, angle: Scalar, shaft: ShaftGeometry
) -> tuple[Scalar, Scalar]:
    """Return the load of bearing 1 and of bearing 2 under a transmission force.

    Parameters
    ----------
    transmission_force : F_c [N]
    angle : beta from the direction of F_c to gravity [rad]
    shaft : ShaftGeometry

    Returns
    -------
    F_l : combined loads, each of the shape of force and angle [N]

    Notes
    -----
    [1] eqs. (4) to (6).
    """
    turning, weights = rotational_loads(transmission_force, shaft), static_loads(shaft)
    first, second = (
        combined_load(F_r, G, angle) for F_r, G in zip(turning, weights, strict=True)
    )
    return first, second

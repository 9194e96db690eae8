"""Contact stress of a bearing and the forces it permits.

Sources
-------
[1] Advances in Mechanical Engineering 2023, doi 10.1177/16878132231190062,
    eq. (7) and Step 3 of its design flow.
[2] Johnson (1985), Contact Mechanics, 4.2: Hertz, the largest pressure goes with the
    square root of the load on a line and with the cube root of that on a point.
"""

from __future__ import annotations

from functools import reduce

from coupling_design import arithmetic as op
from coupling_design.arithmetic import Scalar
from coupling_design.parts.bearing.loads import (
    SMALLEST_LOAD,
    rotational_loads,
    static_loads,
)
from coupling_design.parts.bearing.parameters import Bearing, ShaftGeometry


def contact_stress(load: Scalar, bearing: Bearing) -> Scalar:
    """Return the contact stress under a load.

    Parameters
    ----------
    load : F, the combined load [N]
    bearing : Bearing

    Returns
    -------
    S : contact stress, of the shape of `load` [Pa]

    Notes
    -----
    [1] eq. (7), S = K1 sqrt(F), the law of a line contact; of a point contact, as balls
    have, S = K1 F^(1/3) [2]. Loads below `SMALLEST_LOAD` count as `SMALLEST_LOAD`.
    """
    K_1, F = bearing.stress_coefficient, op.maximum(load, SMALLEST_LOAD)
    return K_1 * F ** (1 / bearing.contact.root)


def minimum_load(bearing: Bearing) -> Scalar:
    """Return the load below which [1] neglects fatigue.

    Parameters
    ----------
    bearing : Bearing

    Returns
    -------
    F_min : load at which the contact stress is S_min [N]

    Notes
    -----
    [1] eq. (7) solved for F; of a point contact [2], F = (S_min / K1)^3.
    """
    K_1, S_min = bearing.stress_coefficient, bearing.minimum_stress
    return (S_min / K_1) ** bearing.contact.root


def permissible_transmission_force(
    shaft: ShaftGeometry, bearings: tuple[Bearing, Bearing]
) -> Scalar:
    """Return the largest transmission force that [1] permits.

    Parameters
    ----------
    shaft : ShaftGeometry
    bearings : bearings 1 and 2

    Returns
    -------
    F_c : the smaller of F_min - G over both bearings [N]

    Notes
    -----
    [1], Step 3: the load of the bearing in line with gravity may reach F_min. [1] holds
    F_c itself against that limit and leaves out the lever of its own eq. (4):
    see `strict_transmission_force`. Negative when the weight alone is too much.
    """
    reserve_1, reserve_2 = _load_reserves(shaft, bearings)
    return op.minimum(reserve_1, reserve_2)


def strict_transmission_force(
    shaft: ShaftGeometry, bearings: tuple[Bearing, Bearing]
) -> Scalar:
    """Return the largest transmission force that keeps both bearings below F_min.

    Parameters
    ----------
    shaft : ShaftGeometry
    bearings : bearings 1 and 2

    Returns
    -------
    F_c : the smaller of (F_min - G) / (F_r / F_c) over both bearings [N]

    Notes
    -----
    [1] eqs. (4) to (7) taken together, lever included. A bearing without a lever (hub
    in the plane of bearing 1) permits any force.
    """
    levers = [op.absolute(lever) for lever in rotational_loads(1.0, shaft)]
    reserves = _load_reserves(shaft, bearings)
    forces = [reserve / lever for reserve, lever in zip(reserves, levers, strict=True)]
    return reduce(op.minimum, forces)


def _load_reserves(
    shaft: ShaftGeometry, bearings: tuple[Bearing, Bearing]
) -> tuple[Scalar, Scalar]:
    G_1, G_2 = static_loads(shaft)
    bearing_1, bearing_2 = bearings
    return minimum_load(bearing_1) - G_1, minimum_load(bearing_2) - G_2

"""The modified rating life of a bearing, with the factors it is made of.

Sources
-------
[1] ISO 281:2007, Rolling bearings - Dynamic load ratings and rating life: clause 9.
[2] Advances in Mechanical Engineering 2023, doi 10.1177/16878132231190062, eq. (12).
"""

from __future__ import annotations

from dataclasses import dataclass

from coupling_design.arithmetic import Scalar
from coupling_design.parts.bearing.life import (
    basic_rating_life,
    life_modification_factor,
    reliability_factor,
)
from coupling_design.parts.bearing.lubrication import (
    contamination_factor,
    viscosity_ratio,
)
from coupling_design.parts.bearing.parameters import Bearing, Lubrication


@dataclass(frozen=True)
class ModifiedLife:
    """A life and its links, each of the shape of load and speed.

    Attributes
    ----------
    viscosity_ratio : kappa, held within the range of [1] [-]
    contamination_factor : e_C [-]
    life_modification_factor : a_ISO [-]
    basic_rating_life, modified_rating_life : L_10, L_p [revolutions]
    """

    viscosity_ratio: Scalar
    contamination_factor: Scalar
    life_modification_factor: Scalar
    basic_rating_life: Scalar
    modified_rating_life: Scalar


def modified_life(
    load: Scalar,
    speed: Scalar,
    bearing: Bearing,
    lubrication: Lubrication,
    reliability: float,
) -> ModifiedLife:
    """Return the life at a load and a speed with its links: see `modified_rating_life`.

    Raises
    ------
    KeyError
        If the table of reliabilities has no such row.
    """
    kappa = viscosity_ratio(lubrication.viscosity, speed, bearing)
    e_C = contamination_factor(kappa, bearing.pitch_diameter, lubrication.cleanliness)
    a_ISO = life_modification_factor(load, kappa, e_C, bearing)
    L_10 = basic_rating_life(load, bearing)
    a_1 = reliability_factor(reliability)
    return ModifiedLife(kappa, e_C, a_ISO, L_10, a_1 * a_ISO * L_10)


def modified_rating_life(
    load: Scalar,
    speed: Scalar,
    bearing: Bearing,
    lubrication: Lubrication,
    reliability: float,
) -> Scalar:
    """Return the life at a load and a speed, with all that [1] knows of.

    Parameters
    ----------
    load : P, the equivalent load [N]
    speed : of the shaft, either way round [rad/s]
    bearing : Bearing
    lubrication : Lubrication
    reliability : as a fraction, a row of `RELIABILITY_FACTORS` [-]

    Returns
    -------
    L_p : modified rating life, L_nm in [1], of the shape of `load` and `speed`
        [revolutions]

    Notes
    -----
    [1] clause 9, [2] eq. (12).

    Raises
    ------
    KeyError
        If the table of reliabilities has no such row.
    """
    life = modified_life(load, speed, bearing, lubrication, reliability)
    return life.modified_rating_life

"""Damage of a bearing by a history of loads and speeds.

Sources
-------
[1] Advances in Mechanical Engineering 2023, doi 10.1177/16878132231190062,
    eqs. (13) and (14).
[2] Miner, M. A. (1945), Cumulative damage in fatigue, J. Appl. Mech. 12.
"""

from __future__ import annotations

import math

import numpy as np

from coupling_design import arithmetic as op
from coupling_design.arithmetic import FloatArray, Scalar
from coupling_design.parts.bearing.contact_stress import minimum_load
from coupling_design.parts.bearing.modified_life import modified_rating_life
from coupling_design.parts.bearing.parameters import Bearing, Lubrication

# [1] counts revolutions in ones and life in millions: its D is Miner's sum times this.
PAPER_UNIT = 1e6


def revolutions(speed: Scalar, time_step: Scalar) -> Scalar:
    """Return how often the shaft turns in a step, either way round.

    Parameters
    ----------
    speed : of the shaft [rad/s]
    time_step : [s]

    Returns
    -------
    l : revolutions, of the shape of the arguments [-]

    Notes
    -----
    [1] eq. (13), l = n dt / 60 with n in rpm.
    """
    return op.absolute(speed) * time_step / (2 * math.pi)


def damage_increment(
    load: Scalar,
    speed: Scalar,
    time_step: Scalar,
    bearing: Bearing,
    lubrication: Lubrication,
    reliability: float,
    *,
    small_loads_do_damage: bool = True,
) -> Scalar:
    """Return the share of its life that a bearing spends in one step.

    Parameters
    ----------
    load : P, the equivalent load in the step [N]
    speed : of the shaft in the step [rad/s]
    time_step : [s]
    bearing : Bearing
    lubrication : Lubrication
    reliability : as a fraction, a row of `life.RELIABILITY_FACTORS` [-]
    small_loads_do_damage : if not, loads below `minimum_load` do none; damage then
        jumps at that load

    Returns
    -------
    dD : l / L_p, one at the end of life, of the shape of `load` and `speed` [-]

    Notes
    -----
    A term of [1] eq. (14), [2]; see `PAPER_UNIT`. [1] says that small loads may be
    neglected, yet its final D, all of small loads by its own limit, is not zero.

    Raises
    ------
    KeyError
        If the table of reliabilities has no such row.
    """
    L_p = modified_rating_life(load, speed, bearing, lubrication, reliability)
    increment = share_of_life(speed, time_step, L_p)
    if small_loads_do_damage:
        return increment
    return op.where(load < minimum_load(bearing), 0, increment)


def share_of_life(speed: Scalar, time_step: Scalar, life: Scalar) -> Scalar:
    """Return the share l / L_p of a life [revolutions] that one step takes [-].

    It is of the shape of its arguments.

    Notes
    -----
    A term of [1] eq. (14), [2].
    """
    l, L_p = revolutions(speed, time_step), life  # noqa: E741  the source's symbol
    return l / L_p


def miner_damage(
    loads: FloatArray,
    speeds: FloatArray,
    time_step: Scalar,
    bearing: Bearing,
    lubrication: Lubrication,
    reliability: float,
    *,
    small_loads_do_damage: bool = True,
) -> float:
    """Return the share of its life that a bearing spends in a recorded history.

    Parameters
    ----------
    loads : P at each step, shape (n_steps,) [N]
    speeds : of the shaft at each step, shape (n_steps,) [rad/s]
    time_step : one for all steps, or shape (n_steps,) [s]
    bearing, lubrication, reliability, small_loads_do_damage : see `damage_increment`

    Returns
    -------
    D : sum of l_j / L_pj, one at the end of life [-]

    Notes
    -----
    [1] eq. (14), [2]; times `PAPER_UNIT` it is the D of [1].

    Raises
    ------
    KeyError
        If the table of reliabilities has no such row.
    """
    increments = damage_increment(
        np.asarray(loads, dtype=float),
        np.asarray(speeds, dtype=float),
        time_step,
        bearing,
        lubrication,
        reliability,
        small_loads_do_damage=small_loads_do_damage,
    )
    return float(np.sum(increments))

"""Lubrication of a rolling bearing: viscosity ratio and contamination.

Sources
-------
[1] ISO 281:2007, Rolling bearings - Dynamic load ratings and rating life, clause 9.3
    and Annex A.
[2] Advances in Mechanical Engineering 2023, doi 10.1177/16878132231190062,
    eqs. (9) and (10).
[3] ASTM D341, Viscosity-temperature equations and charts for liquid petroleum or
    hydrocarbon products (Walther's equation).
"""

from __future__ import annotations

import math

import numpy as np

from coupling_design import arithmetic as op
from coupling_design.arithmetic import Scalar
from coupling_design.parts.bearing.parameters import (
    Bearing,
    Cleanliness,
    OilCleanliness,
)

# Range of kappa in which [1] holds; outside, the border counts.
VISCOSITY_RATIO_RANGE = (0.1, 4.0)

# Slower shafts count as this slow [rpm]; nu_1 is infinite at standstill. kappa is far
# below its range by then.
SLOWEST_SPEED_RPM = 1e-3

# [1] Annex A, grease lubrication: c_1, c_2 for D_pw < 500 mm, c_2 from 500 mm on.
# fmt: off
GREASE_CONTAMINATION = {
    Cleanliness.HIGH:           (0.0864 , 0.6796, 0.6796),
    Cleanliness.NORMAL:         (0.0432 , 1.141 , 1.141 ),
    Cleanliness.SLIGHT_TYPICAL: (0.0177 , 1.887 , 1.677 ),
    Cleanliness.SEVERE:         (0.0115 , 2.662 , 2.662 ),
    Cleanliness.VERY_SEVERE:    (0.00617, 4.06  , 4.06  ),
}
# [1] Annex A, oil lubrication by ISO 4406 code: c_1, c_2. Put down from knowledge of
# the standard, no public copy of the table having been found; it is checked against
# the guide values of [1] table 13.
OIL_CONTAMINATION = {
    OilCleanliness.FILTERED_13_10:   (0.0864 , 0.5663),
    OilCleanliness.FILTERED_15_12:   (0.0432 , 0.9987),
    OilCleanliness.FILTERED_17_14:   (0.0288 , 1.6329),
    OilCleanliness.FILTERED_19_16:   (0.0216 , 2.3362),
    OilCleanliness.UNFILTERED_13_10: (0.0864 , 0.5796),
    OilCleanliness.UNFILTERED_15_12: (0.0288 , 1.141 ),
    OilCleanliness.UNFILTERED_17_14: (0.0133 , 1.67  ),
    OilCleanliness.UNFILTERED_19_16: (0.00864, 2.5164),
    OilCleanliness.UNFILTERED_21_18: (0.00411, 3.8974),
}
# fmt: on

_RPM = 30 / math.pi  # of 1 rad/s
_MM = 1e3  # of 1 m
_MM2_PER_S = 1e6  # of 1 m^2/s


def reference_viscosity(speed: Scalar, bearing: Bearing) -> Scalar:
    """Return the viscosity that separates the surfaces well enough at a speed.

    Parameters
    ----------
    speed : of the shaft, either way round [rad/s]
    bearing : Bearing

    Returns
    -------
    nu_1 : reference kinematic viscosity, of the shape of `speed` [m^2/s]

    Notes
    -----
    [1] clause 9.3, [2] eq. (9); n in rpm, D_pw in mm, nu_1 in mm^2/s. As printed, nu_1
    falls by 2.3 % in a step at 1000 rpm. Below `SLOWEST_SPEED_RPM` it stays constant.
    """
    n = op.maximum(op.absolute(speed) * _RPM, SLOWEST_SPEED_RPM)
    D_pw = bearing.pitch_diameter * _MM
    # nu_1 = 45000 n^-0.83 D_pw^-0.5  (n < 1000),  4500 n^-0.5 D_pw^-0.5  (n >= 1000);
    # the printed step must not be missed by what rad/s rounds off 1000 rpm.
    is_slow = n < 1000 - 1e-6
    factor = op.where(is_slow, 45000, 4500)
    exponent = op.where(is_slow, -0.83, -0.5)
    nu_1 = factor * n**exponent * D_pw**-0.5
    return nu_1 / _MM2_PER_S


def unclamped_viscosity_ratio(
    viscosity: Scalar, speed: Scalar, bearing: Bearing
) -> Scalar:
    """Return the viscosity ratio as it is, inside the range of [1] or not.

    Parameters
    ----------
    viscosity : nu, kinematic, at operating temperature [m^2/s]
    speed : of the shaft, either way round [rad/s]
    bearing : Bearing

    Returns
    -------
    kappa : nu / nu_1, of the shape of the arguments [-]

    Notes
    -----
    [1] clause 9.3, [2] eq. (9). Hold it against `VISCOSITY_RATIO_RANGE` to tell whether
    the life is within the standard.
    """
    nu, nu_1 = viscosity, reference_viscosity(speed, bearing)
    return nu / nu_1


def viscosity_ratio(viscosity: Scalar, speed: Scalar, bearing: Bearing) -> Scalar:
    """Return the viscosity ratio, held within the range of [1].

    Parameters
    ----------
    viscosity : nu, kinematic, at operating temperature [m^2/s]
    speed : of the shaft, either way round [rad/s]
    bearing : Bearing

    Returns
    -------
    kappa : nu / nu_1, at least 0.1 and at most 4, of the shape of the arguments [-]

    Notes
    -----
    [1] says to take kappa = 4 above 4 and does not cover kappa < 0.1: life there is
    not known, and that of kappa = 0.1 is taken in its place.
    """
    kappa = unclamped_viscosity_ratio(viscosity, speed, bearing)
    return op.clip(kappa, *VISCOSITY_RATIO_RANGE)


def contamination_factor(
    viscosity_ratio: Scalar,
    pitch_diameter: Scalar,
    cleanliness: Cleanliness | OilCleanliness,
) -> Scalar:
    """Return how much of the fatigue load limit a dirty lubricant leaves.

    Parameters
    ----------
    viscosity_ratio : kappa [-]
    pitch_diameter : D_pw [m]
    cleanliness : of grease, or of oil by ISO 4406

    Returns
    -------
    e_C : contamination factor, 0 to 1, of the shape of `viscosity_ratio` [-]

    Notes
    -----
    [1] Annex A, [2] eq. (10); D_pw in mm. The second factor is
    negative for small bearings in dirt (very severe: D_pw < 67 mm): e_C is 0 there.
    """
    kappa = op.clip(viscosity_ratio, *VISCOSITY_RATIO_RANGE)
    D_pw = pitch_diameter * _MM
    if isinstance(cleanliness, OilCleanliness):
        c_1, c_2 = OIL_CONTAMINATION[cleanliness]
    else:
        c_1, c_2_below_500, c_2_from_500 = GREASE_CONTAMINATION[cleanliness]
        c_2 = op.where(D_pw < 500, c_2_below_500, c_2_from_500)
    a = op.minimum(c_1 * kappa**0.68 * D_pw**0.55, 1)
    return op.maximum(a * (1 - c_2 / D_pw ** (1 / 3)), 0)


def viscosity_at_temperature(
    temperature: Scalar, viscosity_at_40: float, viscosity_at_100: float
) -> Scalar:
    """Return the viscosity of an oil at a temperature.

    Parameters
    ----------
    temperature : T [K]
    viscosity_at_40, viscosity_at_100 : the catalogue's, at 40 and 100 degrees Celsius;
        numbers, not symbols [m^2/s]

    Returns
    -------
    nu : kinematic viscosity, of the shape of `temperature` [m^2/s]

    Notes
    -----
    [3]: lg lg(nu + 0.7) = A - B lg T, nu in mm^2/s, T in K; good for nu > 2 mm^2/s.
    It is solved for nu here with A from the point at 40 degrees.
    """
    T, T_40, T_100 = temperature, 313.15, 373.15
    Z_40 = viscosity_at_40 * _MM2_PER_S + 0.7
    Z_100 = viscosity_at_100 * _MM2_PER_S + 0.7
    B = np.log(np.log(Z_40) / np.log(Z_100)) / np.log(T_100 / T_40)
    Z = Z_40 ** ((T_40 / T) ** B)
    return (Z - 0.7) / _MM2_PER_S

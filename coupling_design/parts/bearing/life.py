"""Rating life of a rolling bearing after ISO 281:2007, in revolutions.

Sources
-------
[1] ISO 281:2007, Rolling bearings - Dynamic load ratings and rating life: clauses 5, 7
    and 9, Annex B.
[2] Advances in Mechanical Engineering 2023, doi 10.1177/16878132231190062,
    eqs. (8), (11) and (12).
"""

from __future__ import annotations

import math

from coupling_design import arithmetic as op
from coupling_design.arithmetic import Scalar
from coupling_design.parts.bearing.loads import SMALLEST_LOAD
from coupling_design.parts.bearing.lubrication import VISCOSITY_RATIO_RANGE
from coupling_design.parts.bearing.parameters import Bearing, BearingType

ROLLER = BearingType.RADIAL_ROLLER
BALL = BearingType.RADIAL_BALL

LIFE_EXPONENT = {ROLLER: 10 / 3, BALL: 3}

LARGEST_LIFE_MODIFICATION_FACTOR = 50

# [1] clause 9.3: q and e in kappa^e, by range of kappa.
# fmt: off
VISCOSITY_COEFFICIENTS = {
    #        0.1 <= kappa < 0.4   0.4 <= kappa < 1    1 <= kappa <= 4
    ROLLER: ((1.3993, 0.054381), (1.2348, 0.19087), (1.2348, 0.071739)),
    BALL:   ((2.2649, 0.054381), (1.9987, 0.19087), (1.9987, 0.071739)),
}

# [1] table 12: reliability as a fraction, a_1.
RELIABILITY_FACTORS = {
    0.90:   1.0,
    0.95:   0.64,
    0.96:   0.55,
    0.97:   0.47,
    0.98:   0.37,
    0.99:   0.25,
    0.992:  0.22,
    0.994:  0.19,
    0.996:  0.16,
    0.998:  0.12,
    0.999:  0.093,
    0.9992: 0.087,
    0.9994: 0.080,
    0.9995: 0.077,
}
# fmt: on


def basic_rating_life(load: Scalar, bearing: Bearing) -> Scalar:
    """Return the life that 90 % of bearings reach under a load.

    Parameters
    ----------
    load : P, the equivalent load [N]
    bearing : Bearing

    Returns
    -------
    L_10 : basic rating life, of the shape of `load` [revolutions]

    Notes
    -----
    [1] clauses 5 and 7, [2] eq. (8), there in millions. [1] trusts it for P up to
    C_r / 2. Loads below `SMALLEST_LOAD` count as `SMALLEST_LOAD`.
    """
    C_r, P = bearing.dynamic_load_rating, op.maximum(load, SMALLEST_LOAD)
    p = LIFE_EXPONENT[bearing.type]
    return 1e6 * (C_r / P) ** p


def fatigue_load_limit(bearing: Bearing) -> Scalar:
    """Return the load at which the fatigue limit of the material is just reached.

    Parameters
    ----------
    bearing : Bearing

    Returns
    -------
    C_u : fatigue load limit [N]

    Notes
    -----
    [1] Annex B, simplified estimation; [2] eq. (11); D_pw in mm. The factor in D_pw
    applies above 100 mm.
    """
    C_0 = bearing.static_load_rating
    D_pw = op.maximum(bearing.pitch_diameter * 1e3, 100)
    if bearing.type == ROLLER:
        return C_0 / 8.2 * (100 / D_pw) ** 0.3
    return C_0 / 22 * (100 / D_pw) ** 0.5


def life_modification_factor(
    load: Scalar,
    viscosity_ratio: Scalar,
    contamination_factor: Scalar,
    bearing: Bearing,
) -> Scalar:
    """Return how lubrication, dirt and fatigue limit change the life.

    Parameters
    ----------
    load : P, the equivalent load [N]
    viscosity_ratio : kappa [-]
    contamination_factor : e_C [-]
    bearing : Bearing

    Returns
    -------
    a_ISO : life modification factor, at most 50, of the shape of the arguments [-]

    Notes
    -----
    [1] clause 9.3. kappa is held within 0.1 to 4. a_ISO <= 50 is put as a lower bound
    of the bracket, which keeps it off its pole at zero. As printed, the slope over
    kappa has kinks at 0.4 and 1, a_ISO of ball bearings a step of less than 0.3 % at
    0.4, and that of roller bearings falls just below 0.1 at kappa = 0.1.
    """
    P, e_C = op.maximum(load, SMALLEST_LOAD), contamination_factor
    kappa = op.clip(viscosity_ratio, *VISCOSITY_RATIO_RANGE)
    q, e = _viscosity_coefficients(kappa, bearing.type)
    # Above zero: there the powers below have no finite slope.
    x = op.maximum(e_C * fatigue_load_limit(bearing) / P, 1e-30)
    if bearing.type == ROLLER:
        bracket = 1 - (1.5859 - q / kappa**e) * x**0.4
        return 0.1 * _bounded(bracket, 9.185) ** -9.185
    bracket = 1 - (2.5671 - q / kappa**e) ** 0.83 * x ** (1 / 3)
    return 0.1 * _bounded(bracket, 9.3) ** -9.3


def reliability_factor(reliability: float) -> float:
    """Return a_1 [-], the share of life left when more than 90 % must reach it.

    Parameters
    ----------
    reliability : as a fraction, 0.99 for 99 % [-]

    Notes
    -----
    [1] table 12 (the values of 2007). Between its rows the standard gives nothing.

    Raises
    ------
    KeyError
        If the table has no such row.
    """
    for row, a_1 in RELIABILITY_FACTORS.items():
        if math.isclose(reliability, row, rel_tol=0, abs_tol=1e-9):
            return a_1
    allowed = ", ".join(f"{row:g}" for row in RELIABILITY_FACTORS)
    raise KeyError(
        f"reliability = {reliability:g} has no row in ISO 281:2007, table 12. "
        f"Choose one of {allowed} (fractions: 0.99 is 99 %)."
    )


def _viscosity_coefficients(kappa: Scalar, kind: BearingType) -> tuple[Scalar, Scalar]:
    """Return q, e: chosen before the power is taken, so that it is taken once."""
    (q_1, e_1), (q_2, e_2), (q_3, e_3) = VISCOSITY_COEFFICIENTS[kind]
    q = op.where(kappa < 0.4, q_1, op.where(kappa < 1, q_2, q_3))
    e = op.where(kappa < 0.4, e_1, op.where(kappa < 1, e_2, e_3))
    return q, e


def _bounded(bracket: Scalar, exponent: float) -> Scalar:
    """Return the bracket, not below where 0.1 bracket^-exponent reaches the largest."""
    lowest = (LARGEST_LIFE_MODIFICATION_FACTOR / 0.1) ** (-1 / exponent)
    return op.maximum(bracket, lowest)

"""ISO 281:2007 against published numbers and constants typed in a second time.

Sources
-------
[1] ISO 281:2007, table 12, clause 9.3, Annex A (grease), Annex B.
[2] SKF catalogue, example 1, bearing 6309.
[3] SKF Bearing Calculator report, bearing 6309.
[4] SKF Rolling bearings 2018, centrifugal pump.
[5] Advances in Mechanical Engineering 2023, doi 10.1177/16878132231190062.

SKF's a_SKF is not a_ISO, and SKF's diagram of nu_1 is not the formula of [1]: life
modification factors of [2] to [4] are not compared.
"""

import math

import numpy as np
import pytest

from coupling_design.parts.bearing.life import (
    LIFE_EXPONENT,
    RELIABILITY_FACTORS,
    VISCOSITY_COEFFICIENTS,
    basic_rating_life,
    fatigue_load_limit,
    life_modification_factor,
)
from coupling_design.parts.bearing.lubrication import (
    GREASE_CONTAMINATION,
    reference_viscosity,
    viscosity_at_temperature,
)
from coupling_design.parts.bearing.parameters import Bearing, BearingType


def bearing_of(designation, kind, rating_kN, pitch_diameter_mm, static_rating_kN=1.0):
    return Bearing(
        name=designation,
        designation=designation,
        type=BearingType(kind),
        dynamic_load_rating=rating_kN * 1e3,
        static_load_rating=static_rating_kN * 1e3,
        pitch_diameter=pitch_diameter_mm * 1e-3,
        stress_coefficient=3.62e6,
        minimum_stress=800e6,
    )


SKF_6309 = bearing_of("6309", "radial_ball", 55.3, 72.5)
NU_311_ECP = bearing_of("NU 311 ECP", "radial_roller", 156, 87.5)
NU2326 = bearing_of("NU2326", "radial_roller", 920, 205, static_rating_kN=1230)


def life_in_hours(load, speed_rpm, bearing):
    return basic_rating_life(load, bearing) / (60 * speed_rpm)


def test_skf_6309_basic_rating_life():
    # [2]: 169 million revolutions, 940 h; (55.3/10)^3 = 169.11; 939.5 h
    assert basic_rating_life(10e3, SKF_6309) == pytest.approx(169.11e6, abs=5e3)
    assert life_in_hours(10e3, 3000, SKF_6309) == pytest.approx(939.5, abs=0.05)


def test_skf_6309_basic_rating_life_in_the_calculator():
    # [3]: 24 500 h to three digits
    assert life_in_hours(4e3, 1800, SKF_6309) == pytest.approx(24_500, abs=50)


def test_skf_nu_311_basic_rating_life():
    # [4]: C/P = 156/3.29; (156/3.29)^(10/3) / (60 * 3000) = 2.14e6 h, computed
    assert life_in_hours(3.29e3, 3000, NU_311_ECP) == pytest.approx(2.14e6, abs=5e3)


def test_skf_6309_viscosity_at_80_degrees():
    # [3]: kappa nu_1 = 2.08 * 10.4 = 21.6 mm^2/s; Walther gives 21.55
    viscosity = viscosity_at_temperature(353.15, 120e-6, 12e-6)

    assert viscosity == pytest.approx(21.55e-6, abs=0.005e-6)
    assert viscosity == pytest.approx(2.08 * 10.4e-6, rel=0.005)


@pytest.mark.parametrize(("speed_rpm", "expected"), [(3000, 9.65), (1800, 12.46)])
def test_reference_viscosity_of_the_standard(speed_rpm, expected):
    # 4500 n^-0.5 72.5^-0.5 [mm^2/s]
    viscosity = reference_viscosity(speed_rpm * math.pi / 30, SKF_6309)

    assert viscosity == pytest.approx(expected * 1e-6, abs=0.005e-6)


def test_nu2326_fatigue_load_limit():
    assert fatigue_load_limit(NU2326) == pytest.approx(120_938.6, abs=0.05)


# fmt: off
ROLLER_TABLE = {
    # kappa: a_ISO at e_C C_u / P = 0.05, 0.2, 0.5, 1.0 (computed by hand from [1])
    0.15: (0.1101, 0.1183, 0.1276,  0.1381),
    0.3:  (0.1295, 0.1575, 0.1941,  0.2424),
    0.5:  (0.1653, 0.2443, 0.3737,  0.5947),
    0.8:  (0.2371, 0.4759, 1.0439,  2.5576),
    1.0:  (0.2797, 0.6505, 1.7141,  5.3106),
    2.0:  (0.3374, 0.9337, 3.0813, 12.9267),
    4.0:  (0.4048, 1.3350, 5.5869, 32.9195),
}
# fmt: on


@pytest.mark.parametrize("kappa", ROLLER_TABLE)
def test_life_modification_factor_of_roller_bearings(kappa):
    loads = fatigue_load_limit(NU2326) / np.array([0.05, 0.2, 0.5, 1.0])

    factors = life_modification_factor(loads, kappa, 1.0, NU2326)

    assert factors == pytest.approx(ROLLER_TABLE[kappa], abs=5.1e-5)


@pytest.mark.parametrize(
    ("kappa", "load_ratio", "expected"),
    [
        (2.45, 0.8 * 1.34 / 10, 5.52),
        (2.08, 0.55 * 1.34 / 4, 13.20),
        (1.8, 0.2 * 6.4 / 11.52, 4.55),
    ],
)
def test_life_modification_factor_of_ball_bearings(kappa, load_ratio, expected):
    # kappa and e_C C_u / P of [2] to [4] put into the equation of [1], by hand
    load = fatigue_load_limit(SKF_6309) / load_ratio

    factor = life_modification_factor(load, kappa, 1.0, SKF_6309)

    assert factor == pytest.approx(expected, abs=0.005)


def test_nearly_nothing_is_left_at_the_border_of_the_standard():
    # X = 1.5859 - 1.3993 / 0.1^0.054381 = -5.9e-5: 0.1 (1 + 5.9e-5)^-9.185
    load = fatigue_load_limit(NU2326)

    factor = life_modification_factor(load, 0.1, 1.0, NU2326)

    assert factor == pytest.approx(0.099946, abs=2e-6)


def test_step_at_kappa_0_4_is_as_small_as_printed():
    # X for rollers differs by 7e-7 between the two printed equations
    load = fatigue_load_limit(NU2326)
    sides = np.array([0.4 - 1e-13, 0.4])

    below, above = life_modification_factor(load, sides, 1.0, NU2326)

    assert abs(above / below - 1) < 1e-5


def test_constants_typed_in_again():
    roller, ball = BearingType("radial_roller"), BearingType("radial_ball")

    assert LIFE_EXPONENT[roller] == 10 / 3
    assert LIFE_EXPONENT[ball] == 3
    assert [q for q, _ in VISCOSITY_COEFFICIENTS[roller]] == [1.3993, 1.2348, 1.2348]
    assert [q for q, _ in VISCOSITY_COEFFICIENTS[ball]] == [2.2649, 1.9987, 1.9987]
    for row in VISCOSITY_COEFFICIENTS.values():
        assert [e for _, e in row] == [5.4381e-2, 19.087e-2, 7.1739e-2]


def test_reliability_table_typed_in_again():
    percent = [90, 95, 96, 97, 98, 99, 99.2, 99.4, 99.6, 99.8, 99.9, 99.92, 99.94]
    factors = [1, 0.64, 0.55, 0.47, 0.37, 0.25, 0.22, 0.19, 0.16, 0.12]
    factors += [0.093, 0.087, 0.08, 0.077]

    assert list(RELIABILITY_FACTORS) == pytest.approx(
        [value / 100 for value in (*percent, 99.95)], abs=1e-12
    )
    assert list(RELIABILITY_FACTORS.values()) == factors


def test_grease_table_typed_in_again():
    c_1 = [864e-4, 432e-4, 177e-4, 115e-4, 61.7e-4]
    c_2 = [0.6796, 1.141, 1.887, 2.662, 4.06]
    rows = GREASE_CONTAMINATION.values()

    assert [str(key) for key in GREASE_CONTAMINATION] == [
        "high",
        "normal",
        "slight_typical",
        "severe",
        "very_severe",
    ]
    assert [row[0] for row in rows] == pytest.approx(c_1, rel=1e-12)
    assert [row[1] for row in rows] == c_2
    assert [row[2] for row in rows] == [*c_2[:2], 1.677, *c_2[3:]]

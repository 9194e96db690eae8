import dataclasses

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from coupling_design.parts.bearing.life import (
    RELIABILITY_FACTORS,
    basic_rating_life,
    fatigue_load_limit,
    life_modification_factor,
    reliability_factor,
)
from coupling_design.parts.bearing.modified_life import modified_rating_life
from coupling_design.parts.bearing.parameters import Cleanliness

loads = st.floats(1e2, 4e5)
# Below 0.10007 the printed constants make X of roller bearings less than zero.
kappas = st.floats(0.1001, 4)
parts = st.floats(0, 1)


def test_basic_rating_life_of_a_roller_bearing(nu2326):
    # (920/50)^(10/3) = 18.4^(10/3) = 16 445.967 million
    assert basic_rating_life(50e3, nu2326) == pytest.approx(1.6445967e10, rel=1e-7)


def test_basic_rating_life_of_a_ball_bearing(ball):
    # (100/20)^3 = 125 million
    assert basic_rating_life(20e3, ball) == pytest.approx(125e6, rel=1e-12)


@given(loads, st.floats(1, 10))
def test_life_falls_with_the_power_of_load(nu2326, ball, load, ratio):
    for bearing, p in ((nu2326, 10 / 3), (ball, 3)):
        shorter = basic_rating_life(load * ratio, bearing)

        assert shorter == pytest.approx(basic_rating_life(load, bearing) * ratio**-p)


def test_fatigue_load_limit_of_the_paper(nu2326):
    # 1 230 000 / 8.2 * (100/205)^0.3 = 150 000 * 0.806258
    assert fatigue_load_limit(nu2326) == pytest.approx(120938.6, abs=0.1)


def test_fatigue_load_limit_of_a_ball_bearing(ball):
    # 66 kN / 22 * (100/144)^0.5 = 3 kN / 1.2
    assert fatigue_load_limit(ball) == pytest.approx(2500, rel=1e-12)


def test_fatigue_load_limit_of_small_bearings(nu2326, ball):
    # no diameter factor up to 100 mm
    small = [dataclasses.replace(b, pitch_diameter=0.08) for b in (nu2326, ball)]

    assert [fatigue_load_limit(b) for b in small] == pytest.approx([150e3, 3e3])


@pytest.mark.parametrize(
    ("kappa", "expected"),
    [
        # e_C C_u / P = 0.3: 0.3^(1/3) = 0.669433
        # 2.5671 - 2.2649/0.2^0.054381 = 0.0950360; ^0.83 = 0.141790; 0.905081^-9.3
        (0.2, 0.252818),
        # 2.5671 - 1.9987/0.5^0.19087 = 0.285680; ^0.83 = 0.353493; 0.763360^-9.3
        (0.5, 1.232012),
        # 2.5671 - 1.9987/2^0.071739 = 0.665356; ^0.83 = 0.713075; 0.522644^-9.3
        (2.0, 41.752417),
    ],
)
def test_life_modification_factor_of_a_ball_bearing(ball, kappa, expected):
    load = fatigue_load_limit(ball) / 0.3

    factor = life_modification_factor(load, kappa, 1.0, ball)

    assert factor == pytest.approx(expected, rel=1e-6)


@pytest.mark.parametrize("border", [0.4, 1.0])
def test_life_modification_factor_is_continuous(bearing, border):
    load = fatigue_load_limit(bearing) / 0.3
    sides = border * np.array([1 - 1e-9, 1 + 1e-9])

    below, above = life_modification_factor(load, sides, 1.0, bearing)

    # The printed constants leave a step for balls at 0.4: X = 0.18648 and 0.18641.
    assert below == pytest.approx(above, rel=1e-3)


def test_life_modification_factor_has_kinks_where_the_standard_has(nu2326):
    def slope(kappa):
        pair = np.array([kappa, kappa + 1e-5])
        return np.diff(life_modification_factor(1e5, pair, 0.5, nu2326))[0]

    assert slope(1 - 2e-5) > 2 * slope(1 + 1e-5)
    assert slope(0.4 + 1e-5) > 2 * slope(0.4 - 2e-5)


@pytest.mark.parametrize("load", [0.0, 1.0, 1e3])
def test_life_modification_factor_saturates_at_50(bearing, load):
    # the bracket is far below zero
    factor = life_modification_factor(load, 4.0, 1.0, bearing)

    assert factor == pytest.approx(50, rel=1e-12)


def test_life_modification_factor_reaches_50_without_a_step(bearing):
    loads = fatigue_load_limit(bearing) * np.linspace(0.1, 3, 20_000)
    factors = life_modification_factor(loads, 4.0, 1.0, bearing)

    assert factors.max() == pytest.approx(50)
    assert np.abs(np.diff(factors)).max() < 0.1


def test_dirt_leaves_a_tenth(bearing):
    factor = life_modification_factor(1e4, 2.0, 0.0, bearing)

    assert factor == pytest.approx(0.1, rel=1e-8)


@given(loads, st.floats(1, 10), st.tuples(kappas, kappas), st.tuples(parts, parts))
def test_better_conditions_never_shorten_life(
    nu2326, ball, load, ratio, kappa_pair, cleanliness_pair
):
    (low, high), (dirty, clean) = sorted(kappa_pair), sorted(cleanliness_pair)
    # As printed, the factor of ball bearings steps down by up to 0.3 % at kappa = 0.4.
    for bearing, step in ((nu2326, 1e-5), (ball, 3e-3)):
        limit = (1 + step) * life_modification_factor(load, high, clean, bearing)
        assert life_modification_factor(load, low, clean, bearing) <= limit
        assert life_modification_factor(load, high, dirty, bearing) <= limit
        assert life_modification_factor(load * ratio, high, clean, bearing) <= limit


@pytest.mark.parametrize("load", [1e4, 3e4, 1e5])
def test_tendencies_of_modified_life(nu2326, grease, rpm, load):
    lives = [
        modified_rating_life(
            load, rpm(200), nu2326, dataclasses.replace(grease, cleanliness=c), 0.99
        )
        for c in Cleanliness
    ]
    by_reliability = [
        modified_rating_life(load, rpm(200), nu2326, grease, r)
        for r in RELIABILITY_FACTORS
    ]

    assert lives == sorted(lives, reverse=True)
    assert by_reliability == sorted(by_reliability, reverse=True)


def test_modified_rating_life(nu2326, grease, rpm):
    # 50 kN, 120 rpm: kappa = 0.670008, e_C = 0.171263, e_C C_u / P = 0.414246,
    # X = 1.5859 - 1.2348/0.670008^0.19087 = 0.253015, bracket 0.822152, a_ISO 0.604179,
    # L_10 = 16 445.967e6; 0.25 * 0.604179 * 16 445.967e6 = 2 484.079e6
    life = modified_rating_life(50e3, rpm(120), nu2326, grease, 0.99)

    assert life == pytest.approx(2.484079e9, rel=1e-6)


@pytest.mark.parametrize("reliability", [0.99, 99 / 100, 0.99 + 1e-12])
def test_reliability_factor_of_the_paper(reliability):
    assert reliability_factor(reliability) == 0.25


@pytest.mark.parametrize("reliability", [99, 0.985, 0.5])
def test_reliability_between_the_rows_is_refused(reliability):
    with pytest.raises(KeyError, match=r"no row .* Choose one of 0\.9, 0\.95, .*99 %"):
        reliability_factor(reliability)


POINTS = [
    (50e3, 0.2, 0.3),
    (50e3, 0.4, 0.3),
    (50e3, 1.0, 0.3),
    (50e3, 2.5, 1.0),
    (1.0, 4.0, 1.0),
]


@pytest.mark.parametrize("point", POINTS)
def test_life_is_one_for_all_number_types(evaluations, bearing, point):
    def life(load, kappa, e_C):
        factor = life_modification_factor(load, kappa, e_C, bearing)
        return factor * basic_rating_life(load, bearing)

    values = list(evaluations(life, *point))

    assert values == pytest.approx([values[0]] * 5, rel=1e-12)


LIMITS = [
    *[(50e3, kappa, 0.3) for kappa in (0, 0.05, 0.1, 0.4, 1, 4, 5)],
    *[(load, 2, 0.3) for load in (0, 1e-3, 1e-12)],
    *[(50e3, kappa, 0) for kappa in (0.1, 4)],
    (0, 0.1, 0),
]


@pytest.mark.parametrize("point", LIMITS)
def test_life_has_finite_derivatives(derivatives, bearing, point):
    def life(load, kappa, e_C):
        factor = life_modification_factor(load, kappa, e_C, bearing)
        return factor * basic_rating_life(load, bearing) / 1e6

    for parts in derivatives(life, *point):
        assert all(np.isfinite(part).all() for part in parts)


@pytest.mark.parametrize("kappa", [2.0, 4.0])
def test_derivatives_are_finite_at_the_edge_of_the_bracket(derivatives, nu2326, kappa):
    X = 1.5859 - 1.2348 / kappa**0.071739
    edge = ((1 - 500 ** (-1 / 9.185)) / X) ** 2.5
    for load in fatigue_load_limit(nu2326) / edge * np.array([1 - 1e-12, 1, 1 + 1e-12]):
        for parts in derivatives(
            lambda P: life_modification_factor(P, kappa, 1.0, nu2326), load
        ):
            assert all(np.isfinite(part).all() for part in parts)
            assert parts[0] == pytest.approx(50)


@pytest.mark.parametrize("point", [(60e3, 20.0), (45e3, 60.0), (30e3, 3.0)])
def test_gradient_agrees_with_finite_differences(derivatives, nu2326, grease, point):
    def life(load, speed):
        return modified_rating_life(load, speed, nu2326, grease, 0.99) / 1e9

    steps = np.diag(np.array(point) * 1e-6)
    differences = [
        (life(*(point + step)) - life(*(point - step))) / (2 * step.sum())
        for step in steps
    ]
    for _, gradient, _ in derivatives(life, *point):
        assert gradient.ravel() == pytest.approx(differences, rel=1e-6)

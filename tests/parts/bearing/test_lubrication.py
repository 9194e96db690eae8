import dataclasses

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from coupling_design.parts.bearing.lubrication import (
    GREASE_CONTAMINATION,
    contamination_factor,
    reference_viscosity,
    unclamped_viscosity_ratio,
    viscosity_at_temperature,
    viscosity_ratio,
)
from coupling_design.parts.bearing.parameters import Cleanliness

NU = 39.6e-6


@pytest.mark.parametrize(
    ("speed_rpm", "expected_mm2_per_s"),
    [
        # 45000 * 120^-0.83 * 205^-0.5 = 45000 * 0.01880527 * 0.06984303
        (120, 59.1038),
        # 4500 * 1000^-0.5 * 205^-0.5: the second branch holds at 1000 rpm itself
        (1000, 9.93884),
    ],
)
def test_reference_viscosity(nu2326, rpm, speed_rpm, expected_mm2_per_s):
    viscosity = reference_viscosity(rpm(speed_rpm), nu2326)

    assert viscosity == pytest.approx(expected_mm2_per_s * 1e-6, rel=1e-5)


def test_viscosity_ratio_of_the_paper_at_full_speed(nu2326, rpm):
    # 39.6 / 9.93884
    assert viscosity_ratio(NU, rpm(1000), nu2326) == pytest.approx(3.984, abs=5e-4)


@pytest.mark.parametrize("round_trip", [np.pi / 30, 1 / (30 / np.pi), 2 * np.pi / 60])
def test_1000_rpm_is_on_the_upper_side_of_the_step(nu2326, round_trip):
    assert viscosity_ratio(NU, 1000 * round_trip, nu2326) > 3.98


def test_viscosity_ratio_in_the_resonance(nu2326, rpm):
    # 39.6 / 59.1038
    assert viscosity_ratio(NU, rpm(120), nu2326) == pytest.approx(0.670008, rel=1e-5)


@pytest.mark.parametrize(("speed_rpm", "expected"), [(0, 0.1), (12, 0.1), (2000, 4)])
def test_viscosity_ratio_stays_within_the_standard(nu2326, rpm, speed_rpm, expected):
    assert viscosity_ratio(NU, rpm(speed_rpm), nu2326) == expected


def test_unclamped_ratio_tells_where_the_standard_ends(nu2326, rpm):
    # 0.1 = 39.6 n^0.83 205^0.5 / 45000 at n = 12.13 rpm
    ratios = unclamped_viscosity_ratio(NU, rpm(np.array([12.12, 12.14])), nu2326)

    assert ratios[0] < 0.1 < ratios[1]
    assert 0 < unclamped_viscosity_ratio(NU, 0.0, nu2326) < 1e-4


@given(st.floats(-200, 200))
def test_sense_of_rotation_does_not_matter(nu2326, speed):
    forward = unclamped_viscosity_ratio(NU, speed, nu2326)

    assert forward == unclamped_viscosity_ratio(NU, -speed, nu2326)


@pytest.mark.parametrize(
    ("cleanliness", "at_205_mm", "at_600_mm"),
    [
        # kappa = 1: min(1, c1 Dpw^0.55) (1 - c2 / Dpw^(1/3)), 205^0.55 = 18.68377,
        # 205^(1/3) = 5.896369; 600^0.55 = 33.7284, 600^(1/3) = 8.434327
        ("high", 0.884743, 0.919425),
        ("normal", 0.650950, 0.864719),
        ("slight_typical", 0.224869, 0.478279),
        ("severe", 0.117860, 0.265449),
        ("very_severe", 0.0359025, 0.107927),
    ],
)
def test_contamination_factor(cleanliness, at_205_mm, at_600_mm):
    diameters = np.array([0.205, 0.600])
    factors = contamination_factor(1.0, diameters, Cleanliness(cleanliness))

    assert factors == pytest.approx([at_205_mm, at_600_mm], rel=1e-5)


def test_contamination_factor_follows_viscosity_ratio():
    # 0.0177 * 0.670008^0.68 * 205^0.55 * (1 - 1.887/205^(1/3)) = 0.251868 * 0.679974
    factor = contamination_factor(0.670008, 0.205, Cleanliness.SLIGHT_TYPICAL)

    assert factor == pytest.approx(0.171263, rel=1e-5)


def test_small_bearing_in_dirt_has_nothing_left():
    # 4.06^3 = 66.9 mm
    assert contamination_factor(2.0, 0.066, Cleanliness.VERY_SEVERE) == 0
    assert contamination_factor(2.0, 0.068, Cleanliness.VERY_SEVERE) > 0


def test_cleaner_and_thicker_leave_more():
    kappas = np.linspace(0.1, 4, 40)
    table = np.array([contamination_factor(kappas, 0.205, c) for c in Cleanliness])

    assert (np.diff(table, axis=0) <= 0).all()
    assert (np.diff(table, axis=1) >= 0).all()
    assert ((table >= 0) & (table <= 1)).all()


def test_grease_table_has_every_class():
    assert set(GREASE_CONTAMINATION) == set(Cleanliness)


def test_viscosity_at_its_own_catalogue_points():
    values = viscosity_at_temperature(np.array([313.15, 373.15]), 120e-6, 12e-6)

    assert values == pytest.approx([120e-6, 12e-6], rel=1e-12)


def test_viscosity_at_temperature():
    # lg lg 120.7 = 0.318420, lg lg 12.7 = 0.042892, B = 3.619126;
    # at 353.15 K: lg lg Z = 0.318420 - B lg(353.15/313.15), Z = 22.2504
    value = viscosity_at_temperature(353.15, 120e-6, 12e-6)

    assert value == pytest.approx(21.5504e-6, rel=1e-5)


@pytest.mark.parametrize("speed_rpm", [0, 5, 120, 999, 1000, 2000, -300])
def test_viscosity_ratio_is_one_for_all_number_types(
    evaluations, nu2326, rpm, speed_rpm
):
    def ratio(speed):
        return viscosity_ratio(NU, speed, nu2326)

    values = list(evaluations(ratio, rpm(speed_rpm)))

    assert values == pytest.approx([values[0]] * 5, rel=1e-13)


@pytest.mark.parametrize("diameter", [0.205, 0.6])
def test_contamination_factor_is_one_for_all_number_types(evaluations, diameter):
    def factor(kappa, pitch_diameter):
        return contamination_factor(kappa, pitch_diameter, Cleanliness.SLIGHT_TYPICAL)

    values = list(evaluations(factor, 0.7, diameter))

    assert values == pytest.approx([values[0]] * 5, rel=1e-14)


def test_viscosity_at_temperature_takes_symbols(evaluations):
    def viscosity(temperature):
        return viscosity_at_temperature(temperature, 120e-6, 12e-6)

    values = list(evaluations(viscosity, 330.0))

    assert values == pytest.approx([values[0]] * 5, rel=1e-13)


@pytest.mark.parametrize("speed", [0, 1e-5, -1e-5, 1.27, 104.7, 1e3])
def test_lubrication_has_finite_derivatives(derivatives, nu2326, speed):
    def chain(speed, viscosity):
        bearing = dataclasses.replace(nu2326, pitch_diameter=0.06)
        kappa = viscosity_ratio(viscosity, speed, bearing)
        factor = contamination_factor(kappa, 0.06, Cleanliness.VERY_SEVERE)
        return kappa + factor + unclamped_viscosity_ratio(viscosity, speed, bearing)

    for parts in derivatives(chain, speed, NU):
        assert all(np.isfinite(part).all() for part in parts)

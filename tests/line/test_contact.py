import dataclasses
import math

import casadi as ca
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from coupling_design.line.contact import (
    LARGEST_RELATIVE_SLOPE,
    contact_deflection,
    contact_slope,
    half_gap_angle,
    transmission_torque,
)

HALF_GAP = 2e-3  # of the fixture `key` [rad]
SHARPNESS = 1e5  # s = sigma r of the fixture `key` [1/rad]
TWISTS = st.floats(min_value=-0.01, max_value=0.01)


def test_half_gap_angle(key):
    # 0.28 mm / (2 * 100 mm)
    connection = dataclasses.replace(key, gap=0.28e-3)

    assert half_gap_angle(connection) == pytest.approx(1.4e-3, rel=1e-14)


@pytest.mark.parametrize("twist", [0.0, 1e-3, -1e-3, 1.8e-3, -1.8e-3])
def test_no_deflection_inside_the_gap(key, twist):
    # 0.2 mrad = 20 / s from the edge: 0.2e-3 tanh(20) is 0.2e-3 to 1e-21
    assert contact_deflection(twist, key) == pytest.approx(0.0, abs=1e-17)


@pytest.mark.parametrize(("twist", "expected"), [(5e-3, 3e-3), (-5e-3, -3e-3)])
def test_deflection_beyond_the_gap(key, twist, expected):
    assert contact_deflection(twist, key) == pytest.approx(expected, rel=1e-12)


def test_deflection_at_the_edge(key):
    # x = b: b + (0 - 2b tanh(2 s b)) / 2 = b (1 - tanh 400) = 0
    assert contact_deflection(HALF_GAP, key) == pytest.approx(0.0, abs=1e-17)


def test_deflection_near_the_edge(key):
    # x = b + 1/s: (1/s) (1 + tanh 1) / 2 = 1e-5 * 0.880797078
    x = HALF_GAP + 1 / SHARPNESS

    assert contact_deflection(x, key) == pytest.approx(0.880797078e-5, abs=1e-14)


def test_dip_inside_the_edge(key):
    # u (1 + tanh u) / 2 is smallest where u = -0.6392: -0.13923
    u = np.linspace(-3, 0, 100_001)
    dip = contact_deflection(HALF_GAP + u / SHARPNESS, key).min() * SHARPNESS

    assert dip == pytest.approx(-0.13923, abs=5e-6)


@given(TWISTS)
def test_deflection_is_odd(key, twist):
    assert contact_deflection(-twist, key) == -contact_deflection(twist, key)


@given(TWISTS)
def test_deflection_is_never_far_from_the_sharp_one(key, twist):
    sharp = math.copysign(max(abs(twist) - HALF_GAP, 0.0), twist)

    assert abs(contact_deflection(twist, key) - sharp) <= 0.1393 / SHARPNESS


@given(TWISTS)
def test_deflection_has_no_jump(key, twist):
    nearby = twist + 1e-9

    rise = contact_deflection(nearby, key) - contact_deflection(twist, key)
    assert abs(rise) <= LARGEST_RELATIVE_SLOPE * 1e-9 + 1e-17


@given(TWISTS, st.floats(min_value=1e3, max_value=1e7))
def test_without_a_gap_the_contact_is_linear(key, twist, smoothing):
    connection = dataclasses.replace(key, gap=0.0, smoothing=smoothing)

    assert contact_deflection(twist, connection) == twist
    assert contact_slope(twist, connection) == 1.0


@given(TWISTS)
def test_slope_is_the_derivative(key, twist):
    x = ca.SX.sym("x")
    derivative = ca.Function("d", [x], [ca.jacobian(contact_deflection(x, key), x)])

    expected = float(derivative(twist))
    assert contact_slope(twist, key) == pytest.approx(expected, rel=1e-9, abs=1e-12)


@pytest.mark.parametrize(("twist", "slope"), [(0.0, 0.0), (HALF_GAP, 0.5), (5e-3, 1.0)])
def test_slope_inside_at_the_edge_and_outside(key, twist, slope):
    assert contact_slope(twist, key) == pytest.approx(slope, abs=1e-12)


def test_largest_relative_slope(key):
    # u tanh u = 1 at u = 1.19968: slope (1 + tanh u + u sech^2 u) / 2 = (1 + u) / 2
    u = np.linspace(0, 5, 500_001)
    steepest = contact_slope(HALF_GAP + u / SHARPNESS, key).max()

    assert pytest.approx((1 + 1.19968) / 2, abs=1e-6) == LARGEST_RELATIVE_SLOPE
    assert steepest == pytest.approx(LARGEST_RELATIVE_SLOPE, abs=1e-6)


def test_transmission_torque_on_the_flank(key):
    # 1e6 (5e-3 - 2e-3) + 50 * 0.2 = 3000 + 10
    assert transmission_torque(5e-3, 0.2, key) == pytest.approx(3010.0, rel=1e-12)


def test_oil_drags_inside_the_gap(key):
    assert transmission_torque(1e-3, 0.2, key) == pytest.approx(10.0, rel=1e-12)

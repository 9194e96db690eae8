import math

import casadi as ca
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from coupling_design.line.motion import motion, reduced_inertia, state_names
from coupling_design.line.torques import excitation_torque, resistance_torque

ANGLES = st.floats(min_value=-0.05, max_value=0.05)
SPEEDS = st.floats(min_value=-60.0, max_value=60.0)


def test_reduced_inertia(keyed, tight):
    # 10 (2 + 20) / 32
    assert reduced_inertia(keyed) == pytest.approx(6.875, rel=1e-14)
    assert reduced_inertia(tight) == pytest.approx(6.875, rel=1e-14)


def test_state_of_either_connection(keyed, tight):
    assert len(state_names(keyed)) == 6
    assert state_names(keyed)[2] == "generator_angle"
    assert len(state_names(tight)) == 4
    assert state_names(tight)[1] == "generator_angle"


def test_keyed_motion_by_hand(keyed, motion_at):
    """Work the accelerations of eq. (1) by hand.

    th = (pi/12, pi/12 - 0.02, pi/12 - 0.025), w = (50, 49, 48) rad/s:
    T_e = 100 sin(2 pi/12) = 50; engine 50 + 30 = 80, generator 24 + 10 = 34 N m
    T_c = 1e5 * 0.02 + 200 * 1 = 2200 N m
    r F_c = 1e6 (0.005 - 0.002) + 50 * 1 = 3050 N m
    """
    th = math.pi / 12
    now = motion_at(keyed, [th, th - 0.02, th - 0.025, 50, 49, 48])

    accelerations = [(50 - 80 - 2200) / 10, (2200 - 3050) / 2, (3050 - 34) / 20]
    expected = [50, 49, 48, *accelerations]
    assert now.state_rate == pytest.approx(expected, rel=1e-12)
    assert now.engine_torque == pytest.approx(-30.0, rel=1e-12)
    assert now.coupling_torque == pytest.approx(2200.0, rel=1e-12)
    assert now.transmission_force == pytest.approx(30_500.0, rel=1e-12)
    assert (now.engine_speed, now.generator_speed) == (50, 48)
    assert now.generator_angle == pytest.approx(th - 0.025, rel=1e-14)


def test_tight_motion_by_hand(tight, motion_at):
    """Work eq. (1) with J2 and J3 turning together.

    th = (pi/12, pi/12 - 0.02), w = (50, 48): T_c = 2000 + 200 * 2 = 2400 N m,
    a3 = (2400 - 34) / 22, and the hub carries J3 a3 + T_d.
    """
    th = math.pi / 12
    now = motion_at(tight, [th, th - 0.02, 50, 48])

    a_3 = (2400 - 34) / 22
    expected = [50, 48, (50 - 80 - 2400) / 10, a_3]
    assert now.state_rate == pytest.approx(expected, rel=1e-12)
    assert now.coupling_torque == pytest.approx(2400.0, rel=1e-12)
    assert now.transmission_force == pytest.approx((20 * a_3 + 34) / 0.1, rel=1e-12)


def external_torque(driveline, engine_angle, engine_speed, generator_speed):
    return (
        excitation_torque(engine_angle, driveline.excitation)
        - resistance_torque(engine_speed, driveline.engine_resistance)
        - resistance_torque(generator_speed, driveline.generator_resistance)
    )


@given(st.tuples(ANGLES, ANGLES, ANGLES), st.tuples(SPEEDS, SPEEDS, SPEEDS))
def test_keyed_inner_torques_cancel(keyed, motion_at, angles, speeds):
    """Action and reaction: J1 a1 + J2 a2 + J3 a3 is what acts from outside."""
    a = motion_at(keyed, [*angles, *speeds]).state_rate[3:]

    outside = external_torque(keyed, angles[0], speeds[0], speeds[2])
    assert 10 * a[0] + 2 * a[1] + 20 * a[2] == pytest.approx(outside, abs=1e-9)


@given(st.tuples(ANGLES, ANGLES), st.tuples(SPEEDS, SPEEDS))
def test_tight_inner_torques_cancel(tight, motion_at, angles, speeds):
    a = motion_at(tight, [*angles, *speeds]).state_rate[2:]

    outside = external_torque(tight, angles[0], speeds[0], speeds[1])
    assert 10 * a[0] + 22 * a[1] == pytest.approx(outside, abs=1e-9)


def test_tight_hub_carries_less_than_the_coupling(tight, motion_at):
    # The coupling turns J2 too: T_c - r F_c = J2 a3
    now = motion_at(tight, [0.02, 0.0, 50, 48])

    left_over = now.coupling_torque - 0.1 * now.transmission_force
    assert left_over == pytest.approx(2 * now.state_rate[3], rel=1e-12)


def test_turning_the_whole_line_changes_nothing_but_the_excitation(
    keyed, quiet, motion_at
):
    state = np.array([0.02, 0.0, -0.005, 50, 49, 48])
    turned = state + np.array([1.0, 1.0, 1.0, 0, 0, 0])

    still = motion_at(quiet(keyed), state).state_rate
    assert motion_at(quiet(keyed), turned).state_rate == pytest.approx(still, rel=1e-9)


@pytest.mark.parametrize("name", ["keyed", "closed", "tight"])
def test_no_nan_in_derivatives_at_rest(request, name):
    driveline = request.getfixturevalue(name)
    n = len(state_names(driveline))
    state = ca.SX.sym("state", n)
    rate = motion(driveline, state).state_rate
    jacobian = ca.Function("jacobian", [state], [ca.jacobian(rate, state)])

    assert np.isfinite(np.asarray(jacobian(ca.DM.zeros(n)))).all()

import dataclasses

import casadi as ca
import numpy as np
import pytest

from coupling_design.line.even_start import quasi_steady_state
from coupling_design.line.parameters import Resistance

SPEED = 40.0
# Resistance of the fixtures at 40 rad/s: engine 40 + 30, generator 20 + 10 [N m].
DECELERATION = -(70 + 30) / 32


def start_of(driveline, speed=SPEED):
    return np.asarray(ca.DM(quasi_steady_state(driveline, speed))).ravel()


def without_excitation(driveline):
    return dataclasses.replace(driveline, excitation=())


@pytest.mark.parametrize("name", ["keyed", "closed", "tight"])
def test_all_inertias_share_the_mean_deceleration(request, motion_at, name):
    driveline = without_excitation(request.getfixturevalue(name))
    now = motion_at(driveline, start_of(driveline))

    accelerations = now.state_rate[len(now.state_rate) // 2 :]
    assert accelerations == pytest.approx([DECELERATION] * len(accelerations), rel=1e-9)


@pytest.mark.parametrize("name", ["keyed", "closed", "tight"])
def test_force_that_brakes_the_generator(request, motion_at, name):
    # r F_c = J3 a + T_d = -20 * 3.125 + 30 = -32.5 N m at r = 0.1 m
    driveline = without_excitation(request.getfixturevalue(name))
    now = motion_at(driveline, start_of(driveline))

    assert now.transmission_force == pytest.approx(-325.0, rel=1e-9)
    # T_c = r F_c + J2 a = -32.5 - 6.25
    assert now.coupling_torque == pytest.approx(-38.75, rel=1e-9)


def test_twists_by_hand_with_the_gap_closed(closed):
    # key -32.5 / 1e6, coupling -38.75 / 1e5 [rad]
    key, coupling = -3.25e-5, -3.875e-4

    expected = [key + coupling, key, 0, SPEED, SPEED, SPEED]
    assert start_of(closed) == pytest.approx(expected, rel=1e-12)


def test_twist_of_the_key_lies_on_the_flank(keyed):
    # s f = 1e5 * 32.5e-6 = 3.25 = u (1 + tanh u) / 2 at u = 3.254839: x = b + u / s
    assert start_of(keyed)[1] == pytest.approx(-2.03254839e-3, abs=1e-10)


def test_the_generator_may_brake_the_engine(keyed, motion_at):
    """Braked more than its share, the generator pulls the other flank."""
    driveline = without_excitation(
        dataclasses.replace(keyed, generator_resistance=Resistance(0.0, 300.0, 0.2))
    )
    start = start_of(driveline)
    # a = -(70 + 300) / 32; r F_c = 20 a + 300 = 68.75 N m
    now = motion_at(driveline, start)

    assert start[1] > 2e-3
    assert now.transmission_force == pytest.approx(687.5, rel=1e-9)


def test_nothing_that_brakes_leaves_the_line_untwisted(keyed, quiet):
    assert start_of(quiet(keyed)) == pytest.approx([0, 0, 0, SPEED, SPEED, SPEED])


@pytest.mark.parametrize("torque", [1e-3, 1.0, 1e3])
def test_key_is_in_balance_however_small_the_torque(keyed, motion_at, torque):
    driveline = dataclasses.replace(
        without_excitation(keyed), engine_resistance=Resistance(0.0, torque, 0.2)
    )
    now = motion_at(driveline, start_of(driveline))

    a = -(torque + 30) / 32
    assert now.transmission_force == pytest.approx((20 * a + 30) / 0.1, rel=1e-9)


@pytest.mark.parametrize("name", ["keyed", "tight"])
def test_design_variables_may_be_symbols(request, name):
    driveline = request.getfixturevalue(name)
    stiffness = ca.SX.sym("stiffness")
    coupling = dataclasses.replace(driveline.coupling, torsional_stiffness=stiffness)
    symbolic = dataclasses.replace(driveline, coupling=coupling)
    compiled = ca.Function("start", [stiffness], [quasi_steady_state(symbolic, SPEED)])

    start = np.asarray(compiled(1e5)).ravel()
    assert start == pytest.approx(start_of(driveline), rel=1e-14)

import math

import casadi as ca
import pytest

from coupling_design.line.parameters import ExcitationOrder, Resistance
from coupling_design.line.torques import excitation_torque, resistance_torque

FOURTH = ExcitationOrder(4.0, 1200.0, 0.0)
EIGHTH = ExcitationOrder(8.0, 600.0, math.pi / 2)


def test_orders_add_up():
    # theta = pi/24: 1200 sin(30 deg) + 600 sin(60 deg + 90 deg) = 600 + 300
    torque = excitation_torque(math.pi / 24, (FOURTH, EIGHTH))

    assert torque == pytest.approx(900.0, rel=1e-14)


def test_no_orders_no_torque():
    assert excitation_torque(1.0, ()) == 0.0


def test_mean_over_a_revolution_is_zero():
    angles = [2 * math.pi * i / 64 for i in range(64)]
    torques = [excitation_torque(angle, (FOURTH, EIGHTH)) for angle in angles]

    assert sum(torques) / 64 == pytest.approx(0.0, abs=1e-9)


def test_symbols_give_the_same_torque():
    angle = ca.SX.sym("angle")
    compiled = ca.Function("T", [angle], [excitation_torque(angle, (FOURTH, EIGHTH))])

    expected = excitation_torque(0.3, (FOURTH, EIGHTH))
    assert float(compiled(0.3)) == pytest.approx(expected, rel=1e-14)


def test_resistance_of_a_turning_shaft():
    # 2 * 50 + 300 tanh(50 / 0.2) = 100 + 300
    assert resistance_torque(50.0, Resistance(2.0, 300.0, 0.2)) == pytest.approx(400.0)


def test_resistance_at_the_transition_speed():
    # 2 * 0.2 + 300 tanh(1) = 0.4 + 300 * 0.761594156
    torque = resistance_torque(0.2, Resistance(2.0, 300.0, 0.2))

    assert torque == pytest.approx(228.8782468, abs=1e-7)


def test_resistance_brakes_either_way_and_not_at_standstill():
    resistance = Resistance(2.0, 300.0, 0.2)

    assert resistance_torque(0.0, resistance) == 0.0
    assert resistance_torque(-50.0, resistance) == pytest.approx(-400.0)

"""Two masses on a coupling, worked by hand.

J1 = 2, J2 + J3 = 3 kg m^2 (tight fit), so J_red = 6/5 = 1.2 kg m^2 and
J_L / (J_A + J_L) = 3/5. k = 12 000 N m/rad: omega_n = sqrt(12 000 / 1.2) = 100 rad/s.
One order, i = 2, T_i = 50 N m: the driving torque that reaches the coupling quasi
statically is 50 x 0.6 = 30 N m. psi = 2 pi / 5, so that psi / 2 pi = 0.2 and
V_R = sqrt(1 + 25) = 5.0990.
"""

import math
from dataclasses import replace

import numpy as np
import pytest

from coupling_design.line.forced_response import forced_response
from coupling_design.line.parameters import (
    Coupling,
    Driveline,
    ExcitationOrder,
    LossFactorDamping,
    ProportionalDamping,
    RelativeDamping,
    Resistance,
    TightFit,
)
from coupling_design.speeds.coupling_load import (
    frequency_factor,
    resonance_passage,
    working_load,
)
from coupling_design.speeds.vibration import evaluate_vibration

FREE = Resistance(viscous=0.0, friction=0.0, transition_speed=1.0)
PSI = RelativeDamping(2 * math.pi / 5)
ORDER_2 = (ExcitationOrder(2.0, 50.0, 0.0),)


def two_masses(law=PSI, orders=ORDER_2):
    return Driveline(
        engine_inertia=2.0,
        coupling_inertia=1.0,
        generator_inertia=2.0,
        coupling=Coupling(12e3, law),
        connection=TightFit(radius=0.05),
        excitation=orders,
        engine_resistance=FREE,
        generator_resistance=FREE,
    )


@pytest.mark.parametrize(
    ("hertz", "factor"), [(0.5, 1.0), (10.0, 1.0), (40.0, 2.0), (22.5, 1.5)]
)
def test_frequency_factor(hertz, factor):
    """sqrt(40/10) = 2; nothing below 10 Hz."""
    assert frequency_factor(hertz) == pytest.approx(factor)


def test_resonance_factor_of_din_740():
    """Passed at 100/2 = 50 rad/s: 30 N m x sqrt(1 + (2 pi/psi)^2) = 152.97 N m."""
    passage = resonance_passage(two_masses(), 60.0)
    assert passage.speed == pytest.approx(50.0)
    assert passage.order == 2.0
    assert passage.torque == pytest.approx(30 * math.sqrt(26), rel=1e-9)


def test_a_resonance_above_the_lowest_speed_is_not_passed():
    assert resonance_passage(two_masses(), 49.0) is None


def test_vibratory_torque_above_resonance():
    """At 100 rad/s, order 2: r = 2, f = 200 / 2 pi = 31.83 Hz, S_f = 1.7841.

    V = sqrt((1 + 0.04) / ((1 - 4)^2 + 0.04)) = 0.33918; T_W = 30 x V = 10.175 N m;
    x S_f = 18.154 N m. Twist 10.175 / (12e3 sqrt(1.04)) = 8.3149e-4 rad. Damping work
    per cycle psi/2 k x^2 = 0.62832 x 12e3 x 6.9138e-7 = 5.2128e-3 J, x 31.831 Hz
    = 0.16593 W.
    """
    load = working_load(two_masses(), (100.0, 100.0))
    assert load.vibratory_torque == pytest.approx(18.154, rel=1e-4)
    assert load.power_loss == pytest.approx(0.16593, rel=1e-4)


def test_power_loss_as_makers_print_it():
    """P_W = pi T_W^2 f / (C_Tdyn (2 pi/psi + psi/2 pi)), T_W = 10.175 N m.

    pi x 103.53 x 31.831 / (12e3 x 5.2) = 0.16592 W, once more by another road.
    """
    T_W = 18.154 / 1.7841
    printed = math.pi * T_W**2 * 31.831 / (12e3 * (5 + 0.2))
    found = working_load(two_masses(), (100.0, 100.0)).power_loss
    assert found == pytest.approx(printed, rel=2e-4)


def test_orders_add_up():
    orders = (ExcitationOrder(2.0, 50.0, 0.0), ExcitationOrder(2.0, -50.0, 1.0))
    one = working_load(two_masses(), (100.0, 100.0))
    two = working_load(two_masses(orders=orders), (100.0, 100.0))
    assert two.vibratory_torque == pytest.approx(2 * one.vibratory_torque)
    assert two.power_loss == pytest.approx(2 * one.power_loss)


def test_a_resonance_inside_the_range_is_found():
    """50 rad/s is on no even grid from 41 to 97; f = 15.915 Hz there, S_f = 1.2616."""
    load = working_load(two_masses(), (41.0, 97.0))
    at_resonance = 30 * math.sqrt(26) * math.sqrt(100 / (2 * math.pi) / 10)
    assert load.vibratory_torque >= at_resonance * (1 - 1e-12)
    assert load.vibratory_torque == pytest.approx(at_resonance, rel=0.02)
    assert load.vibratory_speed == pytest.approx(50.0, rel=0.05)


def test_damping_per_cycle():
    """At 40 rad/s: 0.2 x 12e3 / 40 = 60; eta 0.1: 30 N m s/rad; viscous stays.

    Read back from the heat, c w^2 |x|^2 / 2.
    """
    viscous = ProportionalDamping(0.5, 290.0)
    for law, c in [
        (PSI, 60.0),
        (LossFactorDamping(0.1), 30.0),
        (viscous, 0.5 * 12e3 / 290),
    ]:
        line = replace(two_masses(), coupling=Coupling(12e3, law))
        speed = np.array([40.0 / line.excitation[0].order])
        response = forced_response(line, speed, per_cycle=True)
        twist = abs(response.twist[0, 0])
        heat = response.power_loss[0, 0]
        assert 2 * heat / (40.0 * twist) ** 2 == pytest.approx(c)


def test_one_heat_whoever_asks():
    """What a table over speed shows is what a sheet's P_KV is held against."""
    line, speed = two_masses(), 70.0
    vibration = evaluate_vibration(line, 100.0, [speed])
    at = list(vibration.speeds).index(speed)
    worst = working_load(line, (speed, speed))
    assert worst.power_loss == pytest.approx(vibration.power_loss[at], rel=1e-12)

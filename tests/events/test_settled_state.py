import dataclasses
import math

import casadi as ca
import numpy as np
import pytest

from coupling_design.events.settled_state import period_of, settled_state
from coupling_design.line.even_start import quasi_steady_state
from coupling_design.line.parameters import ExcitationOrder

SPEED = 40.0


def numbers(state):
    return np.asarray(ca.DM(state)).ravel()


def orders(*numbers_):
    return [ExcitationOrder(number, 1.0, 0.0) for number in numbers_]


@pytest.mark.parametrize(
    ("numbers_", "degrees"),
    [
        ((4, 8), 90),
        ((3, 6), 120),
        ((0.5,), 720),
        ((4.5, 6), 240),  # three of 4.5 and four of 6 in two thirds of a turn
        ((1.5, 2.5), 720),
        ((1 / 3, 1), 1080),
        ((), 360),
    ],
)
def test_period_of_orders(numbers_, degrees):
    assert math.degrees(period_of(orders(*numbers_))) == pytest.approx(degrees)


def test_orders_without_a_common_period_are_given_eight_turns():
    assert period_of(orders(1, math.sqrt(2))) == pytest.approx(16 * math.pi)


@pytest.mark.parametrize("name", ["closed", "tight"])
def test_it_repeats_after_the_period(request, name):
    line = request.getfixturevalue(name)
    period = period_of(line.excitation)
    first = numbers(settled_state(line, SPEED, 0.3))
    again = numbers(settled_state(line, SPEED, 0.3 + period))

    n = len(first) // 2
    assert again[:n] - period == pytest.approx(first[:n], abs=1e-12)
    assert again[n:] == pytest.approx(first[n:], abs=1e-12)


@pytest.mark.parametrize("name", ["closed", "tight"])
def test_its_mean_over_the_period_is_even_turning(request, name):
    line = request.getfixturevalue(name)
    angles = period_of(line.excitation) * np.arange(8) / 8
    states = np.stack([numbers(settled_state(line, SPEED, a)) for a in angles])
    n = states.shape[1] // 2
    states[:, :n] -= angles[:, np.newaxis]

    evenly = numbers(quasi_steady_state(line, SPEED))
    assert states.mean(axis=0) == pytest.approx(evenly, abs=1e-12)
    assert np.ptp(states[:, n:]) > 1e-3


def test_a_twice_as_strong_order_swings_twice_as_much(tight):
    def swing(factor):
        stronger = tuple(
            dataclasses.replace(order, amplitude=factor * order.amplitude)
            for order in tight.excitation
        )
        line = dataclasses.replace(tight, excitation=stronger)
        return numbers(settled_state(line, SPEED)) - numbers(
            quasi_steady_state(line, SPEED)
        )

    assert swing(2.0) == pytest.approx(2 * swing(1.0), rel=1e-9)


def test_the_engine_of_a_loose_coupling_swings_as_if_alone(tight):
    """J1 w^2 theta = -T sin(2 phi): by 100 / (10 * 80^2) rad, 1.5625 mrad."""
    loose = dataclasses.replace(tight.coupling, torsional_stiffness=1e-3)
    line = dataclasses.replace(tight, coupling=loose)
    angles = np.radians([0.0, 45.0, 90.0, 135.0])
    mean = numbers(quasi_steady_state(line, SPEED))[0]
    engine = [numbers(settled_state(line, SPEED, a))[0] - mean - a for a in angles]

    # The huge twist turns the crank too: only the amplitude is told by hand.
    amplitude = math.hypot(engine[0] - engine[2], engine[1] - engine[3]) / 2
    assert amplitude == pytest.approx(1.5625e-3, rel=1e-3)

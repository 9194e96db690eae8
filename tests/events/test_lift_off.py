"""The fixtures' key carries -32.5 N m at 40 rad/s and so is pressed by 32.5 urad."""

import dataclasses

import casadi as ca
import numpy as np
import pytest

from coupling_design.events.lift_off import LiftOff
from coupling_design.line.parameters import Shutdown

SHUTDOWN = Shutdown(40.0, 1.0, 1e-3)


def lifts_off(line):
    return LiftOff(line, SHUTDOWN, ca.SX.sym("none", 0)).happens(np.empty(0))


@pytest.fixture
def sharp(keyed):
    """Return the keyed line with a contact that is a spring from 1 urad on."""

    def driven(amplitude, **key):
        order = dataclasses.replace(keyed.excitation[0], amplitude=amplitude)
        connection = dataclasses.replace(
            keyed.connection, **{"smoothing": 1e8, "oil_damping": 0.0, **key}
        )
        return dataclasses.replace(keyed, excitation=(order,), connection=connection)

    return driven


def test_a_tight_fit_has_nothing_to_lift(tight):
    assert not lifts_off(tight)


def test_a_closed_gap_pulls_as_it_pushes(closed):
    assert not lifts_off(closed)


def test_a_weak_order_leaves_the_key_where_it_is(sharp):
    assert not lifts_off(sharp(1.0))


def test_a_strong_order_lifts_it(sharp):
    """Near the resonance 100 N m pass the key as 100 N m and more, 32.5 hold it."""
    assert lifts_off(sharp(100.0))


def test_the_border_by_hand(sharp):
    """The swing grows with the order; where it comes to 32.5 N m is the border.

    Two masses, the contact all but rigid: w = 80 rad/s, w_n^2 = 1e5 * 32 / 220, and
    w c / k = 80 * 200 / 1e5; of the coupling's torque J3 / J23 passes the key.
    """
    low, high = 1.0, 100.0
    for _ in range(40):
        middle = (low + high) / 2
        line = sharp(middle, contact_stiffness=1e8, smoothing=1e12)
        low, high = (low, middle) if lifts_off(line) else (middle, high)

    spring = 1 + 0.16j
    passed = 22 / 32 * abs(spring / (spring - 6400 / (1e5 * 32 / 220))) * 20 / 22
    assert low == pytest.approx(32.5 / passed, rel=0.01)


def test_a_contact_pressed_too_little_to_be_a_spring_counts_as_open(sharp):
    assert lifts_off(sharp(1.0, smoothing=1e6))

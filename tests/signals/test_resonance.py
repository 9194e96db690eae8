import math

import numpy as np
import pytest

from coupling_design.signals.history import History
from coupling_design.signals.resonance import largest_swing, rest_time

TIME = np.arange(0, 10, 1e-3)
OMEGA_N = 50.0


def history(force, engine_speed=None):
    """Return a history that slows from 100 to 0 rad/s in 10 s."""
    speed = 100 - 10 * TIME
    engine_speed = speed if engine_speed is None else engine_speed
    angle = 100 * TIME - 5 * TIME**2
    return History(TIME, force, force * 0.1, engine_speed, speed, angle)


def burst(amplitude, at):
    """Return a swing of OMEGA_N that swells and dies within a second or so."""
    swelling = np.exp(-((TIME - at) ** 2))
    return amplitude * swelling * np.sin(OMEGA_N * (TIME - at))


def test_largest_swing_of_a_burst():
    # Largest at 6 s, at 100 - 60 = 40 rad/s
    swing = largest_swing(history(burst(2000.0, 6.0)), OMEGA_N)

    assert swing.time == pytest.approx(6.0, abs=math.pi / OMEGA_N)
    assert swing.speed == pytest.approx(40.0, abs=10 * math.pi / OMEGA_N)
    assert swing.amplitude == pytest.approx(2000.0, rel=0.01)


def test_the_larger_of_two_bursts_counts():
    force = burst(2000.0, 6.0) + burst(-3000.0, 2.0)
    swing = largest_swing(history(force), OMEGA_N)

    assert swing.time == pytest.approx(2.0, abs=math.pi / OMEGA_N)
    assert swing.amplitude == pytest.approx(3000.0, rel=0.01)


def test_the_mean_does_not_count():
    quiet, loaded = (
        largest_swing(history(mean + burst(2000.0, 6.0)), OMEGA_N)
        for mean in (0.0, -20_000.0)
    )

    assert loaded.amplitude == pytest.approx(quiet.amplitude, rel=1e-9)
    assert loaded.time == quiet.time


def test_a_steady_force_does_not_swing():
    swing = largest_swing(history(np.full_like(TIME, 5000.0)), OMEGA_N)

    assert swing.amplitude == 0.0


def test_rest_time_is_when_it_stays_slow():
    speed = np.where(TIME < 7.0, 100 - 10 * TIME, 0.0)
    slow_once = np.where(np.abs(TIME - 5.0) < 0.1, 0.0, speed)

    assert rest_time(history(TIME, slow_once), 0.2) == pytest.approx(7.0, abs=1.5e-3)


def test_no_rest_time_while_it_turns():
    assert rest_time(history(TIME, np.full_like(TIME, 5.0)), 0.2) is None


def test_turning_backwards_is_not_rest():
    assert rest_time(history(TIME, np.full_like(TIME, -5.0)), 0.2) is None


def test_never_turning_rests_from_the_start():
    assert rest_time(history(TIME, np.zeros_like(TIME)), 0.2) == 0.0

import math

import numpy as np
import pytest

from coupling_design.signals.detrending import (
    collision_force,
    detrend,
    resonance_fluctuation,
)
from coupling_design.signals.history import History

STEP = 1e-4
TIME = np.arange(0, 6, STEP)
OMEGA_N = 2 * math.pi * 10  # period 0.1 s


def history(force=None, engine_speed=None):
    """Return a history of one signal; the others are zero."""
    zero = np.zeros_like(TIME)
    force = zero if force is None else force
    engine_speed = zero if engine_speed is None else engine_speed
    return History(TIME, force, zero, engine_speed, zero, zero)


def swing(amplitude):
    return amplitude * np.sin(OMEGA_N * TIME)


def impacts(peak, period=0.25):
    """Return bursts at 1 kHz that die with a time constant of 3 ms."""
    since = np.mod(TIME, period)
    return peak * np.exp(-since / 3e-3) * np.sin(2 * math.pi * 1000 * since)


@pytest.mark.parametrize("order", [1, 2])
@pytest.mark.parametrize("overlap", [0.0, 0.5, 0.9])
def test_a_polynomial_of_its_order_is_all_trend(order, overlap):
    x = np.linspace(0, 3, 1000)
    signal = (5.0 + 2 * x - x**2) if order == 2 else (5.0 + 2 * x)

    found = detrend(signal, 70, order, overlap)

    assert found.trend == pytest.approx(signal, abs=1e-12)
    assert found.fluctuation == pytest.approx(0.0, abs=1e-12)


def test_a_window_by_hand():
    # Least squares through 1, 0, 2: mean 1, slope (2 - 1) / 2; then through 3, 3, 6
    found = detrend(np.array([1.0, 0.0, 2.0, 3.0, 3.0, 6.0]), 3, order=1)

    assert found.trend == pytest.approx([0.5, 1.0, 1.5, 2.5, 4.0, 5.5])
    assert found.fluctuation == pytest.approx([0.5, -1.0, 0.5, 0.5, -1.0, 0.5])


def test_the_last_window_ends_with_the_signal():
    # Windows 0..2 and 1..3: means 1 and 2, weighed 1, 2, 1 over each window
    found = detrend(np.array([0.0, 1.0, 2.0, 3.0]), 3, order=0)

    assert found.trend == pytest.approx([1.0, 4 / 3, 5 / 3, 2.0])


def test_the_trend_has_no_step_where_windows_meet():
    signal = np.sin(np.linspace(0, 20, 4000))
    apart, together = (
        np.abs(np.diff(detrend(signal, 1000, overlap=share).trend)).max()
        for share in (0.0, 0.5)
    )

    assert apart > 0.1
    assert together < 0.02


def test_trend_and_fluctuation_are_the_signal():
    signal = swing(3.0) + impacts(1.0)
    found = detrend(signal, 125, overlap=0.5)

    assert found.trend + found.fluctuation == pytest.approx(signal, abs=1e-12)


def test_a_parabola_follows_the_resonance_over_an_eighth_of_its_period():
    # At most 0.4 / 6 (pi / 8)^3 = 0.40 % of the swing is left at a window's ends
    found = collision_force(history(swing(50e3)), OMEGA_N)

    assert np.abs(found.fluctuation).max() == pytest.approx(0.0040 * 50e3, rel=0.15)


def test_impacts_are_told_from_the_resonance():
    force, collisions = swing(30e3) + impacts(20e3), impacts(20e3)
    found = collision_force(history(force), OMEGA_N)

    missed = np.abs(found.fluctuation - collisions).max()
    assert missed < 0.15 * np.abs(collisions).max()
    assert np.ptp(found.fluctuation) == pytest.approx(np.ptp(collisions), rel=0.1)


def test_collision_force_does_not_know_the_mean():
    force = swing(30e3) + impacts(20e3)
    first, second = (
        collision_force(history(f), OMEGA_N).fluctuation for f in (force, force - 21e3)
    )

    assert first == pytest.approx(second, abs=1e-6)


def test_fluctuation_at_resonance():
    # Deceleration plus 2 rad/s at 10 Hz that swells and dies as exp(-(t-3)^2 / 0.5):
    # above half for |t - 3| < sqrt(0.5 ln 2) = 0.589 s, 11.8 cycles
    swelling = np.exp(-((TIME - 3.0) ** 2) / 0.5)
    speed = 50 - 8 * TIME + 0.1 * TIME**2 + swelling * swing(2.0)

    found = resonance_fluctuation(history(engine_speed=speed), OMEGA_N)

    assert found.number in (11, 12, 13)
    assert found.frequency == pytest.approx(10.0, rel=2e-3)
    assert found.amplitude == pytest.approx(2.0, rel=0.03)
    assert (found.start + found.end) / 2 == pytest.approx(3.0, abs=0.06)
    assert found.number / found.frequency == pytest.approx(found.end - found.start)


def test_only_neighbours_of_the_largest_count():
    bursts = [np.exp(-((TIME - at) ** 2) / 0.02) for at in (1.5, 4.5)]
    one, two = (
        resonance_fluctuation(history(engine_speed=swing(envelope)), OMEGA_N)
        for envelope in (bursts[0], bursts[0] + 0.9 * bursts[1])
    )

    assert one.number == two.number
    assert two.end < 3.0


def test_a_steady_deceleration_does_not_fluctuate():
    found = resonance_fluctuation(history(engine_speed=TIME * 0), OMEGA_N)

    assert found.number == 0
    assert found.amplitude == 0.0

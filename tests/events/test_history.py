import dataclasses
import math

import numpy as np
import pytest

from coupling_design.errors import SimulationError
from coupling_design.events.recording import simulate
from coupling_design.line.modes import natural_angular_frequency
from coupling_design.line.parameters import (
    Coupling,
    ProportionalDamping,
    QuasiSteadyStart,
    Resistance,
    Shutdown,
)
from coupling_design.signals.history import History

# What these show does not depend on it: from even turning it can be worked by hand.
EVENLY = QuasiSteadyStart()
RUN_DOWN = Shutdown(20.0, duration=0.25, time_step=5e-4, start=EVENLY)


def rough(driveline):
    """Return the driveline with order 2 strong enough to turn it back at the end."""
    order = dataclasses.replace(driveline.excitation[0], amplitude=60.0)
    return dataclasses.replace(driveline, excitation=(order,))


def steady(driveline):
    return dataclasses.replace(driveline, excitation=())


@pytest.mark.parametrize("name", ["keyed", "closed", "tight"])
def test_signals_begin_as_the_run_down_does(request, name):
    history = simulate(steady(request.getfixturevalue(name)), RUN_DOWN)

    signals = (f.name for f in dataclasses.fields(History) if "Array" in str(f.type))
    lengths = {len(getattr(history, name)) for name in signals}
    assert lengths == {RUN_DOWN.n_steps} == {500}
    assert history.time[:3] == pytest.approx([0, 5e-4, 1e-3])
    assert history.engine_speed[0] == history.generator_speed[0] == 20.0
    assert history.generator_angle[0] == 0.0
    # engine 20 + 30, generator 10 + 10: a = -70/32; F_c = (20 a + 20) / 0.1
    assert history.transmission_force[0] == pytest.approx(-237.5, rel=1e-9)


@pytest.mark.parametrize("name", ["keyed", "closed", "tight"])
def test_force_has_no_jump_at_the_start(request, name):
    """Unexcited, the line stays in its quasi-steady twist."""
    history = simulate(steady(request.getfixturevalue(name)), RUN_DOWN)

    # The viscous share falls with the speed, by 0.25 s * 2.19 / 20 rad/s.
    drift = np.abs(history.transmission_force / history.transmission_force[0] - 1)
    assert drift[:50].max() < 0.02
    assert drift.max() < 0.06


def test_strong_braking_does_not_ring(closed):
    """What the quasi-steady start is for: untwisted, the force would swing by 200 %."""
    braked = Resistance(0.0, 300.0, 0.2)
    driveline = dataclasses.replace(steady(closed), engine_resistance=braked)
    force = simulate(driveline, RUN_DOWN).transmission_force

    assert np.ptp(force) < 0.01 * abs(force[0])


def test_speed_falls_by_the_mean_deceleration(keyed):
    dry = Resistance(0.0, 32.0, 0.2)
    driveline = dataclasses.replace(
        steady(keyed), engine_resistance=dry, generator_resistance=dry
    )
    history = simulate(driveline, RUN_DOWN)

    # a = -64/32 = -2 rad/s^2: w = 20 - 2 t, angle = 20 t - t^2
    t = history.time
    assert history.generator_speed == pytest.approx(20 - 2 * t, abs=1e-6)
    assert history.engine_speed == pytest.approx(20 - 2 * t, abs=1e-6)
    assert history.generator_angle == pytest.approx(20 * t - t**2, abs=1e-6)


def test_free_swing_has_the_natural_frequency(tight, quiet):
    """A weak order at half the natural frequency's speed excites just that line."""
    omega_n = natural_angular_frequency(tight)
    driveline = dataclasses.replace(
        quiet(tight),
        excitation=(dataclasses.replace(tight.excitation[0], amplitude=1.0),),
        coupling=Coupling(1e5, ProportionalDamping(0.0, 1.0)),
    )
    history = simulate(driveline, Shutdown(omega_n / 2, 1.0, 5e-4, EVENLY))

    # Undamped at resonance the torque grows by T (J23 / J) omega_n / 2 a second.
    late = history.time > 1 - 2 * math.pi / omega_n
    expected = 0.5 * omega_n * (22 / 32)
    assert np.abs(history.coupling_torque[late]).max() == pytest.approx(
        expected, rel=0.02
    )


LONG = Shutdown(3.0, duration=12.0, time_step=1e-3, start=EVENLY)


@pytest.mark.parametrize("name", ["keyed", "tight"])
def test_friction_does_not_drive_the_engine_backwards(request, name):
    """Rocked by its excitation the engine may creep, but it comes to rest and stays.

    Dry friction smoothed over 0.2 rad/s lets it creep to where the excitation is zero,
    at 200 N m s/rad over 2 * 60 N m/rad: within some seconds.
    """
    history = simulate(rough(request.getfixturevalue(name)), LONG)

    resting, last = history.time > 6.0, history.time > 11.5
    assert np.abs(history.engine_speed[resting]).max() < 0.2
    assert np.abs(history.engine_speed[last]).max() < 2e-3
    assert np.abs(history.generator_speed[last]).max() < 2e-3


@pytest.mark.parametrize("name", ["keyed", "tight"])
def test_no_revolutions_after_rest(request, name):
    history = simulate(rough(request.getfixturevalue(name)), LONG)

    # Creep ends at the nearest zero of order 2, at most a quarter of its period off.
    resting = history.time > 6.0
    assert np.ptp(history.generator_angle[resting]) < math.pi / 4
    # 3 rad/s lost at about 40/32 rad/s^2
    turned = history.generator_angle[-1] - history.generator_angle[0]
    assert turned == pytest.approx(3**2 / 2 / (40 / 32), abs=math.pi / 2)


def test_too_large_a_step_says_when(keyed):
    # 6 times the largest stable one
    with pytest.raises(SimulationError, match=r"left finite numbers by .* s, with a"):
        simulate(keyed, Shutdown(20.0, 30.0, 0.02))


def test_pieces_join(tight):
    """A history is the same whether it is recorded in one piece or in several."""
    long = simulate(tight, Shutdown(20.0, 1.25, 5e-4))
    short = simulate(tight, Shutdown(20.0, 0.3, 5e-4))

    assert len(long.time) == 2500
    assert np.array_equal(long.engine_speed[:600], short.engine_speed)
    assert np.abs(np.diff(long.engine_speed)).max() < 0.05

"""The steady vibration of the linearised driveline, against numbers worked by hand."""

import dataclasses
import math

import numpy as np
import pytest

from coupling_design.events.recording import simulate
from coupling_design.line.forced_response import (
    forced_response,
    power_loss,
    vibratory_torque,
)
from coupling_design.line.modes import modes, natural_angular_frequency
from coupling_design.line.parameters import (
    Coupling,
    ExcitationOrder,
    LossFactorDamping,
    ProportionalDamping,
    RelativeDamping,
    Resistance,
    Shutdown,
)

# `tight`: J1 = 10 and J2 + J3 = 22 kg m^2 on k = 1e5 N m/rad, so J = 10 * 22 / 32 =
# 6.875 kg m^2 and w_n^2 = 1e5 / 6.875 = 14 545.4545, w_n = 120.60454 rad/s; c = 200 N m
# s/rad, so D = c / (2 sqrt(k J)) = 200 / (2 * 829.15620) = 0.12060454; the excitation
# is order 2 of 100 N m, so w = 2 Omega.
W_N = 120.60454
D = 0.12060454


def with_damping(driveline, law):
    stiffness = driveline.coupling.torsional_stiffness
    return dataclasses.replace(driveline, coupling=Coupling(stiffness, law))


@pytest.fixture(scope="module")
def unbraked(tight):
    """The two masses without resistance: a closed form in textbooks."""
    none = Resistance(0.0, 0.0, 0.2)
    return dataclasses.replace(tight, engine_resistance=none, generator_resistance=none)


def torque_of(driveline, speed):
    return float(vibratory_torque(driveline, np.array([speed]))[0, 0])


def test_slow_excitation_is_shared_by_inertia(unbraked):
    # Of 100 N m on 10 of 32 kg m^2 the other 22 take 22 / 32: 68.75 N m. At 1/1000 of
    # resonance it is magnified by 1 / (1 - 1e-6).
    assert torque_of(unbraked, W_N / 2e3) == pytest.approx(68.75, rel=2e-6)


def test_amplification_by_hand(unbraked):
    """V = sqrt(1 + (2 D r)^2) / sqrt((1 - r^2)^2 + (2 D r)^2) at r = w / w_n = 1.5.

    2 D r = 0.36181361, squared 0.13090909; 1 - 2.25 = -1.25, squared 1.5625;
    V = sqrt(1.13090909 / 1.69340909) = 0.81720831, times 68.75: 56.183071 N m.
    """
    assert torque_of(unbraked, 0.75 * W_N) == pytest.approx(56.183071, rel=1e-6)


def test_resonance_by_hand(unbraked):
    # V = sqrt(1 + 4 D^2) / (2 D): 4 D^2 = 0.05818182; sqrt 1.05818182 = 1.02868;
    # over 0.24120908: 4.2646801, times 68.75: 293.19676 N m.
    assert torque_of(unbraked, W_N / 2) == pytest.approx(293.19676, rel=1e-6)


def test_isolation_begins_at_sqrt_2_whatever_the_damping(unbraked):
    for damping_factor in (0.05, 0.5, 2.0):
        line = with_damping(unbraked, ProportionalDamping(damping_factor, 250.0))
        torque = torque_of(line, W_N / math.sqrt(2))
        assert torque == pytest.approx(68.75, rel=1e-6)


def test_twist_and_heat_at_resonance_by_hand(unbraked):
    """Check x = T_st / (2 D k): 68.75 / (0.24120908 * 1e5) = 2.8502244e-3 rad.

    P = c w^2 x^2 / 2 = 200 * 14 545.4545 * 8.1237793e-6 / 2 = 11.816406 W.
    """
    speed = np.array([W_N / 2])
    twist = np.abs(forced_response(unbraked, speed).twist)
    assert twist[0, 0] == pytest.approx(2.8502244e-3, rel=1e-6)
    assert power_loss(unbraked, speed)[0] == pytest.approx(11.816406, rel=1e-6)


def test_heat_is_the_work_of_the_excitation(unbraked):
    """Nothing else takes energy: P = T theta_1' / 2 in phase, theta_1 by its own sum.

    theta_1 = (T - T_c) / (-J1 w^2).
    """
    speeds = np.array([20.0, 60.0, 150.0])
    omega = 2 * speeds
    torque = forced_response(unbraked, speeds).coupling_torque[0]
    theta_1 = (100.0 - torque) / (-10.0 * omega**2)
    work = 100.0 * np.real(1j * omega * theta_1) / 2
    assert power_loss(unbraked, speeds) == pytest.approx(work, rel=1e-9)


def test_relative_damping_sets_the_heat_of_a_cycle_at_resonance(unbraked):
    # DIN 740: psi = A_D / A_el with A_el = k x^2 / 2, and A_D = P * 2 pi / w.
    line = with_damping(unbraked, RelativeDamping(0.8))
    found = forced_response(line, np.array([W_N / 2]))
    damping_work = found.power_loss[0, 0] * 2 * math.pi / W_N
    elastic = 1e5 * np.abs(found.twist[0, 0]) ** 2 / 2
    assert damping_work / elastic == pytest.approx(0.8, rel=1e-6)


def test_transmission_torque_of_a_tight_fit(unbraked):
    # The hub's share of 22 kg m^2 stays before the fit: 20 / 22 passes it.
    found = forced_response(unbraked, np.array([10.0, 60.0, 200.0]))
    expected = found.coupling_torque * 20 / 22
    assert found.transmission_torque == pytest.approx(expected, rel=1e-12)


def test_key_by_hand(keyed, quiet):
    """Three masses, undamped, w = 100: Holzer's chain from the generator's end.

    theta_3 = 1: -w^2 J3 = -2e5 through the key of 1e6, theta_2 = 1 - 0.2 = 0.8;
    T_c = -2e5 - 1e4 * 2 * 0.8 = -2.16e5; theta_1 = 0.8 - 2.16 = -1.36;
    T = -2.16e5 + 1e5 * 1.36 = -8e4. So T_c / T = 2.7 and r F_c / T = 2.5.
    """
    line = with_damping(quiet(keyed), ProportionalDamping(1e-9, 250.0))
    connection = dataclasses.replace(line.connection, oil_damping=0.0)
    order = (ExcitationOrder(4.0, 10.0, 0.0),)
    line = dataclasses.replace(line, connection=connection, excitation=order)

    found = forced_response(line, np.array([25.0]))
    assert found.coupling_torque[0, 0] == pytest.approx(27.0, rel=1e-6)
    assert found.transmission_torque[0, 0] == pytest.approx(25.0, rel=1e-6)
    assert found.twist[0, 0] == pytest.approx(27.0 / 1e5, rel=1e-6)


def test_a_gap_changes_nothing_while_it_is_closed(keyed, closed):
    speeds = np.linspace(1.0, 300.0, 20)
    assert np.array_equal(
        vibratory_torque(keyed, speeds), vibratory_torque(closed, speeds)
    )


def test_dry_friction_does_not_damp(tight):
    speeds = np.linspace(1.0, 300.0, 20)
    resistance = dataclasses.replace(tight.engine_resistance, friction=1e5)
    stuck = dataclasses.replace(tight, engine_resistance=resistance)
    assert np.array_equal(
        vibratory_torque(tight, speeds), vibratory_torque(stuck, speeds)
    )


def test_viscous_resistance_damps(unbraked, tight):
    assert torque_of(tight, W_N / 2) < torque_of(unbraked, W_N / 2)


def test_fast_excitation_is_held_off(unbraked):
    # w >> w_n with damping: T_c -> c T / (J1 w); at w = 2e4: 200 * 100 / 2e5 = 0.1 N m.
    assert torque_of(unbraked, 1e4) == pytest.approx(0.1, rel=2e-3)


def test_torque_falls_with_speed_above_resonance(unbraked):
    torque = vibratory_torque(unbraked, np.linspace(0.51 * W_N, 5 * W_N, 300))[0]
    assert np.all(np.diff(torque) < 0)


def test_torque_rises_with_speed_below_resonance(unbraked):
    line = with_damping(unbraked, LossFactorDamping(0.1))
    torque = vibratory_torque(line, np.linspace(0.01, 0.49, 300) * W_N)[0]
    assert np.all(np.diff(torque) > 0)


def test_amplitudes_are_proportional_to_excitation_and_not_to_phase(tight):
    speeds = np.linspace(1.0, 300.0, 20)
    one = vibratory_torque(tight, speeds)
    doubled = (ExcitationOrder(2.0, -200.0, 1.2),)
    two = vibratory_torque(dataclasses.replace(tight, excitation=doubled), speeds)
    assert two == pytest.approx(2 * one, rel=1e-12)


def test_orders_have_rows_and_their_heats_add_up(tight):
    first, second = ExcitationOrder(2.0, 100.0, 0.3), ExcitationOrder(4.0, 50.0, 0.0)
    speeds = np.array([20.0, 31.0, 150.0])

    def driven(*orders):
        return dataclasses.replace(tight, excitation=orders)

    both = vibratory_torque(driven(first, second), speeds)
    assert both.shape == (2, 3)
    assert both[0] == pytest.approx(vibratory_torque(driven(first), speeds)[0])
    assert both[1] == pytest.approx(vibratory_torque(driven(second), speeds)[0])
    heat = power_loss(driven(first), speeds) + power_loss(driven(second), speeds)
    assert power_loss(driven(first, second), speeds) == pytest.approx(heat)


def test_nothing_drives(tight):
    speeds = np.array([20.0, 31.0])
    line = dataclasses.replace(tight, excitation=())
    assert vibratory_torque(line, speeds).shape == (0, 2)
    assert power_loss(line, speeds).tolist() == [0.0, 0.0]


@pytest.mark.parametrize("speed", [0.0, -1.0, math.nan])
def test_standstill_is_refused(tight, speed):
    with pytest.raises(ValueError, match="above zero"):
        vibratory_torque(tight, np.array([10.0, speed]))


def test_resonance_of_each_mode(closed):
    """Lightly damped, the largest torque lies at each natural frequency."""
    line = with_damping(closed, ProportionalDamping(0.01, 250.0))
    connection = dataclasses.replace(line.connection, oil_damping=1.0)
    line = dataclasses.replace(line, connection=connection)
    for frequency in modes(line).angular_frequencies[1:]:
        speeds = np.linspace(0.8, 1.2, 401) * frequency / 2
        torque = vibratory_torque(line, speeds)[0]
        assert speeds[torque.argmax()] * 2 == pytest.approx(frequency, rel=5e-3)


def test_agrees_with_the_rollout(closed, quiet):
    """After 3 s it is steady: what the start sets ringing dies as exp(-13 t)."""
    order = (ExcitationOrder(2.0, 0.1, 0.7),)
    line = dataclasses.replace(quiet(closed), excitation=order)
    speed = 0.8 * float(natural_angular_frequency(line)) / 2
    history = simulate(line, Shutdown(speed, 4.0, 1e-4))
    late = history.time > 3.0
    torque = history.coupling_torque[late]
    amplitude = (torque.max() - torque.min()) / 2
    assert torque_of(line, speed) == pytest.approx(amplitude, rel=1e-4)


def test_agrees_with_open_torsion(closed, quiet):
    """The same three masses, springs and dampers, built by another program."""
    opentorsion = pytest.importorskip(
        "opentorsion", reason="openTorsion comes with the extra named test"
    )
    line = dataclasses.replace(
        quiet(closed), excitation=(ExcitationOrder(2.0, 100.0, 0.0),)
    )
    shafts = [
        opentorsion.Shaft(0, 1, k=1e5, c=200.0),
        opentorsion.Shaft(1, 2, k=1e6, c=50.0),
    ]
    discs = [opentorsion.Disk(i, I=J) for i, J in enumerate((10.0, 2.0, 20.0))]
    assembly = opentorsion.Assembly(shafts, disk_elements=discs)
    speeds = np.linspace(5.0, 500.0, 40)
    excitation = np.zeros((3, len(speeds)), dtype=complex)
    excitation[0] = 100.0
    angles, _ = assembly.ss_response(excitation, 2 * speeds)
    found = forced_response(line, speeds)

    assert np.abs(found.twist[0]) == pytest.approx(
        np.abs(angles[0] - angles[1]), rel=1e-8
    )

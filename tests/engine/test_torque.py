import dataclasses
import math

import numpy as np
import pytest

from coupling_design.engine import Charge, Cylinder, IndicatedCombustion, engine_figures
from coupling_design.engine.crank import cylinder_volume, piston_lever
from coupling_design.engine.pressure import cylinder_pressure
from coupling_design.engine.torque import (
    cylinder_torque,
    engine_torque,
    gas_torque,
    inertia_torque,
)

SMALL = Cylinder(0.1, 0.2, 0.4, 10.0, reciprocating_mass=2.0)


def test_motored_gas_torque_by_hand(vee):
    # A quarter turn after firing dead centre: (1.9747 - 1) bar x pi/4 (0.28 m)^2
    # x 0.1425 m = 97 470 Pa x 0.0615752 m^2 x 0.1425 m = 855.3 N m; before it, minus.
    angles = np.array([math.pi / 2, -math.pi / 2])
    found = cylinder_torque(angles, vee(50.0), fires=True)
    assert found == pytest.approx([855.3, -855.3], rel=1e-4)


def test_inertia_torque_by_hand():
    # a = 0.1 m, l = 0.4 m, m = 2 kg, 100 rad/s, 45 degrees. Rod's height
    # sqrt(0.16 - 0.005) = 0.393700; lever 0.0707107 (1 + 0.0707107 / 0.393700)
    # = 0.0834107; slope 0.0707107 + 0 + 0.005^2 / 0.393700^3 = 0.0711204;
    # -2 x 0.0711204 x 0.0834107 x 1e4 = -118.644 N m.
    found = inertia_torque(math.pi / 4, SMALL, 100.0)
    assert found == pytest.approx(-118.644, abs=1e-3)


def test_inertia_torque_takes_from_kinetic_energy():
    angles, h, omega = np.linspace(0, 2 * math.pi, 50), 1e-5, 80.0

    def energy(angle):
        return 0.5 * 2.0 * (piston_lever(angle, SMALL) * omega) ** 2

    expected = -(energy(angles + h) - energy(angles - h)) / (2 * h)
    found = inertia_torque(angles, SMALL, omega)
    assert found == pytest.approx(expected, abs=1e-5)


def series(ratio):
    """Return the amplitudes of sin 1 to sin 4, per m r^2 omega^2.

    Den Hartog's 1/2 (r/2l sin - sin 2 - 3r/2l sin 3), chapter 5, with the next powers
    of r/l as the handbooks print them (Taylor, The Internal-Combustion Engine in Theory
    and Practice, volume 2, chapter 8, ends where Den Hartog does).
    """
    return [
        ratio / 4 + ratio**3 / 16 + 15 * ratio**5 / 512,
        -1 / 2 - ratio**4 / 32,
        -3 * ratio / 4 - 9 * ratio**3 / 32 - 81 * ratio**5 / 512,
        -(ratio**2) / 4 - ratio**4 / 8,
    ]


@pytest.mark.parametrize("ratio", [0.05, 0.15, 0.25, 0.30])
def test_inertia_torque_against_the_textbook_series(ratio):
    cylinder = dataclasses.replace(SMALL, rod_length=0.1 / ratio)
    angles = np.arange(3600) * 2 * math.pi / 3600
    torque = inertia_torque(angles, cylinder, 30.0) / (2.0 * 0.1**2 * 30.0**2)
    sines = [2 * np.mean(torque * np.sin(i * angles)) for i in (1, 2, 3, 4)]
    assert sines == pytest.approx(series(ratio), rel=2 * ratio**4)
    leading = [ratio / 4, -0.5, -0.75 * ratio]
    assert sines[:3] == pytest.approx(leading, rel=0.4 * ratio**2)


def test_gas_torque_is_pressure_times_change_of_volume(vee):
    engine = vee(
        50.0, charge=Charge(3e5, 1e5, 1.35, 1.3), combustion=IndicatedCombustion(18e5)
    )
    angles, h = np.radians(np.arange(1.5, 720.0, 7.0)), 1e-5
    volumes = [cylinder_volume(a, engine.cylinder) for a in (angles + h, angles - h)]
    pressure = cylinder_pressure(angles, engine, fires=True)
    expected = (pressure - 1e5) * np.subtract(*volumes) / (2 * h)
    found = gas_torque(angles, pressure, engine.cylinder, 1e5)
    assert found == pytest.approx(expected, rel=1e-5, abs=1e-2)


def test_mean_motored_torque_is_zero(vee):
    largest = np.abs(cylinder_torque(np.linspace(0, 6, 500), vee(50.0), True)).max()
    assert abs(engine_figures(vee(50.0)).mean_torque) < 1e-12 * largest


def test_the_crankcase_pushes_without_work(vee):
    engine = vee(50.0, charge=Charge(1e5, 1.4e5, 1.32, 1.32))
    assert engine_figures(engine).mean_torque == pytest.approx(0.0, abs=1e-8)


def test_a_misfire_takes_the_work_of_one_cylinder(vee):
    engine = vee(50.0, combustion=IndicatedCombustion(5e5))
    lame = dataclasses.replace(engine, misfiring=(3,))
    means = [engine_figures(e).mean_torque for e in (engine, lame)]
    assert means[1] / means[0] == pytest.approx(15 / 16)
    angles = np.linspace(0.0, 4 * math.pi, 400)
    lost = engine_torque(angles, engine) - engine_torque(angles, lame)
    own = angles - engine.firing_angles[3]
    expected = cylinder_torque(own, engine, True) - cylinder_torque(own, engine, False)
    assert lost == pytest.approx(expected, abs=1e-8)

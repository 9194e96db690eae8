import dataclasses
import math

import numpy as np
import pytest

from coupling_design.engine import (
    Charge,
    Cycle,
    IndicatedCombustion,
    PressureTrace,
    engine_figures,
)
from coupling_design.engine.crank import cylinder_volume
from coupling_design.engine.pressure import (
    burnt_fraction,
    cycle_angles,
    cylinder_pressure,
    mean_pressure,
    motored_pressure,
)

FOUR, TWO = Cycle.FOUR_STROKE, Cycle.TWO_STROKE
TURN = 2 * math.pi
FIRED = IndicatedCombustion(18e5)
BOOSTED = Charge(3.5e5, 1e5, 1.35, 1.30)


def test_motored_pressure_by_hand(cylinder, charge):
    # At dead centre 1 bar x 12.5^1.32 = exp(1.32 x 2.525729) = 28.049 bar. A quarter
    # turn on, V / V_c = 1 + 11.5 x 160.226 / 285 = 7.4653, so 28.049 / 7.4653^1.32
    # = 28.049 / exp(1.32 x 2.010262) = 1.9747 bar, and before dead centre the same.
    angles = np.array([0.0, TURN / 4, -TURN / 4, 2 * TURN + TURN / 4])
    found = motored_pressure(angles, cylinder, charge, FOUR)
    assert found == pytest.approx([28.049e5, 1.9747e5, 1.9747e5, 1.9747e5], rel=5e-5)


def test_gas_exchange_is_at_intake_pressure(cylinder, charge):
    angles = np.radians([190.0, 360.0, 500.0])
    assert motored_pressure(angles, cylinder, charge, FOUR) == pytest.approx(1e5)
    assert motored_pressure(angles, cylinder, charge, TWO)[1] > 28e5


def test_wiebe_by_hand():
    # m = 1, half the duration: 1 - exp(-ln(1000) / 4) = 1 - 10^-0.75 = 0.82217;
    # after all of it 1 - 1/1000.
    combustion = IndicatedCombustion(1e5, start=-0.1, duration=1.0, shape=1.0)
    found = burnt_fraction(np.array([-0.2, -0.1, 0.4, 0.9, 4.0]), combustion, FOUR)
    assert found == pytest.approx([0.0, 0.0, 0.82217, 0.999, 0.0], abs=5e-6)


@pytest.mark.parametrize("cycle", Cycle)
@pytest.mark.parametrize("pressure", [6e5, 18e5, 25e5])
def test_work_of_a_cycle_is_mean_pressure_times_displacement(vee, cycle, pressure):
    combustion = IndicatedCombustion(pressure)
    engine = vee(50.0, combustion=combustion, charge=BOOSTED, cycle=cycle)
    angles = cycle_angles(cycle)
    closed = np.append(angles, cycle.angle)
    work = np.trapezoid(
        cylinder_pressure(closed, engine, fires=True),
        cylinder_volume(closed, engine.cylinder),
    )
    wanted = pressure * engine.cylinder.displacement
    assert work == pytest.approx(wanted, rel=1e-5)
    torque = engine_figures(engine).mean_torque
    assert torque * cycle.angle == pytest.approx(16 * wanted, rel=1e-9)


def test_motored_work_of_unlike_exponents_in_closed_form(vee):
    # Polytropic work between the volumes, each exponent its own:
    # -p0 V1 (r^(n-1) - 1) / (n - 1) + p2 Vc (1 - r^(1-m)) / (m - 1), V1 = r Vc.
    n, m, r = 1.32, 1.38, 12.5
    engine = vee(50.0, charge=Charge(1e5, 1e5, n, m))
    V_c = engine.cylinder.clearance_volume
    compression = -1e5 * r * V_c * (r ** (n - 1) - 1) / (n - 1)
    expansion = 1e5 * r**n * V_c * (1 - r ** (1 - m)) / (m - 1)
    expected = (compression + expansion) / engine.cylinder.displacement
    figures = engine_figures(engine)
    assert figures.indicated_mean_pressure == pytest.approx(expected, rel=1e-4)
    assert figures.mean_torque < 0


def test_peak_pressure_of_a_turbocharged_diesel_is_plausible(vee):
    # Medium-speed engines of 18 to 20 bar indicated have 100 to 180 bar.
    engine = vee(50.0, charge=BOOSTED, combustion=FIRED)
    assert 100e5 < engine_figures(engine).peak_pressure < 180e5


def test_a_trace_of_the_synthetic_pressure_gives_it_back(vee):
    fired = vee(50.0, charge=BOOSTED, combustion=FIRED)
    angles = np.radians(np.arange(-360.0, 360.0))
    pressures = cylinder_pressure(angles, fired, fires=True)
    trace = PressureTrace(tuple(angles), tuple(pressures))
    traced = dataclasses.replace(fired, combustion=trace)
    finer = cycle_angles(FOUR)
    found = cylinder_pressure(finer, traced, fires=True)
    assert found[::10] == pytest.approx(cylinder_pressure(finer[::10], fired, True))
    assert mean_pressure(found, fired) == pytest.approx(18e5, rel=2e-3)
    motored = cylinder_pressure(finer, traced, fires=False)
    expected = motored_pressure(finer, fired.cylinder, BOOSTED, FOUR)
    assert motored == pytest.approx(expected)

"""Resistance of the fixtures at 40 rad/s: engine 40 + 30, generator 20 + 10 [N m]."""

import dataclasses

import casadi as ca
import numpy as np
import pytest

from coupling_design.events.shutdown import RunDown, fuel_torque
from coupling_design.line.motion import motion
from coupling_design.line.parameters import (
    FuelCutStart,
    QuasiSteadyStart,
    SettledStart,
    Shutdown,
)

SPEED = 40.0


def shutdown(start, **changes):
    return Shutdown(SPEED, 1.0, 1e-3, start, **changes)


def numbers(expression):
    return np.asarray(ca.DM(expression)).ravel()


@pytest.mark.parametrize("over", [0.0, 0.25])
def test_fuel_balances_all_resistances(keyed, over):
    assert fuel_torque(keyed, shutdown(FuelCutStart(over))) == pytest.approx(100.0)


@pytest.mark.parametrize("start", [SettledStart(), QuasiSteadyStart()])
def test_without_fuel_there_is_none(keyed, start):
    assert fuel_torque(keyed, shutdown(start)) == 0.0


@pytest.mark.parametrize(
    ("time", "torque"), [(0.0, 100.0), (0.05, 75.0), (0.2, 0.0), (0.3, 0.0)]
)
def test_fuel_goes_evenly(keyed, time, torque):
    """100 N m over 0.2 s; an engine of 10 kg m^2 feels a tenth of what is left."""
    cut = shutdown(FuelCutStart(0.2))
    state = np.array([[0.01], [0.002], [0.0], [SPEED], [SPEED], [SPEED], [time]])
    rate = np.asarray(RunDown(keyed, cut).motion(state).state_rate, float).ravel()
    without = np.asarray(motion(keyed, state[:6]).state_rate, float).ravel()

    assert rate[6] == 1.0
    assert rate[3] - without[3] == pytest.approx(torque / 10.0)
    assert np.delete(rate[:6] - without, 3) == pytest.approx(0.0, abs=1e-12)


def test_only_a_fuel_cut_that_takes_time_has_a_clock(tight):
    lengths = {
        start: len(RunDown(tight, shutdown(start)).state_names)
        for start in (SettledStart(), FuelCutStart(0.0), FuelCutStart(0.1))
    }
    assert list(lengths.values()) == [4, 4, 5]
    clock = numbers(RunDown(tight, shutdown(FuelCutStart(0.1))).start())
    assert len(clock) == 5
    assert clock[-1] == 0.0


def test_the_crank_angle_turns_all_of_an_even_start(keyed):
    at_zero = numbers(RunDown(keyed, shutdown(QuasiSteadyStart())).start())
    turned = numbers(
        RunDown(keyed, shutdown(QuasiSteadyStart(), crank_angle=0.5)).start()
    )
    assert turned - at_zero == pytest.approx([0.5] * 3 + [0.0] * 3, abs=1e-12)


def test_at_idle_the_line_carries_what_the_generator_takes(tight):
    """T_d = 30 N m at 40 rad/s over 1e5 N m/rad; nothing slows down."""
    quiet = dataclasses.replace(tight, excitation=())
    start = numbers(RunDown(quiet, shutdown(FuelCutStart(0.0))).start())
    assert start == pytest.approx([30.0 / 1e5, 0.0, SPEED, SPEED], rel=1e-9)

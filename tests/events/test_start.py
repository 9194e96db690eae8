import dataclasses

import casadi as ca
import numpy as np
import pytest

from coupling_design.events.held_line import HeldLine
from coupling_design.events.periodic_orbit import PeriodicOrbit
from coupling_design.events.settled_state import period_of, settled_state
from coupling_design.events.shutdown import RunDown
from coupling_design.events.start import StartingStates, initial_state
from coupling_design.line.parameters import (
    FuelCutStart,
    QuasiSteadyStart,
    SettledStart,
    Shutdown,
)

SPEED = 40.0


SETTLED = SettledStart()


def shutdown(start=SETTLED, **changes):
    return Shutdown(SPEED, 1.0, 1e-3, start, **changes)


def varied(line, start):
    """Return what finds the starts of a line at (stiffness, crank angle)."""
    p = ca.SX.sym("p", 2)
    coupling = dataclasses.replace(line.coupling, torsional_stiffness=p[0])
    stop = shutdown(start, crank_angle=p[1])
    return StartingStates(
        dataclasses.replace(line, coupling=coupling), stop, p, 1, SPEED
    )


@pytest.mark.parametrize("start", [SettledStart(), QuasiSteadyStart()])
def test_a_state_of_numbers_is_that_of_symbols(tight, start):
    found = varied(tight, start)(np.array([[1e5], [0.3]]), 1)
    alone = initial_state(tight, shutdown(start, crank_angle=0.3))
    assert found.states == pytest.approx(alone, rel=1e-14)


def test_columns_keep_their_order(tight):
    starting = varied(tight, SettledStart())
    columns = np.array([[1e5, 1e5, 2e5, 2e5], [0.0, 1.5, 0.0, 1.5]])
    found = starting(columns, 2)
    single = [starting(column[:, np.newaxis], 1).states for column in columns.T]
    assert found.states == pytest.approx(np.hstack(single), rel=1e-14)
    assert found.repeats == (True, True)


def test_slopes_are_made_only_where_asked_for(tight):
    starting, column = varied(tight, SettledStart()), np.array([[1e5], [0.0]])
    assert not starting(column, 1).slopes.any()
    assert starting(column, 1, with_slopes=True).slopes.any()


def test_a_slope_by_hand(tight):
    """Twisted by T / k, whose slope is -T / k^2: T = 22 * (-100 / 32) + 30 N m."""
    braked = dataclasses.replace(tight, excitation=())
    slopes = varied(braked, QuasiSteadyStart())(
        np.array([[1e5], [0.0]]), 1, with_slopes=True
    ).slopes
    torque = 22 * (-100 / 32) + 30
    assert slopes[0, :, 0] == pytest.approx([-torque / 1e10, 0, 0, 0], rel=1e-9)


def test_an_even_start_never_asks_for_an_orbit(keyed):
    start = QuasiSteadyStart()
    found = varied(keyed, start)(np.array([[1e5], [0.0]]), 1)
    closed = RunDown(keyed, shutdown(start)).start()
    assert found.states.ravel() == pytest.approx(np.asarray(ca.DM(closed)).ravel())


def test_a_gap_that_opens_changes_the_start(keyed):
    """The order passes the key as more than the mean torque: see test_lift_off."""
    settled = initial_state(keyed, shutdown()).ravel()
    linear = np.asarray(ca.DM(settled_state(keyed, SPEED))).ravel()
    assert np.isfinite(settled).all()
    assert np.abs(settled - linear).max() > 1e-4


def test_a_clock_starts_at_zero_whether_the_gap_opens_or_not(keyed, tight):
    for line in (keyed, tight):
        assert initial_state(line, shutdown(FuelCutStart(0.1)))[-1] == 0.0


def orbit_of(line, n_angles):
    held = HeldLine(line, shutdown(), ca.SX.sym("none", 0), 0)
    orbit = PeriodicOrbit(held, period_of(line.excitation), SPEED)
    return orbit.settle(np.empty(0), n_angles, with_slopes=False)


@pytest.mark.parametrize("n_angles", [1, 3, 8, 12])
def test_an_orbit_is_the_linear_response_where_the_gap_is_closed(closed, n_angles):
    found = orbit_of(closed, n_angles)
    period = period_of(closed.excitation)
    linear = [
        np.asarray(ca.DM(settled_state(closed, SPEED, period * i / n_angles))).ravel()
        for i in range(n_angles)
    ]
    assert found.repeats
    assert found.states.shape == (6, n_angles)
    # The march's own error: its step of 1 ms is a sixth of the key's period.
    assert pytest.approx(np.stack(linear), abs=2e-4) == found.states.T


def test_an_orbit_without_orders_stands_still(closed):
    """Nothing pushes: what is held at its speed keeps it, turning on."""
    silent = dataclasses.replace(
        closed,
        excitation=(dataclasses.replace(closed.excitation[0], amplitude=0.0),),
    )
    found = orbit_of(silent, 4)
    assert found.states[3:] == pytest.approx(SPEED, abs=1e-9)
    turned = found.states[:3] - found.states[:3, :1]
    assert turned == pytest.approx(np.tile(np.pi / 4 * np.arange(4), (3, 1)), abs=1e-9)

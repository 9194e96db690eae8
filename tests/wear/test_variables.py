import dataclasses

import casadi as ca
import numpy as np
import pytest

from coupling_design.wear.variables import (
    CRANK_ANGLE,
    FIRST_AMPLITUDE,
    GRAVITY_ANGLE,
    INITIAL_SPEED,
    make_variables,
)

POINTS = [(2e3, 1e-4), (3e3, 5e-5)]
CHANCES = np.array([[0.0, 0.5, 1.0], [0.1, 0.2, 0.3]])


@pytest.fixture
def keyed(quick, candidate):
    return make_variables(quick, candidate(quick, "rubber", "key"))


@pytest.fixture
def tight(quick, candidate):
    return make_variables(quick, candidate(quick, "rubber", "tight_fit"))


def test_a_tight_fit_has_no_contact_stiffness(keyed, tight):
    assert tight.contact_stiffness is None
    assert keyed.contact_stiffness == keyed.symbols.numel() - 1
    assert keyed.symbols.numel() == tight.symbols.numel() + 1


def test_nominal_values_are_the_cases(quick, keyed):
    shutdown = quick.shutdown
    assert keyed.nominal == (
        shutdown.crank_angle,
        shutdown.gravity_angle,
        shutdown.initial_speed,
        60.0,
        20.0,
        1e6,
    )


def test_a_column_for_each_point_and_chance_points_slowest(keyed):
    columns = keyed.columns(POINTS, CHANCES)
    assert columns.shape == (keyed.symbols.numel(), 6)
    assert columns[0].tolist() == [2e3] * 3 + [3e3] * 3
    assert columns[1].tolist() == [1e-4] * 3 + [5e-5] * 3
    assert columns[CRANK_ANGLE].tolist() == [0.0, 0.5, 1.0] * 2
    assert columns[GRAVITY_ANGLE].tolist() == [0.1, 0.2, 0.3] * 2
    assert columns[INITIAL_SPEED:].tolist() == [
        [value] * 6 for value in keyed.nominal[2:]
    ]


def test_the_driveline_of_numbers_is_that_of_the_symbols(quick, keyed):
    values = keyed.columns(POINTS, CHANCES)[:, -1]
    values[FIRST_AMPLITUDE] = 66.0
    values[keyed.contact_stiffness] = 2e6
    line = keyed.driveline_at(values)

    assert line.coupling.torsional_stiffness == 3e3
    assert line.connection.gap == 5e-5
    assert line.connection.contact_stiffness == 2e6
    assert [order.amplitude for order in line.excitation] == [66.0, 20.0]
    kept = dataclasses.replace(
        line,
        coupling=quick.driveline.coupling,
        connection=quick.driveline.connection,
        excitation=quick.driveline.excitation,
    )
    assert kept == quick.driveline


def test_symbols_stand_where_their_values_do(keyed):
    """The vector's own function gives each entry back."""
    line, shutdown = keyed.driveline, keyed.shutdown
    entries = ca.vertcat(
        line.coupling.torsional_stiffness,
        line.connection.gap,
        shutdown.crank_angle,
        shutdown.gravity_angle,
        shutdown.initial_speed,
        *(order.amplitude for order in line.excitation),
        line.connection.contact_stiffness,
    )
    numbers = np.arange(1.0, keyed.symbols.numel() + 1)
    back = ca.Function("back", [keyed.symbols], [entries])(numbers)
    assert np.asarray(back).ravel().tolist() == numbers.tolist()

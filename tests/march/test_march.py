import casadi as ca
import numpy as np
import pytest
from scipy.linalg import expm

from coupling_design.march.marcher import virtual_machine_marcher
from coupling_design.march.record import record
from coupling_design.march.sensitivities import (
    join_sensitivities,
    with_sensitivities,
)
from coupling_design.march.tower import march

A = np.array([[-0.1, 2.0, 0.0], [-2.0, -0.1, 0.5], [0.0, -0.5, -0.3]])
START = np.array([1.0, -0.5, 0.25])


def marched(function, state, parameters=0.0):
    return np.asarray(function(state, parameters), dtype=float).ravel()


def one_up():
    """Return a step that counts: exact whatever the number of steps."""
    state, parameters = ca.SX.sym("x"), ca.SX.sym("p")
    return ca.Function("count", [state, parameters], [state + parameters])


@pytest.mark.parametrize("n_steps", [1, 2, 9, 10, 11, 99, 100, 101, 1000, 12345])
def test_any_number_of_steps_is_taken_exactly(n_steps):
    assert marched(march(one_up(), n_steps), 0, 1) == [n_steps]


@pytest.mark.parametrize("n_steps", [0, -1])
def test_no_steps_are_no_march(n_steps):
    with pytest.raises(ValueError, match="at least one step"):
        march(one_up(), n_steps)


def test_error_falls_with_the_fourth_power_of_the_step(linear_step):
    exact = expm(A) @ START
    counts = np.array([20, 40, 80, 160])
    errors = [
        np.linalg.norm(marched(march(linear_step(A, 1 / n), n), START) - exact)
        for n in counts
    ]
    order = -np.polyfit(np.log(counts), np.log(errors), 1)[0]
    assert order == pytest.approx(4, abs=0.1)


def test_march_keeps_the_names_of_its_ports(linear_step):
    function = march(linear_step(A, 0.1), 25)
    assert (function.name_in(), function.name_out()) == (
        ["state", "parameters"],
        ["state_next"],
    )


def test_sensitivities_of_a_linear_system_are_the_integral_of_its_response(linear_step):
    # x' = A x + B p: dx/dp = A^-1 (expm(A t) - 1) B.
    B = np.array([[1.0, 0.0], [0.0, 2.0], [1.0, 1.0]])
    n = 400
    step = with_sensitivities(linear_step(A, 1 / n, B))
    start = join_sensitivities(ca.DM(START), ca.DM.zeros(3, 2))
    end = marched(march(step, n), start, [0.3, -0.2])
    expected = np.linalg.solve(A, expm(A) - np.eye(3)) @ B
    np.testing.assert_allclose(end[3:].reshape(2, 3).T, expected, rtol=1e-9)


def test_start_may_depend_on_the_parameters(linear_step):
    n = 400
    step = with_sensitivities(linear_step(A, 1 / n))
    direction = np.array([0.1, 0.2, -0.4])
    start = join_sensitivities(ca.DM(START), ca.DM(direction))
    end = marched(march(step, n), start)
    np.testing.assert_allclose(end[3:], expm(A) @ direction, rtol=1e-9)


def test_sensitivities_agree_with_finite_differences(pendulum_step):
    n_steps, point, start = 700, np.array([30.0, 0.2]), np.array([0.5, 0.0, 0.0, 0.0])
    value = march(pendulum_step, n_steps)
    joint = march(with_sensitivities(pendulum_step), n_steps)
    end = marched(joint, join_sensitivities(ca.DM(start), ca.DM.zeros(4, 2)), point)
    np.testing.assert_allclose(end[:4], marched(value, start, point), rtol=1e-12)
    for i, change in enumerate([1e-4, 1e-6]):
        there, here = point.copy(), point.copy()
        there[i], here[i] = point[i] + change, point[i] - change
        difference = (marched(value, start, there) - marched(value, start, here)) / (
            2 * change
        )
        np.testing.assert_allclose(
            end[4 + 4 * i : 8 + 4 * i], difference, rtol=2e-5, atol=1e-7
        )


@pytest.mark.parametrize("n_steps", [1, 10, 999, 1000, 1037])
def test_record_has_the_state_before_each_step(n_steps):
    states = record(one_up(), n_steps, np.array([[5.0]]), np.array([[2.0]]))
    np.testing.assert_array_equal(states, [5 + 2 * np.arange(n_steps)])


def test_virtual_machine_takes_columns_in_their_order():
    marcher = virtual_machine_marcher(one_up(), 12)
    states, parameters = np.array([[1.0, 2.0, 3.0]]), np.array([[0.5, 0.25, -1.0]])
    np.testing.assert_array_equal(marcher(states, parameters), states + 12 * parameters)

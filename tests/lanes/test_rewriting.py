"""What is rewritten on the way to machine code computes the same, with less."""

import casadi as ca
import numpy as np
import pytest

from coupling_design.lanes.graph.instructions import read_step
from coupling_design.lanes.march import compile_march
from coupling_design.lanes.rewriting.contacts import find_contacts
from coupling_design.lanes.rewriting.harmonics import share_harmonics
from coupling_design.lanes.rewriting.monomials import share_factors
from coupling_design.lanes.rewriting.products import gather_products
from coupling_design.lanes.rewriting.sums import gather_sums
from coupling_design.march.runge_kutta import rk4_step
from coupling_design.march.tower import march

RANDOM = np.random.default_rng(30)
SHARP = 1e3


def function(n, m, next_state):
    """Return the step of a function (state, parameters) -> list of entries."""
    state, parameters = ca.SX.sym("state", n), ca.SX.sym("parameters", m)
    entries = next_state(ca.vertsplit(state), ca.vertsplit(parameters))
    return ca.Function("step", [state, parameters], [ca.vertcat(*entries)])


def by_virtual_machine(step, n_steps, states, parameters):
    marched = march(step, n_steps)
    columns = zip(states.T, parameters.T, strict=True)
    return np.hstack([np.asarray(marched(*column)) for column in columns])


def kinds(graph, outputs):
    return [graph[place].kind for place in graph.needed(outputs)]


def turning(orders, time_step):
    """Return RK4 of an angle driven by harmonics of itself, with phases."""

    def rate(y):
        angle, speed = ca.vertsplit(y)
        torque = sum(
            ca.sin(order * angle + 0.1 * i) + ca.cos(order * angle)
            for i, order in enumerate(orders)
        )
        return ca.vertcat(speed, torque - 0.1 * speed)

    state, parameters = ca.SX.sym("state", 2), ca.SX.sym("p")
    return ca.Function("s", [state, parameters], [rk4_step(rate, state, time_step)])


ORDERS = [(4.0, 8.0), (0.5, 1.0, 1.5, 2.5, 12.0), (4.0, 6.0), (3.0,), (1.0, np.pi)]


@pytest.mark.usefixtures("compiler")
@pytest.mark.parametrize("orders", ORDERS)
@pytest.mark.parametrize("time_step", [1e-4, 3e-3, 0.3])
def test_harmonics_of_a_turning_angle(orders, time_step):
    """Turns of a step from far within the short series to far beyond it."""
    step = turning(orders, time_step)
    states = np.vstack([RANDOM.uniform(-50, 50, 9), RANDOM.uniform(-80, 80, 9)])
    none = np.zeros((1, 9))
    ends = compile_march(step, 20)(states, none)
    expected = by_virtual_machine(step, 20, states, none)
    np.testing.assert_allclose(ends, expected, rtol=1e-12, atol=1e-12)


@pytest.mark.usefixtures("compiler")
def test_lanes_with_large_turns_leave_those_with_small_ones_alone():
    step = turning((4.0, 8.0), 1e-3)
    states = np.vstack([np.full(8, 0.3), np.linspace(1, 200, 8)])
    ends = compile_march(step, 5)(states, np.zeros((1, 8)))
    for i in range(8):
        alone = compile_march(step, 5)(states[:, i : i + 1], np.zeros((1, 1)))
        np.testing.assert_array_equal(alone[:, 0], ends[:, i])


@pytest.mark.parametrize("orders", ORDERS[:3])
def test_one_sine_and_cosine_serve_all_orders_and_stages(orders):
    graph, outputs = share_harmonics(*read_step(turning(orders, 1e-3)))
    found = kinds(graph, outputs)
    assert found.count("wave") == 1
    assert found.count("turned") == 3
    assert not {"sin", "cos"} & set(found)


def test_orders_without_a_common_divisor_stay():
    graph, outputs = share_harmonics(*read_step(turning((1.0, np.pi), 1e-3)))
    assert "wave" not in kinds(graph, outputs)


def contact(entries, parameters):
    """Return an oscillator between smoothed stops, as the key's contact is written."""
    (x, v), (half_gap,) = entries, parameters
    pressed = (
        x
        + (
            (x - half_gap) * ca.tanh(SHARP * (x - half_gap))
            - (x + half_gap) * ca.tanh(SHARP * (x + half_gap))
        )
        / 2
    )
    return [x + 1e-3 * v, v - 1e-3 * (50 * pressed + 0.2 * v)]


@pytest.mark.usefixtures("compiler")
@pytest.mark.parametrize("half_gap", [0.0, 1e-4, 5e-3, 0.022, 0.1])
def test_contacts_with_gaps_from_none_to_wide(half_gap):
    step = function(2, 1, contact)
    states = np.vstack([RANDOM.uniform(-0.15, 0.15, 9), RANDOM.uniform(-1, 1, 9)])
    gaps = np.full((1, 9), half_gap)
    ends = compile_march(step, 400)(states, gaps)
    expected = by_virtual_machine(step, 400, states, gaps)
    np.testing.assert_allclose(ends, expected, rtol=1e-11, atol=1e-13)


@pytest.mark.usefixtures("compiler")
@pytest.mark.parametrize("with_derivatives", [False, True])
def test_a_contact_is_the_same_beside_narrower_and_wider_gaps(with_derivatives):
    step = function(2, 1, contact)
    if with_derivatives:
        step = sensitive(step)
    n = step.size1_in(0)
    gaps = np.array([[0.0, 1e-4, 5e-3, 0.0219, 0.0221, 0.05, 0.1, 0.2]])
    states = np.zeros((n, 8))
    states[0], states[1] = np.linspace(-0.1, 0.1, 8), 0.3
    states[2:] = 0.1
    ends = compile_march(step, 300)(states, gaps)
    for i in range(8):
        alone = compile_march(step, 300)(states[:, i : i + 1], gaps[:, i : i + 1])
        np.testing.assert_array_equal(alone[:, 0], ends[:, i])


def sensitive(step):
    """Return the step with the derivative to its parameter, tangents used twice."""
    state, moved, p = ca.SX.sym("x", 2), ca.SX.sym("dx", 2), ca.SX.sym("p")
    after = step(state, p)
    change = ca.jtimes(after, ca.vertcat(state, p), ca.vertcat(moved, 1))
    both = ca.vertcat(after, change)
    return ca.Function("joint", [ca.vertcat(state, moved), p], [ca.cse(both)])


@pytest.mark.usefixtures("compiler")
@pytest.mark.parametrize("half_gap", [0.0, 5e-3, 0.1])
def test_derivatives_of_contacts(half_gap):
    step = sensitive(function(2, 1, contact))
    states = np.vstack([RANDOM.uniform(-0.15, 0.15, (2, 9)), np.zeros((2, 9))])
    gaps = np.full((1, 9), half_gap)
    ends = compile_march(step, 200)(states, gaps)
    expected = by_virtual_machine(step, 200, states, gaps)
    np.testing.assert_allclose(ends, expected, rtol=1e-9, atol=1e-10)


@pytest.mark.usefixtures("compiler")
def test_a_deflection_that_is_no_number_stays_none():
    step = function(2, 1, contact)
    states = np.array([[np.nan, 0.1], [0.0, 0.0]])
    ends = compile_march(step, 3)(states, np.full((1, 2), 0.05))
    assert np.isnan(ends[0, 0])
    assert np.isfinite(ends[:, 1]).all()


def test_a_contact_is_one_operation():
    graph, outputs = find_contacts(*read_step(function(2, 1, contact)))
    found = kinds(graph, outputs)
    assert found.count("pressed") == 1
    assert "tanh" not in found


def test_a_contact_with_derivatives_keeps_its_tangents():
    graph, outputs = read_step(sensitive(function(2, 1, contact)))
    found = kinds(*find_contacts(*gather_products(graph, outputs)))
    assert "pressed" not in found
    assert found.count("tanh") == 2


def test_constants_of_a_sum_become_one():
    def chained(entries, _):
        x, y = entries
        return [x + 2 * (3 - 0.5 * (4 * x - 6 * y - 8)), y]

    graph, outputs = gather_sums(*read_step(function(2, 1, chained)))
    # x + 2 (3 - 0.5 (4 x - 6 y - 8)) = 14 - 3 x + 6 y
    found = kinds(graph, outputs)
    assert found.count("mul") == 2
    assert found.count("add") == 2
    numbers = {graph[p].number for p in graph.needed(outputs) if not graph[p].args}
    assert {14.0, -3.0, 6.0} <= numbers


def test_what_is_used_twice_is_computed_once():
    def shared(entries, _):
        x, y = entries
        common = x + 3 * y
        return [2 * common + y, 5 * common - x]

    before = kinds(*read_step(function(2, 1, shared)))
    after = kinds(*gather_sums(*read_step(function(2, 1, shared))))
    operations = ("mul", "add", "sub", "neg")
    count, most = (sum(map(k.count, operations)) for k in (after, before))
    assert count <= most


@pytest.mark.usefixtures("compiler")
def test_sums_agree_with_the_virtual_machine():
    def entangled(entries, parameters):
        (x, y, z), (p,) = entries, parameters
        u = 0.3 * x - (y - 0.1) * 0.2 + p * z
        return [0.9 * x - 0.1 * u, y + 0.01 * (u - (z - 2 * x)), z - 0.05 * u * y]

    step = function(3, 1, entangled)
    states, points = RANDOM.uniform(-1, 1, (3, 9)), RANDOM.uniform(-1, 1, (1, 9))
    ends = compile_march(step, 100)(states, points)
    expected = by_virtual_machine(step, 100, states, points)
    np.testing.assert_allclose(ends, expected, rtol=1e-11, atol=1e-13)


def slopes(entries, _):
    """Return two directions through the same slope, each product in its own order."""
    x, a, b = entries
    slope = ca.exp(-x)
    return [x * 0.5, a * (3 * (x * slope)), (slope * (b * 3)) * x]


def test_directions_share_their_slope():
    step = function(3, 1, slopes)
    before = kinds(*read_step(step)).count("mul")
    after = kinds(*share_factors(*read_step(step))).count("mul")
    assert (before, after) == (7, 5)  # 3 x slope once, 0.5 x, and one each


def test_a_product_that_shares_nothing_keeps_its_factors():
    def lonely(entries, _):
        x, y, z = entries
        return [x * y * z * 2, y + 1, z + 1]

    graph, outputs = share_factors(*read_step(function(3, 1, lonely)))
    assert kinds(graph, outputs).count("mul") == 3


@pytest.mark.usefixtures("compiler")
def test_rearranged_products_agree_with_the_virtual_machine():
    step = function(3, 1, slopes)
    states, none = RANDOM.uniform(0.1, 1, (3, 9)), np.zeros((1, 9))
    ends = compile_march(step, 20)(states, none)
    expected = by_virtual_machine(step, 20, states, none)
    np.testing.assert_allclose(ends, expected, rtol=1e-12)

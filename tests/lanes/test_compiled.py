"""Marches as machine code: the same numbers as CasADi's, whatever the batch."""

import casadi as ca
import numpy as np
import pytest
from scipy.linalg import expm

from coupling_design.lanes.compiler import VARIABLE
from coupling_design.lanes.march import (
    CompiledMarch,
    NotCompiled,
    compile_march,
)
from coupling_design.lanes.rewriting.symbols import with_shared_powers
from coupling_design.march.fastest import fastest_marcher
from coupling_design.march.record import record
from coupling_design.march.sensitivities import with_sensitivities
from coupling_design.march.tower import march

RANDOM = np.random.default_rng(4)


def batch(n, joint=False):
    """Return n starts and points of the pendulum."""
    starts = np.vstack([RANDOM.uniform(-1, 1, (2, n)), np.zeros((2, n))])
    points = np.vstack([RANDOM.uniform(5, 50, n), RANDOM.uniform(0.05, 0.5, n)])
    return (np.vstack([starts, np.zeros((8, n))]) if joint else starts), points


def on_virtual_machine(step, n_steps, starts, points):
    function = march(step, n_steps)
    columns = [
        np.asarray(function(start, point), dtype=float).ravel()
        for start, point in zip(starts.T, points.T, strict=True)
    ]
    return np.stack(columns, axis=1)


@pytest.mark.usefixtures("compiler")
def test_linear_system_against_the_matrix_exponential(linear_step):
    A = np.array([[-0.1, 2.0, 0.0], [-2.0, -0.1, 0.5], [0.0, -0.5, -0.3]])
    starts = RANDOM.normal(size=(3, 5))
    errors = [
        np.abs(
            compile_march(linear_step(A, 1 / n), n)(starts, np.zeros((1, 5)))
            - expm(A) @ starts
        ).max()
        for n in (20, 40, 80)
    ]
    np.testing.assert_allclose(np.log2(np.divide(errors[:-1], errors[1:])), 4, atol=0.1)


@pytest.mark.usefixtures("compiler")
@pytest.mark.parametrize("joint", [False, True])
def test_agrees_with_the_virtual_machine(pendulum_step, joint):
    step = with_sensitivities(pendulum_step) if joint else pendulum_step
    starts, points = batch(20, joint)
    ends = compile_march(step, 500)(starts, points)
    expected = on_virtual_machine(step, 500, starts, points)
    np.testing.assert_allclose(ends, expected, rtol=1e-12, atol=1e-13)


def test_sharing_powers_changes_rounding_only(pendulum_step):
    starts, points = batch(10)
    shared = on_virtual_machine(with_shared_powers(pendulum_step), 50, starts, points)
    expected = on_virtual_machine(pendulum_step, 50, starts, points)
    np.testing.assert_allclose(shared, expected, rtol=1e-13, atol=1e-15)


@pytest.mark.usefixtures("compiler")
@pytest.mark.parametrize("joint", [False, True])
def test_same_bits_whatever_batch_place_and_threads(pendulum_step, joint):
    step = with_sensitivities(pendulum_step) if joint else pendulum_step
    starts, points = batch(37, joint)
    compiled = compile_march(step, 300)
    ends = compiled(starts, points)
    for columns in (slice(0, 1), slice(3, 8), slice(36, 37), slice(5, 37)):
        part = compiled(starts[:, columns], points[:, columns])
        np.testing.assert_array_equal(part, ends[:, columns])
    for threads in (1, 2, 7):
        np.testing.assert_array_equal(compiled(starts, points, threads), ends)
    backwards = compiled(starts[:, ::-1], points[:, ::-1])
    np.testing.assert_array_equal(backwards[:, ::-1], ends)


@pytest.mark.parametrize(
    "arguments", ["-DSINGLE_LANE", "-mno-avx512f", "-O1", "-O3", "-mtune=generic"]
)
def test_same_bits_at_any_width_and_optimisation(
    pendulum_step, compiler, monkeypatch, arguments
):
    starts, points = batch(20)
    ends = compile_march(pendulum_step, 300)(starts, points)
    monkeypatch.setenv(VARIABLE, f"{compiler.command[0]} {arguments}")
    other = compile_march(pendulum_step, 300)
    if isinstance(other, NotCompiled):
        pytest.skip(other.reason)
    np.testing.assert_array_equal(other(starts, points), ends)


def test_old_processors_give_nearly_the_same(pendulum_step, compiler, monkeypatch):
    starts, points = batch(20)
    ends = compile_march(pendulum_step, 300)(starts, points)
    monkeypatch.setenv(VARIABLE, f"{compiler.command[0]} -march=x86-64")
    other = compile_march(pendulum_step, 300)
    if isinstance(other, NotCompiled):
        pytest.skip(other.reason)
    np.testing.assert_allclose(other(starts, points), ends, rtol=1e-12, atol=1e-13)


@pytest.mark.usefixtures("compiler")
def test_a_lane_that_diverges_is_noticed_and_leaves_others_alone():
    state, parameters = ca.SX.sym("x", 3), ca.SX.sym("p")
    x, y, peak = ca.vertsplit(state)
    growth = ca.vertcat(x + parameters * x**2, y + ca.sin(x), ca.fmax(peak, x))
    step = ca.Function("step", [state, parameters], [growth])
    starts = np.tile([[1.0], [0.0], [0.0]], (1, 11))
    parameters = np.full((1, 11), -0.1)
    healthy = compile_march(step, 50)(starts, parameters)
    parameters[0, 4] = 1.0
    ends = compile_march(step, 50)(starts, parameters)
    others = np.arange(11) != 4
    np.testing.assert_array_equal(ends[:, others], healthy[:, others])
    assert not np.isfinite(ends[:, 4]).any()


@pytest.mark.usefixtures("compiler")
@pytest.mark.parametrize("n_steps", [1, 31, 32, 33, 300])
def test_record_has_every_step_of_the_march_to_the_last_bit(pendulum_step, n_steps):
    starts, points = batch(3)
    one = starts[:, 1:2], points[:, 1:2]
    history = compile_march(pendulum_step, n_steps).record(*one)
    assert history.shape == (4, n_steps)
    np.testing.assert_array_equal(history[:, :1], one[0])
    before = range(1, n_steps, 7)
    ends = [compile_march(pendulum_step, n)(starts, points)[:, 1] for n in before]
    for n, end in zip(before, ends, strict=True):
        np.testing.assert_array_equal(history[:, n], end)


@pytest.mark.usefixtures("compiler")
def test_record_agrees_with_the_virtual_machine(pendulum_step):
    starts, points = batch(1)
    expected = record(pendulum_step, 1500, starts, points)
    history = compile_march(pendulum_step, 1500).record(starts, points)
    np.testing.assert_allclose(history, expected, rtol=1e-11, atol=1e-12)


@pytest.mark.usefixtures("compiler")
def test_a_start_that_is_no_number_stays_none(pendulum_step):
    starts, points = batch(9)
    starts[1, 8] = np.nan
    ends = compile_march(pendulum_step, 10)(starts, points)
    assert np.isnan(ends[:, 8]).all()
    assert np.isfinite(ends[:, :8]).all()


@pytest.mark.usefixtures("compiler")
def test_entries_that_are_always_zero_are_kept():
    state, parameters = ca.SX.sym("x", 2), ca.SX.sym("p")
    step = ca.Function("s", [state, parameters], [ca.vertcat(ca.SX(1, 1), state[0])])
    ends = compile_march(step, 1)(np.array([[3.0], [4.0]]), np.zeros((1, 1)))
    np.testing.assert_array_equal(ends, [[0.0], [3.0]])


@pytest.mark.usefixtures("compiler")
@pytest.mark.parametrize(
    ("states", "parameters"),
    [((3, 5), (2, 5)), ((4, 5), (1, 5)), ((4, 5), (2, 6)), ((4,), (2,))],
)
def test_wrong_shapes_are_told(pendulum_step, states, parameters):
    compiled = compile_march(pendulum_step, 10)
    with pytest.raises(ValueError, match=r"expected states|as many columns"):
        compiled(np.zeros(states), np.zeros(parameters))


@pytest.mark.usefixtures("compiler")
def test_no_columns_are_no_work(pendulum_step):
    ends = compile_march(pendulum_step, 10)(np.zeros((4, 0)), np.zeros((2, 0)))
    assert ends.shape == (4, 0)


@pytest.mark.usefixtures("compiler")
def test_other_numbers_in_a_step_need_no_compiling(linear_step):
    sources = {
        compile_march(linear_step(np.array([[-a, 0.7]] * 2), 0.01), 5).kernel.source
        for a in (0.3, 0.4)
    }
    assert len(sources) == 1


def test_no_steps_are_no_march(pendulum_step):
    with pytest.raises(ValueError, match="at least one step"):
        compile_march(pendulum_step, 0)


def test_without_a_compiler_the_virtual_machine_does_it(pendulum_step, monkeypatch):
    monkeypatch.setenv(VARIABLE, "none")
    marcher = fastest_marcher(pendulum_step, 20)
    starts, points = batch(3)
    expected = on_virtual_machine(pendulum_step, 20, starts, points)
    np.testing.assert_array_equal(marcher(starts, points), expected)
    assert marcher.engine == (
        "CasADi's virtual machine, 6 to 50 times slower: "
        "COUPLING_DESIGN_COMPILER is none"
    )


@pytest.mark.usefixtures("compiler")
def test_fastest_is_machine_code(pendulum_step):
    marcher = fastest_marcher(pendulum_step, 20)
    assert isinstance(marcher.run, CompiledMarch)
    assert marcher.engine == "machine code"


@pytest.mark.usefixtures("compiler")
def test_an_unknown_operation_is_told():
    state, parameters = ca.SX.sym("x"), ca.SX.sym("p")
    step = ca.Function("step", [state, parameters], [ca.erf(state)])
    assert compile_march(step, 3) == NotCompiled(
        "no machine code for the operation erf"
    )

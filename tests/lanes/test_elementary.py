"""Elementary functions of the machine code, against long double arithmetic."""

import casadi as ca
import numpy as np
import pytest

from coupling_design.lanes.march import compile_march

LONG = np.longdouble
RANDOM = np.random.default_rng(20)
TINY = np.finfo(float).tiny

pytestmark = pytest.mark.skipif(
    np.finfo(LONG).eps > 1e-18, reason="long double is no longer than double here"
)


def both_signs(lowest, highest, n=40_000):
    sizes = 10 ** RANDOM.uniform(np.log10(lowest), np.log10(highest), n)
    return sizes * RANDOM.choice([-1.0, 1.0], n)


# Function, arguments, and the largest error allowed in units in the last place.
CASES = {
    "exp": (ca.exp, np.exp, np.r_[both_signs(1e-20, 708), 0.0, 1.0, 709.7], 1.1),
    "log": (
        ca.log,
        np.log,
        np.r_[10 ** RANDOM.uniform(-307, 308, 40_000), 1 + both_signs(1e-16, 0.5)],
        1.5,
    ),
    "tanh": (
        ca.tanh,
        np.tanh,
        np.r_[both_signs(1e-300, 1e3), both_signs(1e-2, 25)],
        2.5,
    ),
    "sin": (ca.sin, np.sin, np.r_[both_signs(1e-300, 1e4), both_signs(0.1, 1e6)], 2.5),
    "cos": (ca.cos, np.cos, np.r_[both_signs(1e-300, 1e4), both_signs(0.1, 1e6)], 2.5),
    "sqrt": (ca.sqrt, np.sqrt, 10 ** RANDOM.uniform(-307, 308, 40_000), 0.51),
}


def values(function, arguments):
    state, parameters = ca.SX.sym("x"), ca.SX.sym("p", 0)
    step = ca.Function("step", [state, parameters], [function(state)])
    march = compile_march(step, 1)
    return march(arguments[np.newaxis], np.empty((0, arguments.size)))[0]


def error_in_last_places(computed, exact):
    unit = np.spacing(np.abs(exact.astype(float)))
    return np.abs(computed.astype(LONG) - exact) / unit


@pytest.mark.usefixtures("compiler")
@pytest.mark.parametrize("name", CASES)
def test_error_is_a_few_units_in_the_last_place(name):
    function, reference, arguments, allowed = CASES[name]
    exact = reference(arguments.astype(LONG))
    keep = np.abs(exact) >= TINY
    error = error_in_last_places(values(function, arguments), exact)[keep]
    assert error.max() <= allowed


@pytest.mark.usefixtures("compiler")
@pytest.mark.parametrize(
    ("function", "argument", "expected"),
    [
        (ca.exp, np.inf, np.inf),
        (ca.exp, 710, np.inf),
        (ca.exp, -np.inf, 0),
        (ca.exp, -1e9, 0),
        (ca.exp, 0, 1),
        (ca.log, 0, -np.inf),
        (ca.log, np.inf, np.inf),
        (ca.log, -1, np.nan),
        (ca.log, 1, 0),
        (ca.tanh, np.inf, 1),
        (ca.tanh, -np.inf, -1),
        (ca.tanh, 0, 0),
        (ca.sin, 0, 0),
        (ca.cos, 0, 1),
        (ca.sin, np.inf, np.nan),
        (ca.cos, -np.inf, np.nan),
        (ca.sign, 0, 0),
        (ca.sign, -3, -1),
        (ca.fabs, -np.inf, np.inf),
        (lambda x: ca.fmax(x, 1), 0.5, 1),
        (lambda x: ca.fmin(x, 1), 0.5, 0.5),
        (lambda x: ca.fmax(x, 2 * x), -1, -1),
        (lambda x: x**-3, 2, 0.125),
        (lambda x: x**7, -2, -128),
        (lambda x: ca.fabs(x) ** 0.5, 9, 3),
        (lambda x: x**2.5, 0, 0),
        (lambda x: x**2.5, -1, np.nan),
        (lambda x: 3 / x, 0, np.inf),
        (lambda x: ca.if_else(x, 2, 3), 0, 3),
        (lambda x: ca.logic_and(x > 1, x < 3) + ca.logic_or(x > 5, x == 2), 2, 2),
        (lambda x: ca.if_else(x != 2, x, -x), 2, -2),
    ],
)
def test_special_values(function, argument, expected):
    assert values(function, np.array([float(argument)])) == pytest.approx(
        [expected], rel=1e-15, nan_ok=True
    )


@pytest.mark.usefixtures("compiler")
@pytest.mark.parametrize(
    "function",
    [
        *(ca.exp, ca.log, ca.tanh, ca.sin, ca.cos, ca.sqrt, ca.sign, ca.fabs),
        *(lambda x: ca.fmax(x, 1), lambda x: ca.fmin(1, x)),
        lambda x: ca.fmax(x, 2 * x),
    ],
)
def test_not_a_number_stays_one(function):
    assert np.isnan(values(function, np.array([1.0, np.nan]))[1])


@pytest.mark.usefixtures("compiler")
def test_powers_of_moderate_size_lose_little():
    bases = 10 ** RANDOM.uniform(-6, 6, 10_000)
    for exponent in (-9.185, 0.068, 1 / 3, 10 / 3):
        computed = values(lambda x, e=exponent: x**e, bases)
        exact = bases.astype(LONG) ** LONG(exponent)
        allowed = 2 + 2 * np.abs(exponent * np.log(bases))
        assert (error_in_last_places(computed, exact) <= allowed).all()


@pytest.mark.usefixtures("compiler")
def test_power_with_a_moving_exponent():
    computed = values(lambda x: x**x, np.array([2.0, 0.5, -2.0, -3.0, -0.5, 0.0]))
    expected = [4, 0.5**0.5, 0.25, -1 / 27, np.nan, 1]
    np.testing.assert_allclose(computed, expected, rtol=1e-15)

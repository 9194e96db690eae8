"""The order of our march on the driveline, and what halving its step moves.

Sources
-------
[1] Hairer, Norsett, Wanner (1993), Solving Ordinary Differential Equations I, II.1:
    the classical Runge-Kutta method has order 4.
[2] The exact solution of a linear line, exp(A t), by SciPy's matrix exponential.
"""

import dataclasses

import numpy as np
import pytest

from coupling_design.line.parameters import ExcitationOrder
from tests.verification.comparison import Comparison, collect, disagreements
from tests.verification.drivelines import three_masses, two_masses
from tests.verification.integration import dop853, rate_function, rk4

DURATION = 0.01
STEPS = (100, 200, 400, 800)
INERTIAS, STIFFNESSES, DAMPINGS = (177.65, 2.26, 602.60), (5e5, 1e7), (800.0, 100.0)
START = np.array([2e-3, 5e-4, 0.0, 50.0, 50.3, 49.8])


def exact(line, start):
    """Return the state of a line without torques from outside after DURATION, [2]."""
    from scipy.linalg import expm

    n = len(start) // 2
    matrix = np.zeros((2 * n, 2 * n))
    matrix[:n, n:] = np.eye(n)
    matrix[n:, :] = line
    return expm(DURATION * matrix) @ start


def accelerations(inertias, stiffnesses, dampings):
    """Return the accelerations' matrix [-K/J, -C/J] of a chain, written out."""
    (J1, J2, J3), (k, k_g), (c, c_o) = inertias, stiffnesses, dampings
    return np.array(
        [
            [-k / J1, k / J1, 0, -c / J1, c / J1, 0],
            [k / J2, -(k + k_g) / J2, k_g / J2, c / J2, -(c + c_o) / J2, c_o / J2],
            [0, k_g / J3, -k_g / J3, 0, c_o / J3, -c_o / J3],
        ]
    )


def observed(rate, start, expected):
    """Return the errors after each number of steps, and the order they show."""
    errors = [
        float(np.abs(rk4(rate, start, DURATION / n, n) - expected).max()) for n in STEPS
    ]
    return errors, float(-np.polyfit(np.log(STEPS), np.log(errors), 1)[0])


def row(name, source, errors, order):
    return Comparison(
        f"order of the march, {name}",
        source,
        4.0,
        order,
        "-",
        0.3,
        f"{STEPS[0]} to {STEPS[-1]} steps, error {errors[0]:.1e} to {errors[-1]:.1e}",
    )


def order_with_the_gap_closed():
    rate = rate_function(three_masses(INERTIAS, STIFFNESSES, DAMPINGS))
    expected = exact(accelerations(INERTIAS, STIFFNESSES, DAMPINGS), START)
    errors, order = observed(rate, START, expected)
    return [row("free line, gap closed", "order 4, against exp(A t)", errors, order)]


def order_with_a_tight_fit():
    J1, J23, k, c = 177.65, 604.86, 1.9e8, 3000.0
    line = np.array(
        [[-k / J1, k / J1, -c / J1, c / J1], [k / J23, -k / J23, c / J23, -c / J23]]
    )
    start = np.array([2e-4, 0.0, 50.0, 49.9])
    rate = rate_function(two_masses(J1, J23, k, c))
    errors, order = observed(rate, start, exact(line, start))
    return [row("free line, tight fit", "order 4, against exp(A t)", errors, order)]


def order_with_excitation():
    driveline = dataclasses.replace(
        three_masses(INERTIAS, STIFFNESSES, DAMPINGS),
        excitation=(ExcitationOrder(4.0, 2e3, 0.0), ExcitationOrder(8.0, 1e3, 0.5)),
    )
    rate = rate_function(driveline)
    expected = dop853(rate, START, (0.0, DURATION), tolerance=1e-13)[:, -1]
    errors, order = observed(rate, START, expected)
    return [row("driven line, gap closed", "order 4, against DOP853", errors, order)]


GROUPS = (order_with_the_gap_closed, order_with_a_tight_fit, order_with_excitation)


def comparisons():
    """Return what this module compares."""
    return collect(GROUPS)


@pytest.mark.parametrize("group", GROUPS)
def test_agrees_with_its_source(group):
    assert disagreements(group) == []


def test_halving_the_step_divides_the_error_by_sixteen():
    rate = rate_function(three_masses(INERTIAS, STIFFNESSES, DAMPINGS))
    expected = exact(accelerations(INERTIAS, STIFFNESSES, DAMPINGS), START)
    errors, _ = observed(rate, START, expected)

    ratios = np.divide(errors[:-1], errors[1:])
    assert ratios == pytest.approx(16, rel=0.1)


def test_halving_the_step_shows_the_error_without_a_reference():
    """Richardson: the difference of two steps is 15/16 of the coarser one's error."""
    rate = rate_function(three_masses(INERTIAS, STIFFNESSES, DAMPINGS))
    expected = exact(accelerations(INERTIAS, STIFFNESSES, DAMPINGS), START)
    coarse, fine = (rk4(rate, START, DURATION / n, n) for n in STEPS[1:3])

    difference = np.abs(coarse - fine).max()
    error = np.abs(coarse - expected).max()
    assert difference == pytest.approx(15 / 16 * error, rel=0.02)

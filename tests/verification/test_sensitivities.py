"""Derivatives of a rollout to stiffness and gap beside finite differences.

Sources
-------
[1] Central differences of the same rollout, extrapolated from two steps (Richardson).
[2] For a peak, the one-sided difference that is nearer: as a maximum over steps it
    has a kink wherever another step becomes the largest.

Either is as precise as 1e-6 of itself, what its two steps differ by, and rounding over
the step; rounding is what the totals move by when the crank is turned by 1e-13 rad.
With the gap open the window is short: every impact multiplies a derivative's growth.
"""

import dataclasses
import functools

import numpy as np
import pytest

from coupling_design.line.contact import half_gap_angle
from coupling_design.line.parameters import Shutdown
from coupling_design.wear.evaluator import Evaluator
from coupling_design.wear.quantities import TOTALS
from tests.verification.comparison import Comparison, collect, disagreements
from tests.verification.drivelines import (
    evaluator,
    high_stiffness_candidate,
    present_candidate,
    shipped_case,
)
from tests.verification.integration import dop853, rate_function
from tests.verification.resonance import evenly, impacts, resonance, start_of

RELATIVE = 1e-6  # derivatives with the gap closed, as the project promises them
VARIABLES = ("stiffness", "gap")
UNITS = ("N m/rad", "m")
OFFSETS = tuple(i * 1e-13 for i in (-3, -2, -1, 1, 2, 3))  # of the crank [rad]
N_DAMAGES = 2  # TOTALS begin with them; the others are peaks


def totals(of, point, start_offset=0.0):
    """Return TOTALS of a rollout, without derivatives."""
    performance = of.performance(*point, start_offset=start_offset)
    return np.array(
        [
            *performance.damages,
            performance.peak_transmission_force,
            *performance.peak_combined_load,
        ]
    )


def rounding(of, point):
    """Return how much of TOTALS is rounding."""
    here = totals(of, point)
    moved = [np.abs(totals(of, point, offset) - here) for offset in OFFSETS]
    return np.max(moved, axis=0)


def differences(of, point, variable, step):
    """Return TOTALS' central, forward and backward differences and their doubts."""

    def at(steps):
        moved = list(point)
        moved[variable] += steps * step
        return totals(of, moved)

    here = totals(of, point)
    full, half = [at(-1.0), at(1.0)], [at(-0.5), at(0.5)]
    central = [(full[1] - full[0]) / (2 * step), (half[1] - half[0]) / step]
    # Rounding e of each total comes to at most 3 e / step here, 10 e / step below.
    found = [(*_extrapolated(*central, 3), 3)]
    for side, sign in ((1, 1.0), (0, -1.0)):
        steep = [
            sign * (full[side] - here) / step,
            sign * (half[side] - here) / step * 2,
        ]
        found.append((*_extrapolated(*steep, 1), 10))
    return found


def _extrapolated(coarse, fine, divisor):
    """Return Richardson's extrapolation and what it moves the finer value by."""
    return fine + (fine - coarse) / divisor, np.abs(fine - coarse) / divisor


def compared(where, of, point, steps):
    """Return the derivatives of all totals to the variables that have a step."""
    values, jacobian = of.totals_and_jacobian(*point)
    noise = rounding(of, point)
    assert np.abs(values - totals(of, point)) == pytest.approx(0, abs=noise.max() * 1e3)
    return [
        _row(where, differences(of, point, variable, step), jacobian, noise / step, at)
        for variable, step in enumerate(steps)
        if step is not None
        for at in [(total, variable) for total in range(len(TOTALS))]
    ]


def _row(where, by_differences, jacobian, noise, at):
    total, variable = at
    ours = jacobian[at]
    candidates = [
        (value[total], doubt[total] + weight * noise[total])
        for value, doubt, weight in by_differences
    ]
    is_peak = total >= N_DAMAGES
    if not is_peak:
        candidates = candidates[:1]  # smooth, so central
    expected, doubt = min(candidates, key=lambda pair: abs(pair[0] - ours))
    return Comparison(
        f"derivative of {TOTALS[total].replace('_', ' ')} to the "
        f"{VARIABLES[variable]}, {where}",
        "finite differences of the rollout",
        float(expected),
        float(ours),
        f"{'N' if is_peak else '1'} per {UNITS[variable]}",
        float(RELATIVE * abs(expected) + doubt),
        f"differs by {abs(ours / expected - 1):.1e} of it",
    )


def gap_closed_over_the_whole_run_down():
    """Keyed with its gap closed, at twice the case's step."""
    case = shipped_case()
    of = evaluator(present_candidate(case), time_step=2 * case.shutdown.time_step)
    stiffness = case.driveline.coupling.torsional_stiffness
    steps = (3e-4 * stiffness, 1e-4 * case.driveline.connection.gap)
    where = "gap closed, whole run-down, step 2e-4 s"
    return compared(where, of, (stiffness, 0.0), steps)


def tight_fit_over_the_whole_run_down():
    """The high-stiffness coupling, at five times the case's step."""
    case = shipped_case()
    of = evaluator(
        high_stiffness_candidate(case), time_step=5 * case.shutdown.time_step
    )
    where = "high-stiffness coupling, tight fit, whole run-down, step 5e-4 s"
    return compared(where, of, (193e6, 0.0), (193e3, None))


@functools.cache
def rattling_case():
    """Return the case driven so hard that its key rattles from the start."""
    case = shipped_case()
    orders = tuple(
        dataclasses.replace(order, amplitude=3 * order.amplitude)
        for order in case.driveline.excitation
    )
    return dataclasses.replace(
        case,
        driveline=dataclasses.replace(case.driveline, excitation=orders),
        shutdown=evenly(Shutdown(resonance().speed, 0.2, case.shutdown.time_step)),
    )


@functools.cache
def crossings_in_the_window():
    driveline, shutdown = rattling_case().driveline, rattling_case().shutdown
    times = np.arange(0.0, shutdown.duration, shutdown.time_step)
    start = start_of(driveline, shutdown.initial_speed)
    states = dop853(rate_function(driveline), start, times)
    half_gap = half_gap_angle(driveline.connection)
    return impacts(states[1] - states[2], half_gap)[0]


def gap_open_over_a_short_window():
    """Keyed as built, from the speed of resonance, with three times the excitation."""
    case = rattling_case()
    of = Evaluator(case, present_candidate(case))
    key = case.driveline.connection
    point = (case.driveline.coupling.torsional_stiffness, key.gap)
    where = (
        f"present gap, {case.shutdown.duration:g} s with "
        f"{crossings_in_the_window()} crossings of it"
    )
    return compared(where, of, point, (1e-4 * point[0], 4e-4 * point[1]))


GROUPS = (
    gap_closed_over_the_whole_run_down,
    tight_fit_over_the_whole_run_down,
    gap_open_over_a_short_window,
)


def comparisons():
    """Return what this module compares."""
    return collect(GROUPS)


@pytest.mark.parametrize("group", GROUPS)
def test_agrees_with_its_source(group):
    assert disagreements(group) == []


def test_differences_are_precise_enough_to_judge():
    """A tolerance that lets anything pass would prove nothing."""
    for comparison in gap_open_over_a_short_window():
        assert comparison.tolerance < 0.02 * abs(comparison.published)


def test_the_key_crosses_its_gap_in_the_window():
    assert crossings_in_the_window() >= 2

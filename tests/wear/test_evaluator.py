import re

import numpy as np
import pytest

from coupling_design.errors import SimulationError
from coupling_design.events.recording import simulate
from coupling_design.line.modes import modes
from coupling_design.parts.bearing.damage import miner_damage
from coupling_design.parts.bearing.loads import (
    combined_load,
    rotational_loads,
    static_loads,
)
from coupling_design.wear.evaluator import Evaluator

POINTS = {
    # Rattling amplifies the last digit.
    "key, rattling": ("rubber", "key", 5e3, 0.1e-3, 1e-6),
    "key, closed": ("rubber", "key", 5e3, 0.0, 1e-9),
    "tight fit": ("disc pack", "tight_fit", 5e5, 0.0, 1e-9),
}


def recomputed(evaluator, stiffness, gap):
    """Return damages, peak force and peak loads from a recorded history."""
    case = evaluator.case
    history = simulate(evaluator.driveline(stiffness, gap), case.shutdown)
    rotational = rotational_loads(history.transmission_force, case.shaft)
    loads = [
        combined_load(force, weight, history.generator_angle)
        for force, weight in zip(rotational, static_loads(case.shaft), strict=True)
    ]
    damages = [
        miner_damage(
            load,
            history.generator_speed,
            case.shutdown.time_step,
            bearing,
            case.lubrication,
            case.reliability,
        )
        for load, bearing in zip(loads, case.bearings, strict=True)
    ]
    peak = np.abs(history.transmission_force).max()
    return [*damages, peak, *(load.max() for load in loads)]


@pytest.mark.parametrize("point", POINTS.values(), ids=POINTS)
def test_performance_is_that_of_the_recorded_history(quick, evaluator, point):
    *names, stiffness, gap, tolerance = point
    examined = evaluator(quick, *names)
    found = examined.performance(stiffness, gap)
    totals = [
        *found.damages,
        found.peak_transmission_force,
        *found.peak_combined_load,
    ]
    assert totals == pytest.approx(recomputed(examined, stiffness, gap), tolerance)


@pytest.mark.parametrize("point", POINTS.values(), ids=POINTS)
def test_totals_beside_the_derivatives_are_the_plain_ones(quick, evaluator, point):
    *names, stiffness, gap, tolerance = point
    examined = evaluator(quick, *names)
    found = examined.performance(stiffness, gap)
    totals, _ = examined.totals_and_jacobian(stiffness, gap)
    assert totals[:2] == pytest.approx(found.damages, rel=tolerance)
    assert totals[2] == pytest.approx(found.peak_transmission_force, rel=tolerance)
    assert totals[3:] == pytest.approx(found.peak_combined_load, rel=tolerance)


def central_difference(examined, stiffness, gap, step_stiffness, step_gap):
    def totals(k, phi):
        found = examined.performance(k, phi)
        peaks = found.peak_transmission_force, *found.peak_combined_load
        return np.array([*found.damages, *peaks])

    upper = totals(stiffness + step_stiffness, gap + step_gap)
    lower = totals(stiffness - step_stiffness, gap - step_gap)
    return (upper - lower) / (2 * (step_stiffness + step_gap))


@pytest.mark.parametrize("names", [("rubber", "key"), ("disc pack", "tight_fit")])
def test_gradient_with_the_gap_closed_is_that_of_differences(quick, evaluator, names):
    examined = evaluator(quick, *names)
    stiffness = 1.1 * examined.candidate.coupling_type.stiffness_range[0]
    _, jacobian = examined.totals_and_jacobian(stiffness, 0.0)
    expected = central_difference(examined, stiffness, 0.0, 1e-4 * stiffness, 0.0)
    assert jacobian[:, 0] == pytest.approx(expected, rel=1e-5)


def test_a_tight_fit_does_not_depend_on_the_gap(quick, evaluator):
    _, jacobian = evaluator(quick, "disc pack", "tight_fit").totals_and_jacobian(5e5, 0)
    assert not jacobian[:, 1].any()


@pytest.mark.parametrize("steps", [(0.1, 0.0), (0.0, 1e-7)], ids=["stiffness", "gap"])
def test_gradient_with_the_gap_open_over_a_short_window(
    quick, evaluator, with_shutdown, steps
):
    examined = evaluator(with_shutdown(quick, duration=0.1), "rubber", "key")
    _, jacobian = examined.totals_and_jacobian(5e3, 0.1e-3)
    expected = central_difference(examined, 5e3, 0.1e-3, *steps)
    column = 0 if steps[0] else 1
    assert jacobian[:, column] == pytest.approx(expected, rel=1e-4)


def test_a_question_asked_again_costs_no_rollout(quick, evaluator):
    examined = evaluator(quick, "rubber", "tight_fit")
    first = examined.totals_and_jacobian(5e3, 0.0)
    cost = examined.rollouts
    again = examined.totals_and_jacobian(5e3, 0.0)
    assert examined.rollouts == cost
    assert np.array_equal(first[0], again[0])
    assert np.array_equal(first[1], again[1])


def test_another_point_costs_a_rollout(quick, evaluator):
    examined = evaluator(quick, "rubber", "tight_fit")
    examined.totals_and_jacobian(5e3, 0.0)
    cost = examined.rollouts
    examined.totals_and_jacobian(6e3, 0.0)
    assert examined.rollouts > cost


def test_many_performances_come_in_the_order_of_their_points(quick, evaluator):
    examined = evaluator(quick, "rubber", "key")
    points = [(8e3, 0.0), (1e3, 1e-4), (4e3, 5e-5), (2e3, 2e-4), (6e3, 0.0)]
    together = examined.performances(points)
    assert [(p.torsional_stiffness, p.key_gap) for p in together] == points
    alone = [examined.performance(*point).damage for point in points]
    assert [p.damage for p in together] == pytest.approx(alone, rel=1e-9)


def test_a_start_moved_by_nothing_is_the_same_start(quick, evaluator):
    examined = evaluator(quick, "rubber", "key")
    moved = examined.performance(5e3, 1e-4, start_offset=0.0)
    assert moved.damages == examined.performance(5e3, 1e-4).damages


def test_a_start_moved_twists_the_coupling(quick, evaluator, with_shutdown):
    """At the start the force changes by stiffness x angle / radius, J3's share."""
    one_step = with_shutdown(quick, duration=quick.shutdown.time_step)
    examined = evaluator(one_step, "rubber", "tight_fit")
    rest = examined.performance(5e3, 0.0).peak_transmission_force
    moved = examined.performance(5e3, 0.0, 1e-3).peak_transmission_force
    share = 3.0 / (0.3 + 3.0)
    assert abs(moved - rest) == pytest.approx(5e3 * 1e-3 / 0.05 * share)


def test_a_refinement_of_two_is_half_the_step(quick, evaluator, with_shutdown):
    refined = evaluator(quick, "rubber", "key").refined
    half = with_shutdown(quick, time_step=quick.shutdown.time_step / 2)
    expected = evaluator(half, "rubber", "key").performance(5e3, 1e-4)
    found = refined.performance(5e3, 1e-4)
    assert found.damages == pytest.approx(expected.damages, rel=1e-9)


def test_refinements_multiply(quick, candidate):
    examined = Evaluator(quick, candidate(quick, "rubber", "key"), refinement=3)
    assert examined.refined.refinement == 6


@pytest.mark.parametrize(
    ("names", "stiffness"),
    [(("rubber", "key"), 5e3), (("disc pack", "tight_fit"), 5e5)],
)
def test_natural_frequency_is_the_first_mode_that_moves(
    quick, evaluator, names, stiffness
):
    examined = evaluator(quick, *names)
    expected = modes(examined.driveline(stiffness, 0.0)).angular_frequencies[1]
    assert 2 * np.pi * examined.natural_frequency(stiffness) == pytest.approx(expected)


def test_an_outline_costs_no_rollout(quick, evaluator):
    examined = evaluator(quick, "rubber", "key")
    outline = examined.outline(5e3)
    assert examined.rollouts == 0
    assert outline.damage == 0.0
    assert outline.natural_frequency == examined.natural_frequency(5e3)


@pytest.fixture(scope="session")
def diverging(quick, evaluator, with_shutdown):
    """An evaluator whose step is too large, as no checked case has one."""
    return evaluator(with_shutdown(quick, time_step=5e-3), "disc pack", "key")


@pytest.mark.parametrize("question", ["performance", "totals_and_jacobian"])
def test_a_divergence_names_time_design_and_remedy(diverging, question):
    with pytest.raises(SimulationError) as error:
        getattr(diverging, question)(5e5, 0.1e-3)
    message = str(error.value)
    assert "quick.yaml" in message
    assert "disc pack, key at 500000 N*m/rad and a gap of 0.1 mm" in message
    assert "with a step of 0.005 s. Take a smaller shutdown.time_step" in message


def test_a_divergence_is_dated_when_it_happens(diverging, evaluator, with_shutdown):
    def performance_over(duration):
        case = with_shutdown(diverging.case, duration=duration)
        return evaluator(case, "disc pack", "key").performance(5e5, 0.1e-3)

    with pytest.raises(SimulationError) as error:
        diverging.performance(5e5, 0.1e-3)
    by = float(re.search(r"by ([\d.e-]+) s", str(error.value))[1])
    assert 0 < by < diverging.case.shutdown.duration
    with pytest.raises(SimulationError):
        performance_over(by)

import math

import pytest

from coupling_design.events.recording import simulate
from coupling_design.line.modes import largest_stable_step
from coupling_design.steps.present import (
    evaluate_baseline,
    present_candidate,
    rundown,
)


@pytest.fixture(scope="module")
def baseline(quick, bench):
    return evaluate_baseline(bench(quick))


def test_the_present_candidate_is_the_machines_own(quick):
    present = present_candidate(quick)
    assert present.label == "rubber, key"


def test_a_label_has_no_underscore(quick, candidate):
    assert candidate(quick, "rubber", "tight_fit").label == "rubber, tight fit"


def test_the_baseline_is_the_present_coupling_at_the_present_gap(quick, baseline):
    performance = baseline.performance
    assert (performance.torsional_stiffness, performance.key_gap) == (2e3, 1e-4)
    assert (baseline.coupling_type, baseline.connection) == ("rubber", "key")


def test_the_baseline_knows_its_steps(quick, baseline):
    assert baseline.time_step == 5e-4
    assert baseline.largest_stable_step == largest_stable_step(quick.driveline)


def test_the_peak_is_that_of_the_history(quick, baseline):
    history = simulate(quick.driveline, quick.shutdown)
    peak = abs(history.transmission_force).max()
    assert baseline.performance.peak_transmission_force == pytest.approx(peak)


def test_revolutions_are_the_generators(quick, baseline):
    history = simulate(quick.driveline, quick.shutdown)
    turned = history.generator_speed.sum() * quick.shutdown.time_step
    expected = turned / (2 * math.pi)
    assert baseline.rundown.revolutions == pytest.approx(expected, rel=1e-3)
    final_speed = pytest.approx(history.generator_speed[-1], rel=1e-8)
    assert baseline.rundown.final_speed == final_speed


def test_an_engine_still_turning_is_not_at_rest(baseline):
    assert baseline.rundown.rest_time is None


def test_an_engine_that_comes_to_rest_turns_no_more(quick, bench, with_shutdown):
    """At 300 rpm with 125 N*m on 5.8 kg*m^2 it stands after about 1.4 s."""
    long = evaluate_baseline(bench(with_shutdown(quick, duration=3.0))).rundown
    longer = evaluate_baseline(bench(with_shutdown(quick, duration=4.0))).rundown
    assert 1.2 < long.rest_time < 2.0
    assert longer.rest_time == pytest.approx(long.rest_time)
    assert longer.revolutions == pytest.approx(long.revolutions, abs=0.02)


def test_resonance_is_where_order_2_passes_the_natural_frequency(quick, evaluator):
    """5.98 Hz over order 2 is 18.8 rad/s; a fast pass peaks somewhat later."""
    examined = evaluator(quick, "rubber", "tight_fit")
    found = rundown(examined, examined.performance(2e3, 0.0))
    assert found.resonance_speed == pytest.approx(18.8, rel=0.35)

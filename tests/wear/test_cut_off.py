"""A run-down that ends too soon is said to; so is a weight that no coupling mends."""

from dataclasses import replace

import pytest

from coupling_design.checks.warnings import (
    ends_above_resonance,
    run_down_warnings,
    stop_remark,
    weight_above_limit,
)
from coupling_design.flow.design import run_design
from coupling_design.machine.words import LoadLimitReading


@pytest.fixture(scope="module")
def stopped(quick, with_shutdown, evaluator):
    """Return the small case and its present coupling's run-down of some duration.

    Its natural frequency of 5.963 Hz meets order 2, the largest, at 178.9 rpm.
    """

    def after(duration):
        case = with_shutdown(quick, duration=duration)
        present = evaluator(case, "rubber", "key")
        coupling, connection = case.driveline.coupling, case.driveline.connection
        return case, present.performance(coupling.torsional_stiffness, connection.gap)

    return after


def test_turning_above_the_resonance_is_warned_of(stopped):
    case, performance = stopped(0.1)
    assert ends_above_resonance(case, performance)
    (told,) = run_down_warnings(case, performance, "Present coupling")
    assert "above the resonance with order 2 at 178.9 rpm" in told


def test_creeping_is_a_remark_and_no_warning(stopped):
    case, performance = stopped(1.0)
    assert not ends_above_resonance(case, performance)
    assert run_down_warnings(case, performance, "Present coupling") == ()
    assert "before rest" in stop_remark(case, performance)


def test_at_rest_nothing_is_said(stopped):
    case, performance = stopped(3.0)
    assert stop_remark(case, performance) is None


@pytest.fixture(scope="module")
def heavy(quick):
    """Both bearings' F_min is below the share of the rotor's weight on them."""
    shaft = replace(quick.shaft, rotor_weight=20e3)
    return replace(quick, shaft=shaft, reading=LoadLimitReading.COMBINED_LOAD)


def test_the_weight_alone_is_above_the_limit(heavy):
    first, second = weight_above_limit(heavy)
    assert "weight on Drive end exceeds F_min" in first
    # 20 kN * 320/600 = 10.67 kN; (1500/84.3433)^3 = 5625 N
    assert "weight on Other end exceeds F_min: 10.67 kN against 5.625 kN" in second


@pytest.mark.slow
def test_the_weight_is_the_reason_for_no_design(heavy, tiny_effort):
    outcome = run_design(heavy, effort=tiny_effort)
    assert outcome.chosen is None
    assert any("weight on Other end" in reason for reason in outcome.reasons)

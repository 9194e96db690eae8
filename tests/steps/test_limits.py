import math

import pytest

from coupling_design.machine.words import LoadLimitReading
from coupling_design.parts.bearing.contact_stress import strict_transmission_force
from coupling_design.parts.criterion import Sense
from coupling_design.steps.limits import (
    ISOLATION_RATIO,
    excitation_frequencies,
    high_frequency_constraint,
    highest_excitation,
    isolation_constraints,
    load_constraints,
    survival_constraints,
)

TRANSMISSION_FORCE = LoadLimitReading.TRANSMISSION_FORCE
COMBINED_LOAD = LoadLimitReading.COMBINED_LOAD


def test_the_papers_highest_excitation_is_order_8_at_1000_rpm(paper):
    assert highest_excitation(paper) == pytest.approx(8 * 1000 / 60)
    assert highest_excitation(paper) == pytest.approx(133.33, abs=0.005)


def test_every_order_spans_the_working_speed(paper):
    """Order 4 at 400 and 1000 rpm: 4 * 400 / 60 = 26.67 Hz, 4 * 1000 / 60 = 66.67."""
    assert excitation_frequencies(paper)[0] == pytest.approx((4, 26.667, 66.667), 1e-4)


def test_the_papers_high_stiffness_plan_starts_at_188_56_hz(paper):
    limit = high_frequency_constraint(paper)
    assert limit.limit == pytest.approx(188.56, abs=0.005)
    assert limit.sense is Sense.AT_LEAST
    assert not limit.needs_rollout


def test_isolation_is_a_ratio_of_sqrt_2():
    assert pytest.approx(math.sqrt(2)) == ISOLATION_RATIO


def test_isolation_is_asked_of_every_order_at_the_lowest_speed(paper, perform):
    limits = isolation_constraints(paper)
    performance = perform(frequency=10.0)
    ratios = [limit.quantity(performance) for limit in limits]
    assert ratios == pytest.approx([4 * 400 / 60 / 10, 8 * 400 / 60 / 10])
    assert all(limit.limit == ISOLATION_RATIO for limit in limits)
    assert not any(limit.needs_rollout for limit in limits)


def test_a_frequency_that_isolates_just_so_has_no_excess(paper, perform):
    order_4 = isolation_constraints(paper)[0]
    border = perform(frequency=4 * 400 / 60 / math.sqrt(2))
    assert order_4.excess(border) == pytest.approx(0.0, abs=1e-12)
    assert order_4.excess(perform(frequency=25.0)) > 0


def test_a_bearing_must_survive_the_stop(paper, perform):
    limit, _ = survival_constraints(paper)
    assert limit.criterion(perform(damage=0.999)).passes
    assert limit.criterion(perform(damage=1.001)).fails
    assert limit.needs_rollout


def test_no_peak_load_is_above_a_static_rating(paper, perform):
    """NU2326: C_0 is 1230 kN."""
    _, static = survival_constraints(paper)
    assert static.criterion(perform(peak=1229e3)).passes
    assert static.criterion(perform(peak=1231e3)).fails
    assert static.quantity(perform(peak=615e3)) == pytest.approx(0.5)


def test_the_papers_permissible_force_with_the_lever(paper):
    force = strict_transmission_force(paper.shaft, paper.bearings)
    assert force == pytest.approx(28896.14, abs=0.005)


def test_the_papers_reading_holds_the_force(paper, perform):
    (limit,) = load_constraints(paper)
    assert limit.quantity(perform(peak=1234.0)) == 1234.0


def test_the_strict_reading_holds_the_load_of_each_bearing(paper, perform):
    """F_min = (800 MPa / 3.62 MPa)^2 = 48838.56 N."""
    limits = load_constraints(paper, COMBINED_LOAD)
    assert [limit.limit for limit in limits] == pytest.approx([48838.56] * 2, abs=0.005)
    values = [limit.quantity(perform(peak=1000.0)) for limit in limits]
    assert values == [1000.0, 500.0]


def test_the_case_says_which_reading(quick, hopeless):
    from dataclasses import replace

    strict = replace(quick, reading=COMBINED_LOAD)
    assert len(load_constraints(quick)) == 1
    assert len(load_constraints(strict)) == 2


def test_every_limit_says_where_it_comes_from(paper):
    limits = (
        *isolation_constraints(paper),
        high_frequency_constraint(paper),
        *load_constraints(paper, TRANSMISSION_FORCE),
        *load_constraints(paper, COMBINED_LOAD),
    )
    assert all(limit.source and limit.name for limit in limits)
    assert len({limit.name for limit in limits}) == len(limits)

import math

import pytest

from coupling_design.search.reach import reachable_stiffness
from coupling_design.steps.limits import (
    high_frequency_constraint,
    isolation_constraints,
)


def stiffness_at(frequency, driveline):
    """Return k = (2 pi f)^2 J_red of two masses, the hub turning with the rotor."""
    driven = driveline.coupling_inertia + driveline.generator_inertia
    reduced = driveline.engine_inertia * driven / (driveline.engine_inertia + driven)
    return (2 * math.pi * frequency) ** 2 * reduced


@pytest.fixture(scope="module")
def diaphragm(paper, evaluator):
    return evaluator(paper, "diaphragm", "tight_fit")


def test_the_papers_lowest_high_stiffness(paper, diaphragm):
    """(2 pi 188.56)^2 * 177.65 * 604.86 / 782.51 = 192.75e6 N*m/rad."""
    limit = high_frequency_constraint(paper)
    low, high = reachable_stiffness(diaphragm, [limit], (100e6, 400e6))
    assert low == pytest.approx(stiffness_at(limit.limit, paper.driveline), rel=5e-6)
    assert low == pytest.approx(192.75e6, rel=5e-5)
    assert high == 400e6


def test_the_stiffest_that_isolates(quick, evaluator):
    """Order 2 at 600 rpm, 20 Hz, is the nearest: f <= 20 / sqrt 2 = 14.14 Hz."""
    examined = evaluator(quick, "rubber", "tight_fit")
    limits = isolation_constraints(quick)
    low, high = reachable_stiffness(examined, limits, (1e3, 2e4))
    border = stiffness_at(20 / math.sqrt(2), quick.driveline)
    assert low == 1e3
    assert high == pytest.approx(border, rel=5e-6)


def test_the_border_is_on_the_good_side(quick, evaluator):
    examined = evaluator(quick, "rubber", "key")
    limits = isolation_constraints(quick)
    _, high = reachable_stiffness(examined, limits, (1e3, 2e4))
    border = examined.outline(high)
    assert all(limit.criterion(border).passes for limit in limits)


def test_a_range_wholly_inside_is_kept(quick, evaluator):
    examined = evaluator(quick, "rubber", "tight_fit")
    limits = isolation_constraints(quick)
    assert reachable_stiffness(examined, limits, (2e3, 3e3)) == (2e3, 3e3)


def test_both_limits_together_leave_nothing(quick, evaluator):
    examined = evaluator(quick, "rubber", "tight_fit")
    limits = [*isolation_constraints(quick), high_frequency_constraint(quick)]
    assert reachable_stiffness(examined, limits, (1e3, 2e6)) is None


def test_a_limit_out_of_reach_leaves_nothing(paper, diaphragm):
    limit = high_frequency_constraint(paper)
    assert reachable_stiffness(diaphragm, [limit], (1e6, 100e6)) is None


def test_loads_do_not_count(quick, evaluator, force_limit):
    examined = evaluator(quick, "rubber", "key")
    span = reachable_stiffness(examined, [force_limit(1e-3)], (1e3, 2e4))
    assert span == (1e3, 2e4)


def test_reach_costs_no_rollout(quick, evaluator):
    examined = evaluator(quick, "rubber", "key")
    reachable_stiffness(examined, isolation_constraints(quick), (1e3, 2e4))
    assert examined.rollouts == 0

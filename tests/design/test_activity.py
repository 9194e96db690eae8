"""What holds an optimum is said only where it has been looked at."""

import pytest

from coupling_design.design.activity import what_holds
from coupling_design.design.problem import Objective

DAMAGE = Objective.DAMAGE


def held(program, ln_stiffness, gap=0.0):
    point = program.evaluator.performance(2.718281828459045**ln_stiffness, gap)
    return what_holds(program, point)


def test_an_inner_minimum_is_larger_at_each_bound(landscape):
    program = landscape(lambda k, gap: (k - 2.0) ** 2, DAMAGE)
    assert held(program, 2.0) == (
        "no constraint and no bound: an inner minimum, larger at each bound"
    )


def test_a_point_short_of_a_better_bound_is_no_minimum(landscape):
    """Damage is 1/k: from ln k = 4 to the bound at ln 100 = 4.60517 falls 45.4 %."""
    told = held(landscape(lambda k, gap: -k, DAMAGE), 4.0)
    assert told == (
        "nothing: stopped short, damage falls on towards its upper torsional "
        "stiffness bound, where there is 45.40% less"
    )


def test_where_a_bound_does_as_well_neither_is_the_minimum(landscape):
    """A logarithm of damage that is 1e-5 less at the bound: the two are one."""
    told = held(landscape(lambda k, gap: -2e-5 * k, DAMAGE), 4.0)
    assert "upper torsional stiffness bound, where there is as much to 1e-4" in told


def test_a_gap_may_be_what_falls_on(landscape):
    program = landscape(lambda k, gap: (k - 2.0) ** 2 + gap, DAMAGE, gap=(0.0, 1e-3))
    assert "lower key gap bound" in held(program, 2.0, 5e-4)


def test_a_bound_that_breaks_a_limit_is_no_way_on(landscape, force_limit):
    """Damage falls with stiffness, but at the bound the force is over its limit."""
    program = landscape(
        lambda k, gap: -k,
        DAMAGE,
        [force_limit(60.0)],
        log_peak=lambda k, gap: 1.0 * k,
    )
    assert held(program, 4.0).startswith("no constraint and no bound")


@pytest.mark.parametrize("ln_stiffness", [0.0, 4.605170185988092])
def test_what_stands_on_a_bound_is_held_by_it(landscape, ln_stiffness):
    told = held(landscape(lambda k, gap: -k, DAMAGE), ln_stiffness)
    assert told.startswith("torsional stiffness at its")

"""What holds an optimum is said only where it has been looked at."""

from dataclasses import replace

import pytest

from coupling_design.parts.criterion import Sense
from coupling_design.search.activity import what_holds
from coupling_design.search.program import Constraint, Objective

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
    assert told.startswith(
        "nothing: damage falls on towards its upper torsional "
        "stiffness bound, where there is 45.4 % less"
    )


def test_a_bound_need_not_do_much_better(landscape):
    """By 1e-4 per unit of ln k: 0.60517 further there is 0.00605 % less."""
    told = held(landscape(lambda k, gap: -1e-4 * k, DAMAGE), 4.0)
    assert "upper torsional stiffness bound, where there is 0.00605 % less" in told


def test_where_a_bound_does_as_well_neither_is_the_minimum(landscape):
    """A minimum by less than a damage is known to."""
    told = held(landscape(lambda k, gap: 1e-5 * (k - 4.0) ** 2, DAMAGE), 4.0)
    assert "is flat towards its upper torsional stiffness bound: as much to" in told


def test_a_gap_may_be_what_falls_on(landscape):
    program = landscape(lambda k, gap: (k - 2.0) ** 2 + gap, DAMAGE, gap=(0.0, 1e-3))
    assert "lower key gap bound" in held(program, 2.0, 5e-4)


def test_short_of_a_limit_is_no_minimum_either(landscape, force_limit):
    """Damage falls until the force meets its limit; the bound itself is beyond it.

    2 % of ln 100 = 4.60517 further there is 1 - exp(-0.092103) = 8.80 % less.
    """
    program = landscape(
        lambda k, gap: -k,
        DAMAGE,
        [force_limit(80.0)],
        log_peak=lambda k, gap: 1.0 * k,
    )
    assert held(program, 4.0) == (
        "nothing: damage falls on towards a larger torsional "
        "stiffness, where there is 8.8 % less: stopped short"
    )


def test_what_the_frequency_leaves_is_the_bound(landscape):
    """Damage falls with stiffness; the bound is where the frequency limit ends it."""
    program = landscape(lambda k, gap: -2e-5 * k, DAMAGE)
    frequency = Constraint(
        name="frequency",
        quantity=lambda performance: performance.natural_frequency,
        limit=float(program.evaluator.natural_frequency(80.0)),
        sense=Sense.AT_MOST,
        unit="Hz",
        source="this test",
        needs_rollout=False,
    )
    told = held(replace(program, constraints=(frequency,)), 4.0)
    assert "its upper torsional stiffness bound" in told


@pytest.mark.parametrize("ln_stiffness", [0.0, 4.605170185988092])
def test_what_stands_on_a_bound_is_held_by_it(landscape, ln_stiffness):
    told = held(landscape(lambda k, gap: -k, DAMAGE), ln_stiffness)
    assert told.startswith("torsional stiffness at its")

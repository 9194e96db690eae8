import casadi as ca
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from coupling_design.parts.criterion import Sense
from coupling_design.search.program import (
    BACK_OFF,
    Constraint,
    DesignProblem,
    DesignSpace,
    Objective,
)

SPACE = DesignSpace((1e3, 2e4), (2e-5, 2e-4))
FIXED_GAP = DesignSpace((1e3, 2e4), (1e-4, 1e-4))


def limited(sense, limit=100.0):
    return Constraint(
        "force", lambda p: p.peak_transmission_force, limit, sense, "", ""
    )


@given(st.floats(0, 1), st.floats(0, 1))
def test_scaling_there_and_back(stiffness, gap):
    point = SPACE.point([stiffness, gap])
    assert SPACE.scaled(*map(float, point)) == pytest.approx([stiffness, gap], abs=1e-9)


@pytest.mark.parametrize("end", [0, 1])
def test_the_bounds_are_the_ends_of_the_variables(end):
    stiffness, gap = SPACE.point([float(end), float(end)])
    assert float(stiffness) == pytest.approx(SPACE.stiffness[end], rel=1e-14)
    assert float(gap) == pytest.approx(SPACE.gap[end], rel=1e-14)
    assert SPACE.scaled(SPACE.stiffness[end], SPACE.gap[end]) == [end, end]


def test_the_middle_of_stiffness_is_that_of_its_ratio():
    stiffness, _ = SPACE.point([0.5, 0.5])
    assert float(stiffness) == pytest.approx((1e3 * 2e4) ** 0.5)


def test_a_fixed_gap_is_no_variable():
    assert not FIXED_GAP.gap_is_free
    assert len(FIXED_GAP.scaled(5e3, 1e-4)) == 1
    assert FIXED_GAP.point([0.3])[1] == 1e-4


def test_a_point_beyond_the_bounds_is_scaled_to_them():
    assert SPACE.scaled(1.0, 1.0) == [0.0, 1.0]


def test_a_fixed_stiffness_can_be_scaled():
    assert DesignSpace((5e3, 5e3), (0.0, 0.0)).scaled(5e3, 0.0) == [0.0]


@pytest.mark.parametrize(
    ("sense", "value", "margin"),
    [
        (Sense.AT_MOST, 90.0, 0.1),
        (Sense.AT_MOST, 110.0, -0.1),
        (Sense.AT_LEAST, 110.0, 0.1),
        (Sense.AT_LEAST, 90.0, -0.1),
    ],
)
def test_the_good_side_of_a_limit_has_a_positive_margin(perform, sense, value, margin):
    criterion = limited(sense).criterion(perform(peak=value))
    assert criterion.margin == pytest.approx(margin)
    assert criterion.passes == (margin > 0)
    assert (criterion.value, criterion.limit) == (value, 100.0)


@pytest.mark.parametrize("sense", Sense)
def test_the_limit_itself_passes(perform, sense):
    criterion = limited(sense).criterion(perform(peak=100.0))
    assert criterion.passes
    assert str(criterion.margin) == "0.0"


@pytest.fixture
def program(quick, evaluator, force_limit):
    """Return a program of the small case with a limit on force and on frequency."""
    frequency = Constraint(
        "frequency",
        lambda performance: performance.natural_frequency,
        10.0,
        Sense.AT_MOST,
        "Hz",
        "this test",
        needs_rollout=False,
    )

    def made(objective, space=FIXED_GAP, case=quick, kind="key"):
        constraints = (frequency, force_limit(2000.0))
        examined = evaluator(case, "rubber", kind)
        return DesignProblem(examined, space, objective, constraints)

    return made


def test_least_damage_is_that_of_the_worse_bearing(program, perform):
    value = program(Objective.DAMAGE).value(perform(damage=1e-9))
    assert float(value) == pytest.approx(np.log(1e-9))


def test_least_stiffness_starts_at_the_lower_bound(program, perform):
    lowest_stiffness = program(Objective.STIFFNESS)
    assert float(lowest_stiffness.value(perform(stiffness=1e3))) == 0.0
    assert float(lowest_stiffness.value(perform(stiffness=2e3))) == pytest.approx(
        np.log(2)
    )


def test_least_load_is_over_its_limit(program, perform):
    value = program(Objective.PEAK).value(perform(peak=3000.0, frequency=1e6))
    assert float(value) == pytest.approx(1.5)


def test_a_load_that_is_minimised_does_not_bind(program, perform):
    over = perform(peak=3000.0)
    assert program(Objective.PEAK).is_feasible(over)
    assert not program(Objective.DAMAGE).is_feasible(over)


def test_no_force_meets_a_limit_that_the_weight_alone_exceeds(force_limit, perform):
    """F_min less the static load is below zero where the rotor is too heavy."""
    criterion = force_limit(-5.0).criterion(perform(peak=10.0))
    assert not criterion.passes
    assert criterion.margin == pytest.approx(-3.0)  # 15 N beyond, over 5 N


def test_violation_is_the_largest_excess(program, perform):
    over = perform(peak=3000.0, frequency=12.0)
    damage = program(Objective.DAMAGE)
    assert damage.violation(over) == pytest.approx(0.5)
    assert damage.violation_without_rollout(over) == pytest.approx(0.2)
    assert damage.violation(perform(peak=1.0)) == 0.0


@pytest.mark.parametrize("objective", Objective)
def test_functions_give_the_objective_and_excess_of_a_performance(program, objective):
    examined = program(objective)
    functions, kept = examined.functions()
    value, excess = functions([0.4])
    stiffness, gap = FIXED_GAP.point([0.4])
    performance = examined.evaluator.performance(float(stiffness), gap)
    assert kept
    assert float(value) == pytest.approx(float(examined.value(performance)), rel=1e-6)
    expected = [float(c.excess(performance)) + BACK_OFF for c in examined.binding]
    assert excess.full().ravel() == pytest.approx(expected, rel=1e-6)


def derivatives(functions, place):
    u = functions.mx_in(0)
    parts = ca.vertcat(*functions(u))
    jacobian = ca.Function("jacobian", [u], [ca.jacobian(parts, u)])
    step = 1e-6 * np.eye(len(place))
    values = ca.Function("values", [u], [parts])
    differences = [(values(place + h) - values(place - h)) / 2e-6 for h in step]
    return jacobian(place).full(), ca.horzcat(*differences).full()


@pytest.mark.parametrize("objective", Objective)
def test_derivatives_of_a_tight_fit_are_those_of_differences(program, objective):
    space = DesignSpace((1e3, 2e4), (0.0, 0.0))
    functions, _kept = program(objective, space, kind="tight_fit").functions()
    exact, expected = derivatives(functions, np.array([0.4]))
    assert exact == pytest.approx(expected, rel=1e-4, abs=1e-7)


def test_derivatives_with_the_gap_free_are_those_of_differences(
    program, quick, with_shutdown
):
    short = with_shutdown(quick, duration=0.1)
    functions, _kept = program(Objective.DAMAGE, SPACE, short).functions()
    exact, expected = derivatives(functions, np.array([0.4, 0.6]))
    assert exact.shape == (3, 2)
    assert exact == pytest.approx(expected, rel=1e-3, abs=1e-5)


def test_a_limit_is_approached_from_inside(program, perform):
    """What the program calls feasible passes when it is checked again."""
    constraint = program(Objective.DAMAGE).constraints[1]
    at_programs_limit = perform(peak=2000.0 * (1 - BACK_OFF))
    assert float(constraint.excess(at_programs_limit)) + BACK_OFF == pytest.approx(0.0)
    assert constraint.criterion(at_programs_limit).passes

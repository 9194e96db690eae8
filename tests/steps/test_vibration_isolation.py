from dataclasses import replace

import pytest

from coupling_design.steps.so_far import AllowedType
from coupling_design.steps.step_result import Decision
from coupling_design.steps.vibration_isolation import check_vibration_isolation


@pytest.fixture
def examine(start_of):
    """Return the state after Step 2, every type let through to it."""

    def after(case, stiffness=(1e3, 2e4)):
        elastic = (AllowedType(case.coupling_types[0], stiffness),)
        return check_vibration_isolation(replace(start_of(case), elastic=elastic))

    return after


def with_speeds(case, lowest, highest):
    return replace(case, duty=replace(case.duty, working_speed=(lowest, highest)))


def test_the_range_is_cut_to_what_isolates(quick, examine):
    """14.14 Hz on 1.4224 kg*m^2 is 11.23 kN*m/rad."""
    state = examine(quick)
    assert state.steps[-1].decision is Decision.PASS
    assert (
        "tight fit: 0.001 to 0.01123 MN*m/rad" in state.steps[-1].alternatives[0].remark
    )
    low, high = state.elastic[0].stiffness
    assert low == 1e3
    assert high == pytest.approx(11.336e3, rel=1e-4)


def test_the_key_is_a_spring_in_series_and_leaves_more(quick, examine):
    """At w^2 = (28.284 pi)^2 = 7895.7 with kg = 1 MN*m/rad, the generator swings by 1.

    Hub: 1 - 3.0 * 7895.7 / 1e6 = 0.97631; torque of the coupling: 7895.7 * (0.3 *
    0.97631 + 3.0) = 26.000 kN*m; engine: -26 000 / (2.5 * 7895.7) = -1.31718. So it is
    26.000 kN*m / (0.97631 + 1.31718) = 11.336 kN*m/rad.
    """
    (told,) = examine(quick).steps[-1].alternatives
    assert told.remark == (
        "isolates with key and spline: 0.001 to 0.01134 MN*m/rad; "
        "tight fit: 0.001 to 0.01123 MN*m/rad"
    )


def test_a_connection_that_never_isolates_is_left_out(quick, examine):
    """Between what isolates in a tight fit, 11.23, and with a key, 11.336 kN*m/rad."""
    state = examine(quick, (1.13e4, 2e4))
    assert state.elastic[0].stiffness == pytest.approx((1.13e4, 1.1336e4), rel=1e-4)
    assert "tight fit" not in state.steps[-1].alternatives[0].remark


def test_the_criteria_are_those_of_the_present_coupling(quick, examine):
    """20 Hz and 40 Hz over 5.963 Hz."""
    criteria = examine(quick).steps[-1].criteria
    assert [c.value for c in criteria] == pytest.approx([3.354, 6.708], abs=1e-3)
    assert all(c.passes for c in criteria)


def test_a_present_coupling_that_does_not_isolate_is_told_of(quick, examine):
    state = examine(with_speeds(quick, 20.0, 90.0))
    step = state.steps[-1]
    assert not step.criteria[0].passes
    assert "is not isolated" in step.findings[0]
    assert step.decision is Decision.PASS
    assert state.elastic[0].stiffness[1] < 2e3


def test_a_range_too_stiff_to_isolate_fails(quick, examine):
    state = examine(quick, (1.5e4, 2e4))
    assert state.steps[-1].decision is Decision.FAIL
    assert state.elastic == ()
    assert not state.steps[-1].alternatives[0].passes


def test_isolation_costs_no_rollout(quick, start_of):
    """No more than the present coupling has taken before."""
    state = start_of(quick)
    before = state.bench.rollouts
    elastic = (AllowedType(quick.coupling_types[0], (1e3, 2e4)),)
    assert (
        check_vibration_isolation(replace(state, elastic=elastic)).bench.rollouts
        == before
    )

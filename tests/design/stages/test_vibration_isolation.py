from dataclasses import replace

import pytest

from coupling_design.design.baseline import present_candidate
from coupling_design.design.results import Decision
from coupling_design.design.stages.vibration_isolation import check_vibration_isolation
from coupling_design.design.state import AllowedType


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
    """14.14 Hz on 1.4224 kg*m^2 is 11.23 kN*m/rad; a key in series allows more.

    J1 -k- J2 -k_g- J3 with 2.5, 0.3, 3 kg m^2 and k_g = 1e6 at omega = 88.858 rad/s,
    x = omega^2 = 7895.7: x^2 - B x + C = 0 is linear in k,
    k = (x^2 - k_g (1/J2 + 1/J3) x) / ((1/J1 + 1/J2) x - k_g 5.8 / (2.5 x 0.3 x 3))
      = (6.2342e7 - 2.89509e10) / (2.94773e4 - 2.57778e6) = 11.3364e3 N m/rad.
    """
    state = examine(quick)
    assert state.steps[-1].decision is Decision.PASS
    low, high = state.elastic[0].stiffness
    assert low == 1e3
    assert high == pytest.approx(11.3364e3, rel=1e-4)
    remark = state.steps[-1].alternatives[0].remark
    assert "tight fit: 0.001 to 0.01123 MN*m/rad" in remark


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


def test_isolation_costs_no_rollout(quick, examine):
    """None beyond those of the present coupling."""
    state = examine(quick)
    present = state.bench.evaluator(present_candidate(quick))
    assert state.bench.rollouts == present.all_rollouts

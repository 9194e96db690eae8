from dataclasses import replace

import pytest

from coupling_design.design.coupling_checks import torque_criteria
from coupling_design.design.results import Decision
from coupling_design.design.stages.coupling_types import determine_coupling_types


@pytest.fixture
def begin(start_of):
    return lambda case: determine_coupling_types(start_of(case))


def names(allowed):
    return [a.coupling_type.name for a in allowed]


def with_duty(case, **changes):
    return replace(case, duty=replace(case.duty, **changes))


def test_types_that_carry_the_torque_go_on_by_plan(quick, begin):
    state = begin(quick)
    assert state.steps[-1].decision is Decision.PASS
    assert names(state.elastic) == ["rubber"]
    assert names(state.stiff) == ["disc pack"]


def test_a_type_goes_on_with_its_whole_range(quick, begin):
    assert begin(quick).stiff[0].stiffness == (2e5, 2e6)


def test_every_type_is_told_of(quick, begin):
    step = begin(quick).steps[-1]
    assert [(a.name, a.passes) for a in step.alternatives] == [
        ("rubber", True),
        ("rubber small", False),
        ("disc pack", True),
    ]
    assert len(step.criteria) == 9


def test_the_service_factor_counts(quick):
    """1.2 kN*m x 1.2 = 1.44 kN*m against 1.25 kN*m."""
    rated, peak, speed = torque_criteria(quick, quick.coupling_types[1])
    assert rated.value == pytest.approx(1440.0)
    assert rated.margin == pytest.approx(1 - 1440 / 1250)
    assert (rated.passes, peak.passes, speed.passes) == (False, True, True)


@pytest.mark.parametrize(
    "changes", [{"peak_torque": 1e4}, {"working_speed": (60.0, 500.0)}]
)
def test_peak_torque_and_speed_can_fail_every_type(quick, begin, changes):
    state = begin(with_duty(quick, **changes))
    assert state.steps[-1].decision is Decision.FAIL
    assert state.elastic == state.stiff == ()

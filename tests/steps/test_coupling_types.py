from dataclasses import replace

import pytest

from coupling_design.checks.coupling import torque_criteria
from coupling_design.parts.criterion import Verdict
from coupling_design.steps.coupling_types import determine_coupling_types
from coupling_design.steps.step_result import Decision


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
    assert [c.verdict for c in step.criteria].count(Verdict.NOT_CHECKED) == 9
    assert len(step.criteria) == 18


def test_the_service_factor_counts(quick):
    """1.2 kN*m x 1.2 = 1.44 kN*m against 1.25 kN*m."""
    rated, peak, speed, *_ = torque_criteria(quick, quick.coupling_types[1])
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


def test_a_series_goes_on_with_the_sizes_that_carry(with_sizes, begin):
    """D 2 (1.25 kN*m against 1.44) does not: 0.02 to 1.5 MN*m/rad is left."""
    state = begin(with_sizes())
    assert names(state.stiff) == ["disc pack", "disc"]
    series = state.stiff[1]
    assert [s.name for s in series.coupling_type.sizes] == ["D 9", "D 3", "D 4"]
    assert series.stiffness == (2e4, 1.5e6)
    assert series.coupling_type.nominal_torque == 2500.0


def test_every_size_is_told_of_with_what_it_fails(with_sizes, begin):
    step = begin(with_sizes()).steps[-1]
    told = {a.name: a for a in step.alternatives}
    assert list(told)[3:] == ["disc", "D 9", "D 3", "D 2", "D 4"]
    assert told["disc"].remark.endswith("0.02 to 1.5 MN*m/rad, 3 sizes")
    assert not told["D 2"].passes
    assert "fails: rated torque x service factor x S_t; peak" in told["D 2"].remark
    assert told["D 4"].passes
    assert "least to spare, 62%: peak torque" in told["D 4"].remark


def test_the_smallest_size_that_carries_is_shown_against_its_limits(with_sizes, begin):
    step = begin(with_sizes()).steps[-1]
    assert {c.name.partition(":")[0] for c in step.criteria[18:]} == {"D 3"}


def test_a_series_of_which_no_size_carries(with_sizes, begin):
    case = with_duty(with_sizes(), peak_torque=1e5)
    step = begin(case).steps[-1]
    assert step.decision is Decision.FAIL
    assert "no size carries" in [a.remark for a in step.alternatives]
    assert {c.name.partition(":")[0] for c in step.criteria[18:]} == {"D 9"}


def test_what_is_not_checked_stands_by_name_with_what_is_missing(
    quick, with_sizes, begin
):
    unknown = {
        c.name: c.source
        for c in begin(quick).steps[-1].criteria
        if c.verdict is Verdict.NOT_CHECKED
    }
    assert "T_KW" in unknown["rubber: vibratory torque"]
    assert "T_Kmax2" in unknown["rubber: short circuit"]
    assert begin(quick).steps[-1].caveats == ()
    caveats = " ".join(begin(with_sizes()).steps[-1].caveats)
    assert "the fired engine's are larger" in caveats

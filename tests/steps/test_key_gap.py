import pytest

from coupling_design.flow.design import STAGES
from coupling_design.steps.key_gap import minimise_key_gap
from coupling_design.steps.so_far import gap_nearest_present, options_of
from coupling_design.steps.step_result import Decision


@pytest.fixture(scope="module")
def examine(start_of):
    """Return the states before and after Step 5."""

    def both(case):
        before = start_of(case)
        for stage in STAGES[:-1]:
            before = stage(before)
        return before, minimise_key_gap(before)

    return both


@pytest.fixture(scope="module", params=["quick", "calm"])
def examined(request, examine):
    return examine(request.getfixturevalue(request.param))


def test_the_tightest_connection_that_passes_is_taken(examined):
    _, after = examined
    assert after.steps[-1].decision is Decision.PASS
    assert after.solution.candidate.connection.kind == "tight_fit"
    assert after.solution.optimum.performance.key_gap == 0.0


def test_every_limit_is_kept(examined):
    _, after = examined
    performance = after.solution.optimum.performance
    assert all(c.criterion(performance).passes for c in after.solution.constraints)


def test_the_limits_are_those_of_the_earlier_step(examined):
    before, after = examined
    assert after.solution.constraints == before.solution.constraints
    assert after.solution.plan == before.solution.plan


def test_each_connection_goes_to_its_smallest_gap(examined):
    before, after = examined
    options = options_of(before.case, before.solution.candidate.coupling_type)
    found = [a.performance.key_gap for a in after.steps[-1].alternatives]
    smallest = [option.minimum_gap for option in reversed(options)]
    assert found == pytest.approx(smallest, rel=1e-3, abs=1e-12)


def test_with_no_solution_the_step_is_skipped(quick, start_of):
    state = minimise_key_gap(start_of(quick))
    assert state.steps[-1].decision is Decision.SKIPPED
    assert state.solution is None


def test_options_come_tightest_last(quick):
    kinds = [option.kind for option in options_of(quick, quick.coupling_types[0])]
    assert kinds == ["key", "spline", "tight_fit"]


def test_options_are_those_the_type_is_made_with(quick):
    kinds = [option.kind for option in options_of(quick, quick.coupling_types[1])]
    assert kinds == ["key"]


@pytest.mark.parametrize(("kind", "gap"), [(0, 1e-4), (1, 5e-5), (2, 0.0)])
def test_the_gap_is_the_present_one_or_the_nearest_to_it(quick, kind, gap):
    assert gap_nearest_present(quick, quick.connections[kind]) == gap

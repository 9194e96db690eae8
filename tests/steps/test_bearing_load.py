from dataclasses import replace

import pytest

from coupling_design.machine.words import ConnectionKind, LoadLimitReading, Plan
from coupling_design.steps.bearing_load import limit_bearing_load
from coupling_design.steps.so_far import AllowedType
from coupling_design.steps.step_result import Decision


@pytest.fixture(scope="module")
def examine(start_of):
    def after(case, stiffness=(1e3, 1.1e4)):
        elastic = (AllowedType(case.coupling_types[0], stiffness),)
        return limit_bearing_load(replace(start_of(case), elastic=elastic))

    return after


@pytest.fixture(scope="module")
def failed(quick, examine):
    return examine(quick)


@pytest.fixture(scope="module")
def passed(calm, examine):
    return examine(calm)


def force_limit_of(state):
    criteria = state.steps[-1].criteria
    return next(c.limit for c in criteria if c.name == "peak transmission force")


def test_an_elastic_type_below_the_limit_passes(passed):
    assert passed.steps[-1].decision is Decision.PASS
    assert passed.solution.plan is Plan.ELASTIC
    assert all(c.passes for c in passed.steps[-1].criteria)


def test_what_passes_is_at_the_present_gap(passed):
    assert passed.solution.optimum.performance.key_gap == 1e-4
    assert passed.solution.candidate.label == "rubber, key"


def test_least_damage_is_told_with_its_search(passed):
    optimum = passed.steps[-1].optimum
    assert optimum.objective == "damage"
    assert optimum.scan_points == 10
    assert optimum.conditioning is not None


def test_an_elastic_type_above_the_limit_fails(failed):
    step = failed.steps[-1]
    assert step.decision is Decision.FAIL
    assert failed.solution is None
    assert failed.nearest is step.optimum
    assert not all(c.passes for c in step.criteria)


def test_the_evidence_is_the_smallest_peak_with_either_gap(failed):
    present, closed = failed.steps[-1].alternatives
    assert present.performance.key_gap == 1e-4
    assert closed.performance.key_gap == 0.0
    limit = force_limit_of(failed)
    assert present.performance.peak_transmission_force > limit
    assert closed.performance.peak_transmission_force > limit
    assert not present.passes
    assert not closed.passes


def test_no_other_stiffness_has_a_smaller_peak(quick, failed, evaluator):
    """A dense scan may find less where rattling is rough, but not below the limit."""
    points = [(1e3 * 11 ** (i / 99), 1e-4) for i in range(100)]
    scan = evaluator(quick, "rubber", "key").performances(points)
    smallest = min(p.peak_transmission_force for p in scan)
    found = failed.steps[-1].optimum.performance.peak_transmission_force
    assert smallest > force_limit_of(failed)
    assert found < 1.1 * smallest


def test_the_range_is_that_of_the_connection_examined(calm, examine):
    """The key isolates up to 11.336 kN*m/rad (see the tests of Step 2)."""
    state = examine(calm, (1e3, 2e4))
    assert "from 0.001 to 0.01134 MN*m/rad" in state.steps[-1].findings[0]


def test_a_present_connection_that_never_isolates_is_not_examined(calm, examine):
    """From 11.3 kN*m/rad on only key and spline isolate; present is a tight fit."""
    tight = replace(calm, present_connection=ConnectionKind.TIGHT_FIT)
    state = examine(tight, (1.13e4, 2e4))
    assert state.steps[-1].findings[0].startswith("rubber, key: ")


def test_a_bearing_that_dies_within_one_stop_is_no_design(calm, examine):
    """Ratings in kN with N behind them: the load limit is kept, the bearing is not."""
    mistyped = tuple(
        replace(
            bearing,
            dynamic_load_rating=bearing.dynamic_load_rating / 1e3,
            static_load_rating=bearing.static_load_rating / 1e3,
        )
        for bearing in calm.bearings
    )
    state = examine(replace(calm, bearings=mistyped))
    step = state.steps[-1]
    assert state.solution is None
    assert step.decision is Decision.FAIL
    assert "largest bearing load over C_0" in [c.name for c in step.criteria if c.fails]
    assert next(c for c in step.criteria if "transmission" in c.name).passes


def test_the_strict_reading_holds_both_bearings(calm, examine):
    strict = replace(calm, reading=LoadLimitReading.COMBINED_LOAD)
    names = [c.name for c in examine(strict).steps[-1].criteria]
    assert [name for name in names if name.startswith("peak")] == [
        "peak combined load, Drive end",
        "peak combined load, Other end",
    ]


def test_with_no_elastic_type_the_step_is_skipped(quick, start_of):
    state = limit_bearing_load(start_of(quick))
    assert state.steps[-1].decision is Decision.SKIPPED
    assert state.solution is None

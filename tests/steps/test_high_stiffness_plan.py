from dataclasses import replace
from types import SimpleNamespace

import pytest

from coupling_design.machine.words import Plan
from coupling_design.steps.high_stiffness_plan import plan_high_stiffness
from coupling_design.steps.present import present_candidate
from coupling_design.steps.so_far import AllowedType
from coupling_design.steps.step_result import Decision


@pytest.fixture(scope="module")
def examine(start_of):
    def after(case, stiffness=(2e5, 2e6), **changes):
        stiff = (AllowedType(case.coupling_types[2], stiffness),)
        return plan_high_stiffness(replace(start_of(case), stiff=stiff, **changes))

    return after


@pytest.fixture(scope="module")
def passed(quick, examine):
    return examine(quick)


def test_a_stiff_type_passes(passed):
    step = passed.steps[-1]
    assert step.decision is Decision.PASS
    assert passed.solution.plan is Plan.HIGH_STIFFNESS
    assert all(c.passes for c in step.criteria)


def test_the_lowest_stiffness_is_where_the_frequency_just_suffices(passed):
    """sqrt 2 x 4 x 15 Hz = 84.85 Hz, on 1.4224 kg*m^2: 404.3 kN*m/rad."""
    performance = passed.solution.optimum.performance
    assert performance.torsional_stiffness == pytest.approx(404.3e3, rel=1e-3)
    assert performance.natural_frequency == pytest.approx(84.853, rel=1e-4)
    assert "natural frequency" in passed.solution.optimum.active_constraints


def test_every_connection_is_tried(passed):
    names = [a.name for a in passed.steps[-1].alternatives]
    assert names == ["disc pack, key", "disc pack, tight fit"]


def test_a_load_that_nothing_keeps_fails(hopeless, examine):
    state = examine(hopeless)
    step = state.steps[-1]
    assert step.decision is Decision.FAIL
    assert state.solution is None
    assert state.nearest is step.optimum
    assert [c.name for c in step.criteria if c.fails] == ["peak transmission force"]


def test_a_frequency_that_nothing_reaches_fails_without_a_rollout(quick, examine):
    state = examine(quick, (2e5, 3e5))
    assert state.steps[-1].decision is Decision.FAIL
    assert state.nearest is None
    present = state.bench.evaluator(present_candidate(quick))
    assert state.bench.rollouts == present.all_rollouts
    assert all(
        "natural frequency only" in a.remark for a in state.steps[-1].alternatives
    )


def test_with_an_elastic_solution_the_step_is_skipped(quick, examine):
    found = SimpleNamespace()
    state = examine(quick, solution=found)
    assert state.steps[-1].decision is Decision.SKIPPED
    assert state.solution is found


def test_with_no_stiff_type_the_step_is_skipped(quick, start_of):
    assert plan_high_stiffness(start_of(quick)).steps[-1].decision is Decision.SKIPPED

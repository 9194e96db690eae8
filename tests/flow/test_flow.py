import dataclasses
import math

import pytest

from coupling_design.flow.design import run_design
from coupling_design.steps.step_result import Decision
from coupling_design.wear.performance import Performance

PASS, FAIL, SKIPPED = Decision.PASS, Decision.FAIL, Decision.SKIPPED
WAYS = ["high_stiffness", "elastic", "none"]


@pytest.fixture(params=WAYS)
def outcome(request, outcomes):
    return outcomes[request.param]


@pytest.fixture(params=WAYS[:2])
def designed(request, outcomes):
    return outcomes[request.param]


def numbers(value, path="outcome"):
    """Yield every number in nested dataclasses, tuples and mappings, with its path."""
    if dataclasses.is_dataclass(value):
        for field in dataclasses.fields(value):
            yield from numbers(getattr(value, field.name), f"{path}.{field.name}")
    elif isinstance(value, tuple):
        for i, item in enumerate(value):
            yield from numbers(item, f"{path}[{i}]")
    elif isinstance(value, (float, int)):
        yield path, value


@pytest.mark.parametrize(
    ("way", "decisions"),
    [
        ("high_stiffness", [PASS, PASS, FAIL, PASS, PASS]),
        ("elastic", [PASS, PASS, PASS, SKIPPED, PASS]),
        ("none", [PASS, PASS, FAIL, FAIL, SKIPPED]),
    ],
)
def test_each_way_out_has_its_decisions(outcomes, way, decisions):
    assert [step.decision for step in outcomes[way].steps] == decisions


def test_the_steps_are_five_in_order(outcome):
    assert [step.step for step in outcome.steps] == [1, 2, 3, 4, 5]


def test_every_step_asks_a_question(outcome):
    assert all(step.title and step.question.endswith("?") for step in outcome.steps)


def test_no_number_is_not_a_number(outcome):
    found = list(numbers(outcome))
    assert len(found) > 100
    assert [path for path, value in found if not math.isfinite(value)] == []


def test_every_number_is_of_python_itself_or_a_float(outcome):
    """So that JSON takes it."""
    kinds = {type(value) for _, value in numbers(outcome)}
    assert all(issubclass(kind, (float, int)) for kind in kinds)


def test_every_count_is_a_plain_integer(outcome):
    optima = [step.optimum for step in outcome.steps if step.optimum]
    counts = [(o.starts, o.starts_agreeing, o.scan_points, o.rollouts) for o in optima]
    assert {type(count) for row in counts for count in row} <= {int}


def test_agreeing_starts_are_among_the_starts(outcome):
    for step in outcome.steps:
        if step.optimum:
            assert 0 <= step.optimum.starts_agreeing <= step.optimum.starts


@pytest.mark.parametrize("way", WAYS[:2])
def test_the_plan_is_the_one_that_passed(outcomes, way):
    assert outcomes[way].chosen.plan == way


def test_the_chosen_design_meets_its_limits(designed):
    assert all(criterion.passes for criterion in designed.steps[-1].criteria)
    assert all(criterion.margin >= 0 for criterion in designed.steps[-1].criteria)


def test_the_chosen_design_is_in_the_range_of_its_type(designed):
    chosen = designed.chosen
    types = {t.name: t for t in designed.case.coupling_types}
    low, high = types[chosen.coupling_type].stiffness_range
    assert low <= chosen.performance.torsional_stiffness <= high
    assert chosen.connection in types[chosen.coupling_type].connections


def test_damage_falls(designed):
    assert 0 < designed.chosen.damage_reduction < 1


def test_damage_reduction_is_against_the_present_coupling(designed):
    chosen, present = designed.chosen.performance, designed.baseline.performance
    ratio = max(chosen.damages) / max(present.damages)
    assert designed.chosen.damage_reduction == pytest.approx(1 - ratio)


def test_the_chosen_numbers_come_back_from_a_rollout(designed, evaluator):
    chosen = designed.chosen
    examined = evaluator(designed.case, chosen.coupling_type, chosen.connection)
    again = examined.performance(
        chosen.performance.torsional_stiffness, chosen.performance.key_gap
    )
    assert again.damages == pytest.approx(chosen.performance.damages, rel=1e-9)
    assert again.peak_transmission_force == pytest.approx(
        chosen.performance.peak_transmission_force, rel=1e-9
    )


def test_with_a_design_there_is_no_nearest(designed):
    assert designed.nearest is None
    assert designed.nearest_criteria == ()


def test_without_a_design_the_nearest_is_told(outcomes):
    outcome = outcomes["none"]
    assert outcome.chosen is None
    assert outcome.nearest is not None
    assert any(not criterion.passes for criterion in outcome.nearest_criteria)


def test_the_strict_reading_stands_beside(outcome):
    reading = outcome.strict_reading
    assert reading.reading == "combined_load"
    assert len(reading.criteria) == 2
    assert reading.passes == all(criterion.passes for criterion in reading.criteria)


def test_the_strict_reading_is_that_of_the_chosen_design(designed):
    values = [criterion.value for criterion in designed.strict_reading.criteria]
    assert values == list(designed.chosen.performance.peak_combined_load)


def performances(value):
    if isinstance(value, Performance):
        yield value
    elif dataclasses.is_dataclass(value):
        for field in dataclasses.fields(value):
            yield from performances(getattr(value, field.name))
    elif isinstance(value, tuple):
        for item in value:
            yield from performances(item)


def test_every_point_told_of_was_rolled_out(outcome):
    found = list(performances(outcome))
    assert len(found) >= 5
    assert all(min(p.damages) > 0 for p in found)


def test_progress_is_told_by_step(calm, tiny_effort):
    messages = []
    run_design(calm, messages.append, tiny_effort)
    assert messages[0] == "present coupling"
    assert all(message.startswith("step ") for message in messages[1:])
    assert any(message.startswith("step 3 of 5: ") for message in messages)


def test_a_tight_fit_as_built_runs_through(calm, candidate, tiny_effort):
    """The present connection need not have a gap."""
    case = dataclasses.replace(
        calm,
        present_connection=candidate(calm, "rubber", "tight_fit").connection.kind,
        driveline=dataclasses.replace(
            calm.driveline,
            connection=calm.hub_seat.connect("tight_fit", 0.0),
        ),
    )
    outcome = run_design(case, effort=tiny_effort)
    assert outcome.baseline.performance.key_gap == 0.0
    assert outcome.chosen.connection == "tight_fit"

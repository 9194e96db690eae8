"""The whole flow on the cases that ship with the tool: decisions, not damages."""

import pytest

from coupling_design.flow.design import run_design
from coupling_design.machine.words import Plan
from coupling_design.steps.step_result import Decision

pytestmark = pytest.mark.slow

PASS, FAIL, SKIPPED = Decision.PASS, Decision.FAIL, Decision.SKIPPED


def decisions(outcome):
    return [step.decision for step in outcome.steps]


@pytest.fixture(scope="module")
def outcome(paper):
    return run_design(paper)


@pytest.fixture(scope="module")
def force_limit_of(outcome):
    return next(
        criterion.limit
        for criterion in outcome.steps[2].criteria
        if criterion.name == "peak transmission force"
    )


def test_16v280_takes_the_papers_way(outcome):
    assert decisions(outcome) == [PASS, PASS, FAIL, PASS, PASS]


def test_16v280_step_2_passes_the_present_coupling(outcome):
    assert len(outcome.steps[1].criteria) == 2
    assert all(criterion.passes for criterion in outcome.steps[1].criteria)


def test_16v280_step_3_is_held_to_the_papers_force(force_limit_of):
    assert force_limit_of == pytest.approx(36120.18, abs=0.005)


def test_16v280_step_3_shows_its_evidence(outcome, force_limit_of):
    present, closed = outcome.steps[2].alternatives
    assert present.performance.key_gap == pytest.approx(0.28e-3)
    assert closed.performance.key_gap == 0.0
    for alternative in (present, closed):
        assert not alternative.passes
        assert alternative.performance.peak_transmission_force > force_limit_of


def test_16v280_step_3_fails_by_the_load_alone(outcome):
    failed = [c.name for c in outcome.steps[2].criteria if not c.passes]
    assert failed == ["peak transmission force"]


def test_16v280_no_elastic_stiffness_keeps_the_limit(outcome, evaluator, paper):
    """A scan of its own, over all that isolates."""
    low, high = 0.27e6, 2.70e6
    limit = outcome.steps[2].criteria[-1].limit
    points = [(low * (high / low) ** (i / 15), 0.28e-3) for i in range(16)]
    scan = evaluator(paper, "steel-spring", "key").performances(points)
    isolating = [p for p in scan if 8 / 0.3 / p.natural_frequency >= 2**0.5]
    assert all(p.peak_transmission_force > limit for p in isolating)


def test_16v280_step_4_stands_above_188_56_hz(outcome):
    frequency = outcome.steps[3].criteria[0]
    assert frequency.limit == pytest.approx(188.56, abs=0.005)
    assert frequency.value >= frequency.limit


def test_16v280_step_4_finds_192_75_mega(outcome):
    stiffness = outcome.steps[3].optimum.performance.torsional_stiffness
    assert float(f"{stiffness:.5g}") >= 192.75e6


def test_16v280_step_5_ends_in_a_tight_fit(outcome):
    chosen = outcome.chosen
    assert chosen.plan is Plan.HIGH_STIFFNESS
    assert chosen.connection == "tight_fit"
    assert chosen.performance.key_gap == 0.0


def test_16v280_keeps_every_limit(outcome):
    assert all(criterion.passes for criterion in outcome.steps[-1].criteria)


def test_16v280_damage_falls(outcome):
    assert outcome.chosen.damage_reduction > 0


def test_16v280_damage_stands_when_the_step_is_halved(outcome):
    assert abs(outcome.baseline.conditioning.damage_change_by_step) < 1e-3
    assert abs(outcome.chosen.conditioning.damage_change_by_step) < 1e-3


def test_16v280_fails_the_strict_reading_and_says_so(outcome):
    reading = outcome.strict_reading
    assert not reading.passes
    assert reading.permissible_transmission_force == pytest.approx(28896.14, abs=0.005)
    assert any(not criterion.passes for criterion in reading.criteria)


def test_16v280_names_what_it_rests_on(outcome):
    assert {value.source for value in outcome.assumptions} == {
        "assumed",
        "fitted",
        "invented",
    }


def test_the_small_set_keeps_its_elastic_plan(shipped):
    outcome = run_design(shipped("small_genset.yaml"))
    assert decisions(outcome) == [PASS, PASS, PASS, SKIPPED, PASS]
    assert outcome.chosen.plan is Plan.ELASTIC
    assert all(criterion.passes for criterion in outcome.steps[2].criteria)
    assert all(criterion.passes for criterion in outcome.steps[-1].criteria)
    assert outcome.chosen.damage_reduction > 0


def test_the_marine_set_ends_in_a_design_or_says_how_near(shipped):
    outcome = run_design(shipped("8l_marine.yaml"))
    assert len(outcome.steps) == 5
    if outcome.chosen:
        assert all(criterion.passes for criterion in outcome.steps[-1].criteria)
    else:
        assert outcome.nearest is not None
        assert any(not criterion.passes for criterion in outcome.nearest_criteria)

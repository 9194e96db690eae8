"""The best real size beside the ideal stiffness, on the quick case."""

from dataclasses import replace

import pytest

from coupling_design.flow.design import run_design
from coupling_design.flow.real_sizes import choose_size
from coupling_design.machine.candidate import Candidate
from coupling_design.search.workbench import Effort
from coupling_design.wear.evaluator import Evaluator

EFFORT = Effort(stiffnesses=10, survey_gaps=2, stiffnesses_with_gap=4, gaps=2, starts=2)
WANTED = ("design_space:\n", "design_space:\n  choose: catalogue\n")


@pytest.fixture(scope="module")
def case(with_sizes):
    return with_sizes()


@pytest.fixture(scope="module")
def outcome(case):
    return run_design(case, effort=EFFORT)


@pytest.fixture(scope="module")
def choice(outcome):
    return outcome.catalogue_choice


@pytest.fixture(scope="module")
def settled(with_sizes):
    return run_design(with_sizes(WANTED), effort=EFFORT)


def trial(choice, name):
    return next(each for each in choice.trials if each.size.name == name)


def test_no_catalogue_no_choice(outcomes):
    assert outcomes["elastic"].catalogue_choice is None


def test_no_design_no_choice(case, start_of):
    assert choose_size(start_of(case)) is None


def test_the_sizes_that_carry_are_tried(choice):
    assert [each.size.name for each in choice.trials] == ["D 9", "D 3", "D 4"]
    assert choice.plan == "high_stiffness"


def test_they_are_tried_where_the_ideal_is(outcome, choice):
    assert choice.ideal == outcome.chosen.performance
    assert choice.connection == outcome.chosen.connection
    tried = [each.performance for each in choice.trials if each.performance]
    assert {p.key_gap for p in tried} == {choice.ideal.key_gap}


def test_a_size_that_is_too_soft_is_not_rolled_out(choice):
    soft = trial(choice, "D 9")
    assert not soft.passes
    assert soft.performance is None
    assert "natural frequency" in soft.remark


def test_a_size_is_rolled_out_with_what_its_sheet_says(case, choice, outcome):
    """By hand: the size's inertia, stiffness and damping put into the case itself."""
    chosen = trial(choice, "D 4")
    kind = next(t for t in case.coupling_types if t.name == "disc")
    driveline = replace(case.driveline, coupling_inertia=0.6)
    by_hand = replace(case, driveline=driveline)
    law = chosen.size.damping_law
    option = next(o for o in case.connections if o.kind == outcome.chosen.connection)
    candidate = Candidate(replace(kind, damping_law=law, sizes=()), option)
    expected = Evaluator(by_hand, candidate).performance(1.5e6, choice.ideal.key_gap)
    assert chosen.performance.damage == pytest.approx(expected.damage, rel=1e-9)
    assert float(chosen.performance.natural_frequency) == pytest.approx(
        float(expected.natural_frequency)
    )


def test_the_best_keeps_every_limit_with_the_least_damage(choice):
    passing = [each for each in choice.trials if each.passes]
    assert choice.selected in passing
    assert not any(criterion.fails for criterion in choice.selected.criteria)
    least = min(each.performance.damage for each in passing)
    assert choice.selected.performance.damage == least


def test_the_smallest_that_serves_is_named_beside_a_larger_best(choice):
    smallest, best = trial(choice, "D 3"), trial(choice, "D 4")
    assert smallest.passes
    assert choice.selected == best
    more = smallest.performance.damage / best.performance.damage - 1
    assert choice.findings[0] == (
        "The smallest size that meets every limit is D 3; it does "
        f"{more:.1%} more damage than D 4."
    )


def test_the_price_is_damage_over_ideal_damage(choice):
    damage = choice.selected.performance.damage
    assert choice.price == pytest.approx(damage / choice.ideal.damage - 1)


def test_the_price_of_stiffness_leaves_the_rest_alone(case, choice, outcome):
    chosen = outcome.chosen
    kind = next(t for t in case.coupling_types if t.name == chosen.coupling_type)
    option = next(o for o in case.connections if o.kind == chosen.connection)
    alone = Evaluator(case, Candidate(kind, option)).performance(
        choice.selected.size.torsional_stiffness, choice.ideal.key_gap
    )
    price = alone.damage / choice.ideal.damage - 1
    assert choice.price_of_stiffness == pytest.approx(price, rel=1e-6, abs=1e-9)


def test_the_ideal_stays_chosen(outcome, choice):
    assert not choice.is_chosen
    assert outcome.chosen.size is None


def test_a_case_may_want_a_real_size(settled, choice):
    chosen = settled.chosen
    assert settled.catalogue_choice.is_chosen
    assert (chosen.size, chosen.coupling_type) == (choice.selected.size.name, "disc")
    assert chosen.performance == settled.catalogue_choice.selected.performance
    assert chosen.criteria == settled.catalogue_choice.selected.criteria
    assert settled.histories[1].label.startswith(chosen.size)


def test_no_size_keeps_the_limits(with_sizes):
    """Vibratory torque of 1 mN m: then Step 1 lets none go on."""
    small = [("nominal_torque: 4 kN*m", "nominal_torque: 1.3 kN*m"),
             ("nominal_torque: 9 kN*m", "nominal_torque: 1.3 kN*m"),
             ("vibratory_torque: 1 kN*m", "vibratory_torque: 1e-6 kN*m")]  # fmt: skip
    outcome = run_design(with_sizes(WANTED, sizes=small), effort=EFFORT)
    choice = outcome.catalogue_choice
    assert choice.trials == ()
    assert (choice.selected, choice.price, choice.is_chosen) == (None, None, False)
    assert outcome.chosen.coupling_type == "disc pack"
    assert outcome.chosen.size is None


def test_a_size_not_made_with_the_chosen_connection(with_sizes):
    only = [("connections: [key, tight_fit]", "connections: [key]")]
    choice = run_design(with_sizes(sizes=only), effort=EFFORT).catalogue_choice
    assert choice.connection == "tight_fit"
    assert {each.remark for each in choice.trials} == {"not made with a tight fit"}
    assert choice.selected is None


def test_findings_say_whose_inertias_count(choice, with_sizes):
    assert "Its driving inertia was left out" in " ".join(choice.findings)
    half = ("type: rubber\n", "type: rubber\n    driving_inertia: 0.15 kg*m^2\n")
    told = run_design(with_sizes(half), effort=EFFORT).catalogue_choice.findings
    assert "present coupling's 0.15 kg*m^2 within engine_inertia" in " ".join(told)

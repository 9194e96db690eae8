from dataclasses import replace
from types import SimpleNamespace

import pytest

from coupling_design.machine.words import Plan
from coupling_design.search.optimum import Optimum
from coupling_design.search.program import Objective
from coupling_design.steps.parsimony import (
    WORTH_A_CHANGE,
    keep_lowest_stiffness,
    kept_finding,
)
from coupling_design.steps.so_far import AllowedType, Solution


@pytest.fixture
def step_5(landscape, force_limit):
    """Keep stiffness 10, or stiffen to 50 for that much less damage, relative?"""

    def decide(gain, plan=Plan.HIGH_STIFFNESS, limits=()):
        slope = gain / (50.0 - 10.0)
        program = landscape(
            lambda k, gap: -slope * 2.718281828459045**k, Objective.DAMAGE
        )
        evaluator = program.evaluator
        candidate = evaluator.candidate

        def solution(stiffness):
            optimum = Optimum(
                objective="",
                performance=evaluator.performance(stiffness, 0.0),
                connection="",
                coupling_type="",
                method="",
                solver_status="",
                starts=1,
                starts_agreeing=1,
                scan_points=1,
                rollouts=1,
                kkt_residual=None,
                active_constraints=(),
                held_by="",
                conditioning=None,
            )
            allowed = AllowedType(candidate.coupling_type, (1.0, 100.0))
            return Solution(plan, candidate, allowed, optimum, tuple(limits))

        state = SimpleNamespace(bench=SimpleNamespace(evaluator=lambda _: evaluator))
        before, optimum = solution(10.0), solution(50.0)
        return keep_lowest_stiffness(state, before, optimum), optimum

    return decide


def test_a_gain_not_worth_it_leaves_the_lowest_stiffness(step_5):
    kept, _ = step_5(WORTH_A_CHANGE / 2)
    assert kept.optimum.performance.torsional_stiffness == 10.0


def test_a_gain_worth_it_is_taken(step_5):
    kept, optimum = step_5(WORTH_A_CHANGE * 2)
    assert kept is optimum


def test_an_elastic_coupling_is_not_held_to_its_lowest(step_5):
    kept, optimum = step_5(WORTH_A_CHANGE / 2, Plan.ELASTIC)
    assert kept is optimum


def test_the_lowest_is_not_kept_beyond_a_limit(step_5, force_limit):
    kept, optimum = step_5(WORTH_A_CHANGE / 2, limits=[force_limit(0.5)])
    assert kept is optimum


def test_a_kept_stiffness_has_a_conditioning_of_its_own(step_5):
    kept, _ = step_5(WORTH_A_CHANGE / 2)
    assert kept.optimum.conditioning is not None


def test_the_finding_names_both_stiffnesses(step_5):
    kept, optimum = step_5(WORTH_A_CHANGE / 2)
    finding = kept_finding(kept, replace(optimum))
    assert "5e-05 MN*m/rad" in finding
    assert "1e-05 MN*m/rad" in finding
    assert "0.15%" in finding

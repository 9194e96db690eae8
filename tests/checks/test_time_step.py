import re
from dataclasses import replace

import pytest

from coupling_design.checks.time_step import candidates, check_time_step, stable_step
from coupling_design.errors import CaseError
from coupling_design.flow.design import run_design
from coupling_design.line.modes import largest_stable_step


def refusal(case):
    with pytest.raises(CaseError) as error:
        check_time_step(case)
    return error.value


def with_contact(case, contact_stiffness):
    seat = replace(case.hub_seat, contact_stiffness=contact_stiffness)
    return replace(case, hub_seat=seat)


def test_a_step_that_suits_every_candidate_is_taken(quick):
    check_time_step(quick)


def test_a_step_too_large_is_a_problem_of_the_case(quick, with_shutdown):
    error = refusal(with_shutdown(quick, time_step=5e-3))
    assert error.exit_code == 2
    assert len(error.problems) == 1
    assert "quick.yaml:38: shutdown.time_step: found 0.005 s" in error.problems[0]


def test_the_flow_refuses_it_before_any_rollout(quick, with_shutdown):
    with pytest.raises(CaseError, match="time_step"):
        run_design(with_shutdown(quick, time_step=5e-3))


@pytest.mark.parametrize("contact_stiffness", [3e5, 5e5, 1e6, 2e6, 3e6, 5e6, 7e6, 1e7])
def test_the_proposed_step_is_taken(quick, with_shutdown, contact_stiffness):
    case = with_contact(with_shutdown(quick, time_step=5e-3), contact_stiffness)
    proposed = re.search(r"at most ([\d.e-]+) s", refusal(case).problems[0])[1]
    check_time_step(with_shutdown(case, time_step=float(proposed)))


def test_the_proposed_step_is_a_step_that_works(quick, evaluator, with_shutdown):
    too_large = with_shutdown(quick, time_step=5e-3)
    proposed = re.search(r"at most ([\d.e-]+) s", refusal(too_large).problems[0])[1]
    case = with_shutdown(quick, time_step=float(proposed))
    stiffest = evaluator(case, "disc pack", "key").performance(2e6, 1e-4)
    accurate = evaluator(quick, "disc pack", "key").refined.performance(2e6, 1e-4)
    assert stiffest.damage == pytest.approx(accurate.damage, rel=0.05)


def test_the_candidate_that_asks_for_it_is_named(quick, with_shutdown):
    case = with_shutdown(quick, time_step=5e-3)
    steps = {c.label: stable_step(case, c) for c in candidates(case)}
    assert min(steps, key=steps.get) in refusal(case).problems[0]


def test_candidates_are_the_types_in_the_connections_they_are_made_with(quick):
    assert [candidate.label for candidate in candidates(quick)] == [
        "rubber, key",
        "rubber, spline",
        "rubber, tight fit",
        "rubber small, key",
        "disc pack, key",
        "disc pack, tight fit",
    ]


def test_no_stiffness_of_a_candidate_needs_a_smaller_step(quick, evaluator):
    examined = evaluator(quick, "disc pack", "key")
    step = stable_step(quick, examined.candidate)
    for stiffness in (2e5, 4e5, 8e5, 2e6):
        driveline = examined.driveline(stiffness, 0.0)
        assert largest_stable_step(driveline) >= step * (1 - 1e-12)

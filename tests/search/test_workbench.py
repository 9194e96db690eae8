from dataclasses import replace

import pytest

from coupling_design.search.program import DesignSpace, Objective
from coupling_design.search.workbench import (
    Workbench,
    count_valleys,
    look,
    out_of_reach,
    problem,
    search,
    verdict_remark,
)
from coupling_design.steps.limits import (
    high_frequency_constraint,
    isolation_constraints,
)

ELASTIC = DesignSpace((1e3, 2e4), (1e-4, 1e-4))


@pytest.fixture
def elastic(quick, bench, candidate):
    """Return a workbench and the program of the elastic type that must isolate."""
    workbench = bench(quick)
    program = problem(
        workbench,
        candidate(quick, "rubber", "key"),
        ELASTIC,
        Objective.DAMAGE,
        isolation_constraints(quick),
    )
    return workbench, program


def test_a_workbench_builds_an_evaluator_once(quick, bench, candidate):
    workbench = bench(quick)
    first = workbench.evaluator(candidate(quick, "rubber", "key"))
    assert workbench.evaluator(candidate(quick, "rubber", "key")) is first
    assert workbench.evaluator(candidate(quick, "rubber", "spline")) is not first


def test_a_workbench_counts_its_rollouts(elastic):
    workbench, program = elastic
    look(workbench, program)
    assert workbench.rollouts == workbench.effort.stiffnesses


def test_a_look_keeps_to_what_the_frequency_leaves(elastic):
    workbench, program = elastic
    scan = look(workbench, program)
    assert len(scan) == workbench.effort.stiffnesses
    assert all(program.is_feasible(performance) for performance in scan)
    assert max(p.torsional_stiffness for p in scan) < 2e4


def test_a_look_with_the_gap_free_covers_both(elastic):
    workbench, program = elastic
    free = replace(program, space=DesignSpace((1e3, 2e4), (2e-5, 1e-4)))
    scan = look(workbench, free)
    effort = workbench.effort
    assert len(scan) == effort.stiffnesses_with_gap * effort.gaps
    gaps = sorted({p.key_gap for p in scan})
    assert gaps == pytest.approx([2e-5, 1e-4])


def test_a_look_tells_what_is_looked_at(quick, candidate, tiny_effort):
    messages = []
    workbench = Workbench(quick, messages.append, tiny_effort)
    names = candidate(quick, "rubber", "key")
    look(workbench, problem(workbench, names, ELASTIC, Objective.DAMAGE, ()))
    assert messages == ["scanning rubber, key"]


def test_a_scan_at_hand_is_not_made_again(elastic):
    workbench, program = elastic
    scan = look(workbench, program)
    before = workbench.rollouts
    found = search(workbench, program, scan, starts=1)
    plain_and_moved_start, at_bounds = 2, 4
    assert found.scan_points == len(scan)
    assert workbench.rollouts - before <= (
        found.rollouts + plain_and_moved_start + at_bounds
    )


def test_valleys_are_those_of_damage(landscape, perform):
    program = landscape(lambda k, gap: k, Objective.PEAK)
    scan = tuple(perform(damage=damage) for damage in (3, 1, 2, 5, 4, 6))
    assert count_valleys(program, scan) == 2


def out_of(case, bench, candidate, kind, stiffness, limits):
    workbench = bench(case)
    names = candidate(case, "disc pack", kind)
    space = DesignSpace(stiffness, (0.0, 0.0))
    return out_of_reach(problem(workbench, names, space, Objective.STIFFNESS, limits))


def test_what_can_be_reached_is_not_out_of_reach(quick, bench, candidate):
    limits = (high_frequency_constraint(quick),)
    assert out_of(quick, bench, candidate, "key", (2e5, 2e6), limits) is None


def test_out_of_reach_says_how_far(quick, bench, candidate):
    """At 1e5 N*m/rad the two masses have (1e5 / 1.4224)^0.5 / 2 pi = 42.20 Hz."""
    limit = high_frequency_constraint(quick)
    excess, remark = out_of(quick, bench, candidate, "tight_fit", (5e4, 1e5), (limit,))
    assert excess == pytest.approx(1 - 42.20 / limit.limit, abs=1e-4)
    assert remark == "natural frequency only 29.84 to 42.2 Hz"


def test_a_key_is_a_spring_in_series(quick, bench, candidate):
    limits = (high_frequency_constraint(quick),)
    _, remark = out_of(quick, bench, candidate, "key", (5e4, 1e5), limits)
    assert "the contact is a spring in series" in remark


def test_the_remark_names_what_is_failed(landscape, force_limit, perform):
    program = landscape(lambda k, gap: k, Objective.DAMAGE, [force_limit(100.0)])
    assert verdict_remark(program, perform(peak=99.0)) == "meets every limit"
    assert verdict_remark(program, perform(peak=101.0)) == "fails: peak"

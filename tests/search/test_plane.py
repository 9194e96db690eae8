from dataclasses import replace

import numpy as np
import pytest

from coupling_design.search.plane import survey
from coupling_design.search.program import DesignSpace, Objective
from coupling_design.search.workbench import CLOSE, problem
from coupling_design.steps.limits import isolation_constraints


@pytest.fixture(scope="module")
def surveyed(quick, bench, candidate):
    workbench = bench(quick)
    program = problem(
        workbench,
        candidate(quick, "rubber", "key"),
        DesignSpace((1e3, 2e4), (0.0, 1e-4)),
        Objective.DAMAGE,
        isolation_constraints(quick),
    )
    return program, survey(workbench, program)


def test_rows_go_from_the_smallest_gap_to_the_largest(surveyed):
    _, plane = surveyed
    assert {p.key_gap for p in plane.smallest_gap} == {0.0}
    assert {p.key_gap for p in plane.largest_gap} == {1e-4}


def test_every_row_has_the_same_stiffnesses_that_isolate(surveyed):
    program, plane = surveyed
    first, last = (
        [p.torsional_stiffness for p in row] for row in (plane.rows[0], plane.rows[-1])
    )
    assert first == last == sorted(first)
    assert all(program.is_feasible(p) for row in plane.rows for p in row)


def test_the_map_holds_the_survey(surveyed):
    _, plane = surveyed
    drawn = plane.design_map()
    assert drawn.name == "rubber, key"
    assert drawn.key_gap == (0.0, 1e-4)
    assert len(drawn.torsional_stiffness) == 10
    assert drawn.damage[1][3] == plane.rows[1][3].damage
    assert drawn.peak_transmission_force[0][2] == (
        plane.rows[0][2].peak_transmission_force
    )


SMOOTH = DesignSpace((2e4, 4e4), (0.0, 1e-4))


def mapped(quick, bench, candidate, time_step, space=SMOOTH):
    """Return the case's program and its survey of 8 stiffnesses at 5 gaps."""
    shutdown = replace(quick.shutdown, time_step=time_step)
    case = replace(quick, shutdown=shutdown)
    workbench = bench(case)
    workbench.effort = replace(CLOSE, stiffnesses=8, survey_gaps=5)
    program = problem(
        workbench, candidate(case, "rubber", "key"), space, Objective.DAMAGE, ()
    )
    return workbench, program, survey(workbench, program)


def test_rows_between_have_a_longer_step_that_is_good_enough(quick, bench, candidate):
    fine = quick.shutdown.time_step / 16
    workbench, program, plane = mapped(quick, bench, candidate, fine)
    coarse = plane.coarse
    assert coarse.times in (2, 3, 5)
    assert coarse.time_step == pytest.approx(coarse.times * fine)
    assert coarse.checked == 6
    assert 0 < coarse.damage_error <= 1e-3
    assert 0 < coarse.peak_error <= 1e-3
    tried = [n for n in (5, 3, 2) if quick.shutdown.n_steps * 16 % n == 0]
    n_tried = tried.index(coarse.times) + 1
    assert workbench.coarse_rollouts == 3 * 8 + n_tried * coarse.checked
    inner = plane.rows[1][3]
    exact = program.evaluator.performance(inner.torsional_stiffness, inner.key_gap)
    assert inner.damage == pytest.approx(exact.damage, rel=2e-3)
    assert inner.damage != exact.damage


def test_outer_rows_have_the_cases_own_step(quick, bench, candidate):
    _, program, plane = mapped(quick, bench, candidate, quick.shutdown.time_step / 8)
    for row in (plane.smallest_gap, plane.largest_gap):
        points = [(p.torsional_stiffness, p.key_gap) for p in row]
        exact = program.evaluator.scan.performances(points)
        np.testing.assert_array_equal(
            [p.damage for p in row], [p.damage for p in exact]
        )


def test_a_longer_step_that_is_too_far_off_is_not_taken(
    quick, bench, candidate, monkeypatch
):
    monkeypatch.setattr("coupling_design.search.plane._GOOD_ENOUGH", 1e-15)
    fine = quick.shutdown.time_step / 8
    _, program, plane = mapped(quick, bench, candidate, fine)
    assert plane.coarse is None
    inner = plane.rows[2][5]
    assert inner == program.evaluator.scan.performance(
        inner.torsional_stiffness, inner.key_gap
    )


def test_an_unstable_step_is_not_tried(quick, bench, candidate, monkeypatch):
    monkeypatch.setattr("coupling_design.search.plane.stable_step", lambda *_: 0.0)
    workbench, _, plane = mapped(quick, bench, candidate, quick.shutdown.time_step / 8)
    assert plane.coarse is None
    assert workbench.coarse_rollouts == 0

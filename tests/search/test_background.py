"""Rows that no decision waits for: the same whenever, and by whom, they are done."""

import threading
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

import numpy as np
import pytest

from coupling_design.errors import SimulationError
from coupling_design.flow import design as flow
from coupling_design.flow.design import run_design
from coupling_design.lanes.compiler import VARIABLE
from coupling_design.search.plane import survey
from coupling_design.search.program import DesignSpace, Objective
from coupling_design.search.workbench import Effort, problem
from coupling_design.wear.evaluator import Evaluator

N, GAPS = 6, 5
EFFORT = Effort(
    stiffnesses=N, survey_gaps=GAPS, stiffnesses_with_gap=3, gaps=2, starts=1
)


@pytest.fixture
def fine(quick, with_shutdown, evaluator):
    """The small case with a step so short that a map may have a longer one."""
    case = with_shutdown(quick, time_step=quick.shutdown.time_step / 16)
    if not evaluator(case, "rubber", "key").is_compiled:
        pytest.skip("no machine code here: nothing runs in the background")
    return case


@pytest.fixture
def busy(monkeypatch):
    """A background that begins nothing until it is told to."""
    told = threading.Event()

    class Busy(ThreadPoolExecutor):
        def __init__(self, *arguments):
            super().__init__(*arguments)
            self.submit(told.wait)

    monkeypatch.setattr("coupling_design.search.background.ThreadPoolExecutor", Busy)
    yield told
    told.set()


@pytest.fixture
def plane(bench, candidate):
    """Return a survey of a case, and its workbench."""

    def surveyed(case, effort=EFFORT):
        workbench = bench(case)
        workbench.effort = effort
        space = DesignSpace((2e4, 4e4), (0.0, 1e-4))
        keyed = candidate(case, "rubber", "key")
        program = problem(workbench, keyed, space, Objective.DAMAGE, ())
        return survey(workbench, program), workbench

    return surveyed


def futures(found):
    return [deferred._ends for deferred in found.between]


def at_once(found, evaluator):
    """Return the rows that a new evaluator rolls out, all of them in one batch."""
    points = [(p.torsional_stiffness, p.key_gap) for row in found.rows for p in row]
    own = evaluator.scan.performances(points)
    longer = evaluator.scan.coarser(found.coarse.times).performances(points)
    inner = slice(N, N * (GAPS - 1))
    flat = [*own[: inner.start], *longer[inner], *own[inner.stop :]]
    return tuple(tuple(flat[i : i + N]) for i in range(0, len(flat), N))


def test_rows_are_those_rolled_out_at_once(fine, plane, evaluator):
    found, _ = plane(fine)
    for future in futures(found):
        future.result()
    assert found.rows == at_once(found, evaluator(fine, "rubber", "key"))
    assert [row[0].key_gap for row in found.rows] == list(np.linspace(0, 1e-4, GAPS))


@pytest.mark.usefixtures("busy")
def test_rows_that_nobody_has_begun_are_rolled_out_when_asked_for(
    fine, plane, evaluator
):
    found, _ = plane(fine)
    assert found.n_gaps == GAPS
    assert not any(future.done() for future in futures(found))
    assert found.rows == at_once(found, evaluator(fine, "rubber", "key"))


def test_rows_are_counted_once_and_before_they_are_done(fine, plane, busy):
    found, workbench = plane(fine)
    counted = workbench.rollouts, workbench.coarse_rollouts
    busy.set()
    assert len(found.rows) == GAPS
    assert counted == (workbench.rollouts, workbench.coarse_rollouts)
    assert workbench.rollouts == 2 * N + 2  # the outer rows and the sample


def diverge(monkeypatch, is_lost):
    """Let the batches of which `is_lost` says so leave finite numbers."""
    prepare = Evaluator.prepare

    def prepared(self, points, start_offset=0.0):
        march = prepare(self, points, start_offset)
        if not is_lost(self, points):
            return march
        return lambda threads: np.full_like(march(threads), np.nan)

    monkeypatch.setattr(Evaluator, "prepare", prepared)


def is_third_row(points):
    return len(points) == N and points[0][1] == np.linspace(0, 1e-4, GAPS)[2]


def test_a_row_that_diverges_has_the_cases_own_step(
    fine, plane, evaluator, monkeypatch
):
    expected = at_once(plane(fine)[0], evaluator(fine, "rubber", "key"))
    diverge(monkeypatch, lambda e, points: e.coarsening > 1 and is_third_row(points))
    found, workbench = plane(fine)
    points = [(p.torsional_stiffness, p.key_gap) for p in expected[2]]
    own = evaluator(fine, "rubber", "key").scan.performances(points)
    assert found.rows == (*expected[:2], own, *expected[3:])
    assert own != expected[2]
    assert workbench.rollouts == 3 * N  # the sample lies in that row


def test_a_row_that_diverges_with_either_step_is_told(fine, monkeypatch):
    third = np.linspace(0, 1e-4, GAPS)[2]
    diverge(monkeypatch, lambda _, points: {gap for _, gap in points} == {third})
    with pytest.raises(SimulationError, match=r"a gap of 0\.05 mm"):
        run_design(fine, effort=EFFORT)


def test_what_has_not_begun_is_given_up_where_a_step_raises(fine, busy, monkeypatch):
    seen = []

    def fail(state):
        seen.extend(plane for _, plane in state.surveys)
        raise SimulationError("lost")

    monkeypatch.setattr(flow, "STAGES", (*flow.STAGES[:3], fail))
    with pytest.raises(SimulationError, match="lost"):
        run_design(fine, effort=EFFORT)
    [found] = seen
    assert len(found.between) == GAPS - 2
    assert all(future.cancelled() for future in futures(found))
    assert not busy.is_set()


def test_the_outcome_does_not_depend_on_who_was_first(fine, busy):
    messages = []
    outcomes = [run_design(fine, messages.append, EFFORT)]
    assert messages[-1] == "step 5 of 5: finishing the map"
    busy.set()
    outcomes += [run_design(fine, effort=EFFORT) for _ in range(2)]
    first, *others = (replace(outcome, run_time=0.0) for outcome in outcomes)
    assert len(first.steps[2].maps[0].damage) == GAPS
    assert all(other == first for other in others)


def test_without_machine_code_there_is_no_thread(quick, plane, monkeypatch):
    monkeypatch.setenv(VARIABLE, "none")
    found, workbench = plane(quick)
    assert futures(found) == [None] * (GAPS - 2)
    assert workbench.background._pool is None
    assert len(found.rows) == GAPS


def test_two_rows_need_no_thread(fine, plane):
    found, workbench = plane(fine, replace(EFFORT, survey_gaps=2))
    assert found.between == ()
    assert workbench.background._pool is None

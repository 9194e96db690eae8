"""Decisions are the machine's, not those of the crank angle at which a stop begins."""

import dataclasses

import pytest

from coupling_design.flow.design import run_design
from coupling_design.machine.candidate import Candidate
from coupling_design.machine.words import ConnectionKind
from coupling_design.steps.limits import load_constraints, survival_constraints
from coupling_design.steps.so_far import connection_option
from coupling_design.wear.evaluator import Evaluator
from coupling_design.wear.performance import performance_of
from coupling_design.wear.quantities import TOTALS
from coupling_design.wear.run_downs import joint_states

pytestmark = pytest.mark.slow

ANGLES = 24
CASES = (
    "16v280.yaml",
    "16v280_catalogue.yaml",
    "16v280_engine.yaml",
    "8l_marine.yaml",
    "small_genset.yaml",
)


def candidate_of(case, found):
    """Return the candidate of an optimum or of a chosen design."""
    coupling_type = next(
        t for t in case.coupling_types if t.name == found.coupling_type
    )
    stiffness = found.performance.torsional_stiffness
    size = None
    if getattr(found, "size", None):
        size = coupling_type.size_of(stiffness)
    option = connection_option(case, ConnectionKind(found.connection))
    return Candidate(coupling_type, option, size)


def each_angle(case, found):
    """Return the performance from each of ANGLES crank angles, gravity's with it."""
    shutdown = dataclasses.replace(case.shutdown, crank_angles=ANGLES)
    turned = dataclasses.replace(case, shutdown=shutdown)
    evaluator = Evaluator(turned, candidate_of(case, found))
    runs = evaluator.run_downs
    point = found.performance.torsional_stiffness, found.performance.key_gap
    columns = runs.variables.columns([point], evaluator.chances)
    starts = runs.starting()(columns, ANGLES).states
    totals = runs.march(joint_states(starts), columns)[-len(TOTALS) :]
    frequency = evaluator.natural_frequency(point[0])
    return [performance_of(*point, frequency, column) for column in totals.T]


def verdicts(case, performances):
    """Return of each load criterion what it says from each crank angle."""
    limits = (*load_constraints(case), *survival_constraints(case))
    return {
        limit.name: {limit.criterion(each).passes for each in performances}
        for limit in limits
    }


def on_record(case, performance):
    """Return the same of the performance that the design was judged by."""
    return verdicts(case, [performance])


@pytest.mark.parametrize("name", CASES)
def test_verdicts_are_the_same_from_each_of_24_crank_angles(shipped, name):
    case = shipped(name)
    outcome = run_design(case)
    judged = (outcome.steps[2].optimum, outcome.chosen or outcome.nearest)
    assert any(judged)
    for found in filter(None, judged):
        over_angles = verdicts(case, each_angle(case, found))
        assert over_angles == on_record(case, found.performance)

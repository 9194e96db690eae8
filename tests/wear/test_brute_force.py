"""The optimiser against a dense grid of the same case."""

import numpy as np
import pytest

from coupling_design.flow.design import silent
from coupling_design.search.program import DesignSpace, Objective
from coupling_design.search.reach import reachable_stiffness
from coupling_design.search.workbench import Workbench, problem, search
from coupling_design.steps.limits import (
    high_frequency_constraint,
    isolation_constraints,
    load_constraints,
)

WITHIN = 1.005


def elastic_limits(case):
    return (*isolation_constraints(case), *load_constraints(case))


def stiff_limits(case):
    return (high_frequency_constraint(case), *load_constraints(case))


@pytest.fixture
def both(candidate):
    """Return the damage that is searched for and the least of a dense grid."""

    def compared(case, names, gaps, limits, n_stiffness, n_gaps=1):
        workbench = Workbench(case, silent)
        coupling = candidate(case, *names)
        span = coupling.coupling_type.stiffness_range
        space = DesignSpace(span, gaps)
        program = problem(workbench, coupling, space, Objective.DAMAGE, limits)
        found = search(workbench, program).performance
        assert program.is_feasible(found)
        low, high = reachable_stiffness(program.evaluator, limits, span)
        points = [
            (stiffness, gap)
            for gap in np.linspace(*gaps, n_gaps)
            for stiffness in np.geomspace(low, high, n_stiffness)
        ]
        grid = program.evaluator.performances(points)
        feasible = [p.damage for p in grid if program.is_feasible(p)]
        assert len(feasible) > len(points) / 4
        return found.damage, min(feasible)

    return compared


def test_an_elastic_coupling_at_the_present_gap(calm, both):
    found, least = both(
        calm, ("rubber", "key"), (1e-4, 1e-4), elastic_limits(calm), 200
    )
    assert found <= WITHIN * least


def test_an_elastic_coupling_with_the_gap_free(calm, both):
    limits = elastic_limits(calm)
    found, least = both(calm, ("rubber", "key"), (2e-5, 1e-4), limits, 40, 6)
    assert found <= WITHIN * least


def test_a_stiff_coupling_shrunk_on(quick, both):
    limits = stiff_limits(quick)
    found, least = both(quick, ("disc pack", "tight_fit"), (0.0, 0.0), limits, 150)
    assert found <= WITHIN * least


def test_a_coupling_that_rattles(quick, both):
    """Rattling roughens damage: a grid finds a better spike here, but no valley."""
    limits = isolation_constraints(quick)
    found, least = both(quick, ("rubber", "key"), (1e-4, 1e-4), limits, 100)
    assert found <= 1.25 * least


@pytest.mark.slow
def test_the_papers_tight_fit(paper, both):
    limits = stiff_limits(paper)
    found, least = both(paper, ("diaphragm", "tight_fit"), (0.0, 0.0), limits, 60)
    assert found <= WITHIN * least


@pytest.mark.slow
def test_the_small_sets_elastic_coupling_with_the_gap_free(shipped, both):
    case = shipped("small_genset.yaml")
    limits = elastic_limits(case)
    found, least = both(case, ("rubber", "key"), (2e-5, 1e-4), limits, 30, 6)
    assert found <= WITHIN * least

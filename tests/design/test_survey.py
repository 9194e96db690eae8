import pytest

from coupling_design.design.constraints import isolation_constraints
from coupling_design.design.problem import DesignSpace, Objective
from coupling_design.design.search import problem
from coupling_design.design.survey import survey


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
    drawn = plane.design_map("rubber, key")
    assert drawn.key_gap == (0.0, 1e-4)
    assert len(drawn.torsional_stiffness) == 10
    assert drawn.damage[1][3] == plane.rows[1][3].damage
    assert drawn.peak_transmission_force[0][2] == (
        plane.rows[0][2].peak_transmission_force
    )

"""K1 in the unit of its bearing's contact: read, converted, or refused."""

import pytest

from coupling_design.case import load_case
from coupling_design.errors import CaseError
from coupling_design.parts.bearing.contact_stress import minimum_load

BALL = "bearings[1].stress_coefficient"
ROLLER = "bearings[0].type=radial_roller"


@pytest.fixture
def load(valid, write):
    return lambda *overrides: load_case(write(valid), overrides)


def test_a_balls_coefficient_is_per_cube_root(load):
    # 100 MPa/N^(1/3): (1500/100)^3 = 3375 N
    case = load(f"{BALL}=100 MPa/N^(1/3)")

    assert case.bearings[1].stress_coefficient == pytest.approx(100e6, rel=1e-12)
    assert minimum_load(case.bearings[1]) == pytest.approx(3375, rel=1e-12)


def test_a_balls_per_square_root_keeps_its_load_limit(load):
    # 30 MPa/N^0.5: (1500/30)^2 = 2500 N
    case = load(f"{BALL}=30 MPa/N^0.5")

    assert minimum_load(case.bearings[1]) == pytest.approx(2500, rel=1e-12)
    assert case.bearings[1].is_a_ball_by_the_line_law


def test_its_unit_is_told_where_values_are_listed(load):
    units = {
        value.path: value.unit for value in load(f"{BALL}=100 MPa/N^(1/3)").provenance
    }

    assert units[BALL] == "Pa/N^(1/3)"
    assert units["bearings[0].stress_coefficient"] == "Pa/N^0.5"


def test_a_rollers_per_cube_root_is_refused_with_the_conversion(load):
    # (1500/100)^3 = 3375 N; 1500/sqrt(3375) = 25.8199 MPa/N^0.5
    with pytest.raises(CaseError) as caught:
        load(ROLLER, "bearings[0].stress_coefficient=100 MPa/N^(1/3)")

    (problem,) = caught.value.problems
    assert "found '100 MPa/N^(1/3)', by the law of a ball's point contact" in problem
    assert "write 25.8199 MPa/N^0.5" in problem


@pytest.mark.parametrize("written", ["0 MPa/N^(1/3)", "-3 MPa/N^0.5", "3", "3 MPa/N"])
def test_other_mistakes_are_named(load, written):
    with pytest.raises(CaseError, match=r"bearings\[1\].stress_coefficient"):
        load(f"{BALL}={written}")

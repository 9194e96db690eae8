from dataclasses import replace

import pytest

from coupling_design.checks.fatigue_limits import fatigue_limits
from coupling_design.parts.bearing.parameters import BearingType, Contact


def test_the_papers_bearing_has_two_limits(paper):
    """S_min/K1: (800/3.62)^2 = 48 838.56 N; C_u: 1230/8.2 (100/205)^0.3 = 120.94 kN."""
    first, second = fatigue_limits(paper)
    assert first.minimum_load == pytest.approx(48_838.56, abs=0.005)
    assert first.C_u == pytest.approx(120.94e3, rel=1e-4)
    assert first.law == "square root, a line contact's law"
    assert (second.minimum_load, second.C_u) == (first.minimum_load, first.C_u)


def test_the_law_is_that_of_the_contact(paper):
    """A ball by the paper's own equation is told of, by the cube root it is not."""
    roller, _ = paper.bearings
    line = replace(roller, type=BearingType.RADIAL_BALL)
    point = replace(line, contact=Contact.POINT)
    first, second = fatigue_limits(replace(paper, bearings=(line, point)))
    assert first.is_a_ball_by_the_line_law
    assert not second.is_a_ball_by_the_line_law
    assert second.law == "cube root, a point contact's law"

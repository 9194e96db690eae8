"""F_min of the shipped bearings: what it was before balls took the cube root."""

from pathlib import Path

import pytest

from coupling_design.case import load_case
from coupling_design.parts.bearing.contact_stress import minimum_load
from coupling_design.parts.bearing.parameters import BearingType, Contact

CASES = Path(__file__).parents[2] / "cases"
# (800/3.62)^2, (800/4.41)^2 and (2000/11.40)^2, twice (1500/23.29)^2
BEFORE = {
    "16v280.yaml": (48_838.56, 48_838.56),
    "8l_marine.yaml": (32_908.10, 30_778.70),
    "small_genset.yaml": (4_148.046, 4_148.046),
}


@pytest.mark.parametrize("name", BEFORE)
def test_the_load_limits_are_those_of_before(name):
    limits = [minimum_load(bearing) for bearing in load_case(CASES / name).bearings]
    assert limits == pytest.approx(BEFORE[name], rel=1e-6)


@pytest.mark.parametrize("name", BEFORE)
def test_every_contact_is_that_of_its_rolling_elements(name):
    for bearing in load_case(CASES / name).bearings:
        is_ball = bearing.type is BearingType.RADIAL_BALL
        assert bearing.contact is (Contact.POINT if is_ball else Contact.LINE)

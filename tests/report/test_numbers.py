import math
from dataclasses import replace

import pytest

from coupling_design.parts.criterion import Criterion, Sense, Verdict
from coupling_design.report.words.damages import damage, damage_e6
from coupling_design.report.words.numbers import change, percent, significant
from coupling_design.report.words.units import (
    as_given,
    display_unit,
    quantity,
    value_and_limit,
)

FORCE = Criterion(
    "F_c", 36130.0, 36120.18, Sense.AT_MOST, "N", Verdict.FAIL, -3e-4, "eq. 7"
)


@pytest.mark.parametrize(
    ("value", "unit", "shown"),
    [
        (36120.18, "N", "36.12 kN"),
        (0.28e-3, "m", "0.2800 mm"),
        (0.0, "m", "0 mm"),
        (192.75e6, "N*m/rad", "192.8 MN*m/rad"),
        (541e3, "N*m/rad", "0.5410 MN*m/rad"),
        (2 * math.pi, "rad/s", "60.00 rpm"),
        (1000 * math.pi / 30, "rad/s", "1000 rpm"),
        (35e3, "N*m", "35.00 kN*m"),
        (188.5618, "Hz", "188.6 Hz"),
        (math.sqrt(2), "", "1.414 -"),
        (11.957, "s", "11.96 s"),
        (-0.0123456, "s", "-0.01235 s"),
    ],
)
def test_quantity_in_its_display_unit(value, unit, shown):
    assert f"{quantity(value, unit)} {display_unit(unit)}" == shown


@pytest.mark.parametrize(
    ("value", "shown"),
    [
        (9.9999, "10.00"),  # rounding carries into the next decade
        (123456.7, "123457"),  # no digit before the point is thrown away
        (1.2346e-7, "1.235e-7"),
        (1.2343e12, "1.234e12"),
        (0.00012343, "0.0001234"),
        (float("inf"), "inf"),
    ],
)
def test_significant_digits(value, shown):
    assert significant(value) == shown


def test_given_values_carry_no_idle_zeros():
    assert as_given(35e3, "N*m") == "35"
    assert as_given(400 * math.pi / 30, "rad/s") == "400"
    assert as_given(2.7e6, "N*m/rad") == "2.7"


def test_damage_has_the_digits_that_stand():
    assert damage(4.0512345e-9, 2) == "4.1e-9"
    assert damage(4.0512345e-9) == "4.05e-9"
    assert damage(4.0512345e-9, 6) == "4.051e-9"  # four are enough for a reader
    assert damage(0.0, 3) == "0"


def test_damage_in_the_papers_unit():
    assert damage_e6(4.05e-9) == "0.00405"
    assert damage_e6(2.3e-9, 2) == "0.0023"


def test_value_and_limit():
    passing = replace(FORCE, value=33926.07, verdict=Verdict.PASS)
    assert value_and_limit(passing) == ("33.93", "<= 36.12")
    assert value_and_limit(FORCE) == ("36.13", "<= 36.12")


def test_a_failing_value_never_looks_like_its_limit():
    near = replace(FORCE, value=36120.9)
    assert value_and_limit(near) == ("36.121", "<= 36.120")
    nearest = replace(FORCE, value=math.nextafter(FORCE.limit, math.inf))
    value, limit = value_and_limit(nearest)
    assert limit != f"<= {value}"


def test_margins():
    assert percent(0.060745) == "+6.07"
    assert percent(-0.4444) == "-44.44"
    assert percent(-1.3333e-5) == "-1e-3"  # a small miss is no zero
    assert percent(0.0) == "0"


def test_small_changes():
    assert change(-2.14e-5) == "-2.1e-5"
    assert change(2.4e-12) == "+2.4e-12"
    assert change(0.0) == "0"

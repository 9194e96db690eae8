"""Quantities as engineers write them, against numbers worked by hand."""

import math

import pytest

from coupling_design.case.values import kinds, units
from coupling_design.case.values.quantity import QuantityError


@pytest.mark.parametrize(
    ("kind", "written", "expected"),
    [
        (kinds.LENGTH, "0.28 mm", 0.28e-3),
        (kinds.LENGTH, "0.28mm", 0.28e-3),
        (kinds.LENGTH, " +.5 in ", 0.0127),
        (kinds.LENGTH, "28e-2 mm", 0.28e-3),
        (kinds.LENGTH, "280 µm", 0.28e-3),  # micro sign
        (kinds.LENGTH, "280 μm", 0.28e-3),  # Greek mu
        (kinds.LENGTH, "280 um", 0.28e-3),
        (kinds.ANGULAR_SPEED, "290 rad/s", 290.0),
        (kinds.ANGULAR_SPEED, "1000 rpm", 1000 * 2 * math.pi / 60),
        (kinds.ANGULAR_SPEED, "1000 rev/min", 104.719755),
        (kinds.ANGLE, "90 deg", math.pi / 2),
        (kinds.ANGLE, "90°", math.pi / 2),
        (kinds.VISCOSITY, "39.6 mm^2/s", 39.6e-6),
        (kinds.VISCOSITY, "39.6 mm²/s", 39.6e-6),
        (kinds.VISCOSITY, "39.6 mm**2/s", 39.6e-6),
        (kinds.VISCOSITY, "39.6 cSt", 39.6e-6),
        (kinds.STIFFNESS, "0.347 MN*m/rad", 347e3),
        (kinds.STIFFNESS, "0.347 MN·m/rad", 347e3),
        (kinds.STIFFNESS, "0.347 MNm/rad", 347e3),
        (kinds.STIFFNESS, "347 kN m/rad", 347e3),
        (kinds.STIFFNESS, "1 kN*m/deg", 180e3 / math.pi),
        (kinds.STIFFNESS, "1e8 N*m/rad", 1e8),
        (kinds.DAMPING, "100 Nm*s/rad", 100.0),
        (kinds.TORQUE, "35 kN*m", 35e3),
        (kinds.TORQUE, "35 kNm", 35e3),
        (kinds.TORQUE, "35 kJ", 35e3),
        (kinds.TORQUE, "-0.6 kN*m", -600.0),
        (kinds.FORCE, "25436.76 N", 25436.76),
        (kinds.INERTIA, "177.65 kg*m^2", 177.65),
        (kinds.PER_LENGTH, "1000 1/mm", 1e6),
        (kinds.STRESS, "800 MPa", 8e8),
        (kinds.STRESS, "800 N/mm^2", 8e8),
        (kinds.STRESS_COEFFICIENT, "3.62 MPa/N^0.5", 3.62e6),
        (kinds.STRESS_COEFFICIENT, "3.62 MPa/N^(1/2)", 3.62e6),
        (kinds.PROBABILITY, "99 %", 0.99),
        (kinds.PROBABILITY, 0.99, 0.99),
        (kinds.NUMBER, 4, 4.0),
        (kinds.NUMBER, "1e8", 1e8),  # YAML leaves it text: no decimal point
        (kinds.TIME, "1e-4 s", 1e-4),
        (kinds.TIME, "0.1 ms", 1e-4),
        (kinds.TIME, "2 min", 120.0),
    ],
)
def test_si_value(kind, written, expected):
    assert kind.parse(written) == pytest.approx(expected, rel=1e-7)


@pytest.mark.parametrize(
    ("kind", "written"),
    [
        (kinds.STIFFNESS, "20 Nms/rad"),  # not the plural of Nm
        (kinds.STIFFNESS, "20 N*ms/rad"),  # newton millisecond
        (kinds.DAMPING, "20 N*m*s"),
        (kinds.TORQUE, "20 N*m/rad"),
        (kinds.ANGLE, "5 %"),
        (kinds.NUMBER, "5 rad"),
        (kinds.ANGULAR_SPEED, "5 1/s"),
        (kinds.ANGULAR_SPEED, "5 Hz"),
        (kinds.FORCE, "5 kg"),
        (kinds.INERTIA, "5 kg/m^2"),
        (kinds.VISCOSITY, "5 Pa*s"),
        (kinds.LENGTH, "5"),
        (kinds.LENGTH, 5),
        (kinds.LENGTH, "1,5 mm"),
        (kinds.LENGTH, "5 + 3 mm"),
        (kinds.LENGTH, "2**9 mm"),
        (kinds.LENGTH, "5 10 mm"),
        (kinds.LENGTH, "1_000 mm"),
        (kinds.LENGTH, "__import__('os') mm"),
        (kinds.LENGTH, "mm"),
        (kinds.LENGTH, ""),
        (kinds.LENGTH, "inf mm"),
        (kinds.LENGTH, "1e308 km"),
        (kinds.LENGTH, "5 m^99999"),
        (kinds.LENGTH, "5 m^(9**99)"),
        (kinds.LENGTH, "5 " + "(" * 500),
        (kinds.LENGTH, math.nan),
        (kinds.NUMBER, math.inf),
        (kinds.NUMBER, 10**400),
        (kinds.NUMBER, True),
        (kinds.NUMBER, None),
        (kinds.NUMBER, b"5"),
    ],
)
def test_refused(kind, written):
    with pytest.raises(QuantityError):
        kind.parse(written)


@pytest.mark.parametrize(
    ("written", "allowed"),
    [
        ("-5 mm", "allowed 0 mm or more"),
        ("-5 kNm/kN", "allowed 0 kNm/kN or more"),
    ],
)
def test_limit_is_told_in_the_unit_written(written, allowed):
    with pytest.raises(QuantityError, match=allowed):
        kinds.LENGTH.non_negative().parse(written)


def test_range_is_told_in_the_unit_written():
    kind = kinds.PROBABILITY.between(0.9, 0.999)
    with pytest.raises(QuantityError, match=r"allowed 90 % to 99\.9 %"):
        kind.parse("100 %")


def test_limits_themselves_are_allowed():
    assert kinds.LENGTH.non_negative().parse("0 mm") == 0.0
    assert kinds.PROBABILITY.between(0.9, 0.999).parse("90 %") == 0.9
    assert kinds.PROBABILITY.between(0.9, 0.999).parse("99.9 %") == 0.999


def test_every_example_can_be_read():
    for name, kind in vars(kinds).items():
        if name.isupper():
            for example in kind.example.split(" or "):
                read = kind.parse(example)
                assert read == getattr(kind, "word", None) or math.isfinite(read)


USUAL = [(si, unit) for si, units_ in units._USUAL.items() for unit in units_]


@pytest.mark.parametrize(("si_unit", "unit"), USUAL)
def test_the_usual_units_are_pint_s(monkeypatch, si_unit, unit):
    numbers = [0.0, -0.28, 1 / 3, 43.7, 1e-12, 6.02e23]
    by_table = [units.to_si(number, unit, si_unit) for number in numbers]
    back_by_table = [units.from_si(number, unit) for number in numbers]
    monkeypatch.setattr(units, "_USUAL", {})
    monkeypatch.setattr(units, "_FACTORS", {})

    assert [units.to_si(number, unit, si_unit) for number in numbers] == by_table
    assert [units.from_si(number, unit) for number in numbers] == back_by_table

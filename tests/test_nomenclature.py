import dataclasses
import inspect
import re
from pathlib import Path

import pint
import pytest

from coupling_design.engine import figures, firing, orders
from coupling_design.engine import parameters as engine
from coupling_design.line import parameters as driveline
from coupling_design.parts.bearing import parameters as bearing

NOMENCLATURE = Path(__file__).parents[1] / "NOMENCLATURE.md"
NOT_PHYSICAL = {"–", "text", "part", "rev"}
UNITS = pint.UnitRegistry()


def tables():
    """Return the unit of each name, by section of NOMENCLATURE.md."""
    sections = NOMENCLATURE.read_text(encoding="utf-8").split("\n## ")[1:]
    return {section.partition("\n")[0]: list(rows(section)) for section in sections}


def rows(section):
    for line in section.splitlines():
        if line.startswith("| `"):
            names, _symbol, unit, _note = line.strip("|").split("|")
            yield from ((name, unit.strip()) for name in re.findall(r"`(\w+)`", names))


def fields(module):
    return [
        pytest.param(field.name, id=f"{name}.{field.name}")
        for name, member in inspect.getmembers(module, dataclasses.is_dataclass)
        for field in dataclasses.fields(member)
    ]


@pytest.mark.parametrize("field", fields(driveline))
def test_driveline_parameter_has_a_row(field):
    assert field in dict(tables()["Driveline"])


@pytest.mark.parametrize("field", fields(bearing))
def test_bearing_parameter_has_a_row(field):
    assert field in dict(tables()["Bearing"])


@pytest.mark.parametrize(
    "field", [f for module in (engine, figures, firing, orders) for f in fields(module)]
)
def test_engine_parameter_has_a_row(field):
    assert field in dict(tables()["Engine"])


@pytest.mark.parametrize("section", tables())
def test_no_name_is_explained_twice(section):
    names = [name for name, _unit in tables()[section]]
    assert sorted(names) == sorted(set(names))


@pytest.mark.parametrize("section", tables())
def test_units_are_si(section):
    units = {unit for _name, unit in tables()[section]} - NOT_PHYSICAL
    factors = {unit: si_factor(unit) for unit in units}
    assert factors == dict.fromkeys(units, pytest.approx(1.0))


def si_factor(unit):
    quantity = UNITS.Quantity(1.0, unit.replace(" ", "*"))
    return quantity.to_base_units().magnitude


@pytest.mark.parametrize(
    ("unit", "factor"), [("mm", 1e-3), ("kN m/rad", 1e3), ("1/min", 1 / 60)]
)
def test_a_unit_outside_si_would_be_seen(unit, factor):
    assert si_factor(unit) == pytest.approx(factor)

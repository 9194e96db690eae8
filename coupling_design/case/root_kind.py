"""A stress per root of force, whose unit says which contact it is of.

A line contact's stress follows the square root of the load, a point contact's the cube
root: rollers have the one, balls the other.
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any

from coupling_design.case.quantity import Kind
from coupling_design.case.units import UnitError, to_si

LINE_UNIT, POINT_UNIT = "Pa/N^0.5", "Pa/N^(1/3)"


class WrittenCoefficient(float):
    """K1 in the SI unit of the root it was written with, a line's or a point's."""

    unit: str = LINE_UNIT


@dataclass(frozen=True)
class RootKind(Kind):
    """A stress per square root of force, or per cube root."""

    def parse(self, written: Any) -> WrittenCoefficient:
        """Return the SI value with its SI unit, or raise `QuantityError`."""
        _, unit = self._split(written)
        own = {field.name: getattr(self, field.name) for field in fields(Kind)}
        si_unit = POINT_UNIT if _is_per_cube_root(unit) else LINE_UNIT
        value = WrittenCoefficient(Kind(**{**own, "unit": si_unit}).parse(written))
        value.unit = si_unit
        return value


def _is_per_cube_root(unit: str) -> bool:
    if not unit or unit.endswith("N^0.5"):  # the usual one, without waiting for pint
        return False
    try:
        return to_si(1.0, unit, POINT_UNIT) is not None
    except UnitError:
        return False

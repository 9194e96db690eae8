"""Numbers with units as engineers write them, turned into SI floats once.

Radians are a dimension of their own here. So `rpm` and `rad/s` are angular speeds
while `Hz` and `1/min` are not (pint's stock registry takes 1 Hz for 1 rad/s), and a
stiffness is told from a torque.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import dataclass, replace
from tokenize import TokenError
from typing import Any

import pint
from pydantic import GetCoreSchemaHandler
from pydantic_core import CoreSchema, PydanticCustomError, core_schema

# No plural or textile units: pint's own list reads Nm as number x metre.
_UNITS = """
kilo- = 1e3 = k-
mega- = 1e6 = M-
giga- = 1e9 = G-
centi- = 1e-2 = c-
milli- = 1e-3 = m-
micro- = 1e-6 = µ- = μ- = u-
metre = [length] = m = meter
second = [time] = s
kilogram = [mass] = kg
radian = [angle] = rad
gram = 1e-3 * kilogram = g
tonne = 1000 * kilogram = t
pound = 0.45359237 * kilogram = lb
inch = 0.0254 * metre = in
foot = 0.3048 * metre = ft
minute = 60 * second = min
hour = 3600 * second = h
newton = kilogram * metre / second ** 2 = N
pound_force = 4.4482216152605 * newton = lbf
pascal = newton / metre ** 2 = Pa
bar = 1e5 * pascal
joule = newton * metre = J
watt = joule / second = W
hertz = 1 / second = Hz
stokes = 1e-4 * metre ** 2 / second = St
degree = 0.017453292519943295 * radian = deg = °
revolution = 6.283185307179586 * radian = rev = turn
rpm = revolution / minute
percent = 0.01 = %
"""

_REGISTRY: pint.UnitRegistry[float] = pint.UnitRegistry(_UNITS.strip().splitlines())

_WRITTEN = re.compile(
    r"\s*(?P<number>[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)(?P<unit>.*)", re.DOTALL
)
_UNIT_CHARACTERS = re.compile(r"[A-Za-zµμ°%·*/^()\d.+\-²³ ]*")
_NEWTON_METRE = re.compile(r"(?<![A-Za-z])([kMGm]?N)m(?![A-Za-z])")

_DIMENSIONS = {
    "m": "a length",
    "s": "a time",
    "kg": "a mass",
    "rad": "an angle",
    "N": "a force",
    "N*m": "a torque or energy",
    "Pa": "a pressure or stress",
    "W": "a power",
    "1/s": "a frequency (not an angular speed)",
    "rad/s": "an angular speed",
    "N*m/rad": "a torsional stiffness",
    "N*m*s/rad": "a torsional damping",
    "N/m": "a stiffness along a line",
    "kg*m^2": "a moment of inertia",
    "m^2/s": "a kinematic viscosity",
    "Pa*s": "a dynamic viscosity",
    "1/m": "a number per length",
    "1/rad": "a number per angle",
    "Pa/N^0.5": "a stress per square root of force",
    "m^2": "an area",
    "m/s": "a speed along a line",
    "": "a plain number",
}


class QuantityError(ValueError):
    """What is wrong with a written quantity, as a sentence without its subject."""


@dataclass(frozen=True)
class Kind:
    """A physical kind: what a value must be, in which SI unit, within which limits.

    Used as pydantic metadata: `Annotated[float, LENGTH]` reads `0.28 mm`. `remark`
    is a sentence that helps who wrote a value out of range.
    """

    name: str
    unit: str
    example: str
    lower: float = -math.inf
    upper: float = math.inf
    excludes_lower: bool = False
    remark: str = ""

    def positive(self) -> Kind:
        """Return this kind restricted to values above zero."""
        return replace(self, lower=0.0, excludes_lower=True)

    def non_negative(self) -> Kind:
        """Return this kind restricted to zero and above."""
        return replace(self, lower=0.0)

    def between(self, lower: float, upper: float) -> Kind:
        """Return this kind restricted to the closed range, in SI."""
        return replace(self, lower=lower, upper=upper)

    def parse(self, written: Any) -> float:
        """Return the SI value of what is written, or raise `QuantityError`."""
        number, unit = self._split(written)
        value = self._convert(number, unit)
        if not math.isfinite(value):
            raise QuantityError(f"allowed are finite numbers, such as {self.example}")
        self._check_range(value, unit)
        return value

    def _split(self, written: Any) -> tuple[float, str]:
        if isinstance(written, bool):
            raise QuantityError(
                f"expected {self.name}, such as {self.example}; "
                "YAML reads yes, no, on and off as true and false"
            )
        if isinstance(written, int | float):
            return float(written), ""
        if not isinstance(written, str):
            raise QuantityError(f"expected {self.name}, such as {self.example}")
        match = _WRITTEN.fullmatch(written)
        if match is None:
            raise QuantityError(
                f"expected {self.name}: a number"
                f"{' and a unit' if self.unit else ''}, such as {self.example}"
            )
        return float(match["number"]), match["unit"].strip()

    def _convert(self, number: float, unit: str) -> float:
        if not unit:
            if not self.unit or not math.isfinite(number):
                return number
            raise QuantityError(
                f"a unit is needed: write {self.name} with its unit, "
                f"such as {self.example}"
            )
        written_unit = _parse_unit(unit, self)
        try:
            converted = _REGISTRY.Quantity(number, written_unit).to(self.unit)
        except pint.DimensionalityError:
            raise QuantityError(self._wrong_dimension(written_unit)) from None
        return float(converted.magnitude)

    def _wrong_dimension(self, unit: pint.Unit) -> str:
        found = _describe_dimension(unit)
        hint = ""
        if self.unit == "rad/s" and found == _DIMENSIONS["1/s"]:
            hint = "; write turns per minute as rpm, or multiply Hz by 2 pi for rad/s"
        if self.unit == "N*m/rad" and found == _DIMENSIONS["N*m"]:
            hint = "; write the angle too"
        return f"that is {found}, expected {self.name}, such as {self.example}{hint}"

    def _check_range(self, value: float, unit: str) -> None:
        too_low = value <= self.lower if self.excludes_lower else value < self.lower
        if not too_low and value <= self.upper:
            return
        lower, upper = (_in_unit(limit, unit) for limit in (self.lower, self.upper))
        if self.upper < math.inf:
            allowed = f"{lower} to {upper}"
        elif self.excludes_lower:
            allowed = f"more than {lower}"
        else:
            allowed = f"{lower} or more"
        remark = f". {self.remark}" if self.remark else ""
        raise QuantityError(f"allowed {allowed}{remark}")

    def __get_pydantic_core_schema__(
        self, source: Any, handler: GetCoreSchemaHandler
    ) -> CoreSchema:
        """Let pydantic read a field annotated with this kind by `parse`."""
        return core_schema.no_info_plain_validator_function(self._validate)

    def _validate(self, written: Any) -> float:
        try:
            return self.parse(written)
        except QuantityError as error:
            raise PydanticCustomError(
                "quantity", "{sentence}", {"sentence": str(error)}
            ) from None


def _parse_unit(text: str, kind: Kind) -> pint.Unit:
    if text.startswith(","):
        raise QuantityError("write the decimal mark as a point, such as 1.5")
    if not _UNIT_CHARACTERS.fullmatch(text):
        raise QuantityError(
            f"'{text}' is not a unit that can be read; "
            f"write {kind.name} as a number and a unit, such as {kind.example}"
        )
    spelled = _NEWTON_METRE.sub(r"(\1*m)", text)
    try:
        return _REGISTRY.parse_units(spelled)
    except pint.UndefinedUnitError as error:
        unknown = ", ".join(f"'{name}'" for name in _names(error.unit_names))
        raise QuantityError(
            f"unknown unit {unknown}; write {kind.name} such as {kind.example}"
        ) from None
    # pint's parser has no error of its own: it fails in any of these ways.
    except (AssertionError, TokenError, ArithmeticError, TypeError, ValueError,
            AttributeError, RecursionError, pint.PintError):  # fmt: skip
        raise QuantityError(
            f"'{text}' is not a unit that can be read; "
            f"write {kind.name} as a number and a unit, such as {kind.example}"
        ) from None


def _names(unit_names: str | tuple[str, ...]) -> Iterator[str]:
    yield from (unit_names,) if isinstance(unit_names, str) else unit_names


def _describe_dimension(unit: pint.Unit) -> str:
    for known, name in _DIMENSIONS.items():
        if _REGISTRY.parse_units(known).dimensionality == unit.dimensionality:
            return name
    return f"of dimension {unit.dimensionality}"


def _in_unit(limit: float, unit: str) -> str:
    """Return an SI limit as the user would write it, in the unit he chose."""
    if not unit:
        return f"{limit:g}"
    chosen = _REGISTRY.parse_units(_NEWTON_METRE.sub(r"(\1*m)", unit))
    si = _REGISTRY.Quantity(1.0, chosen).to_base_units().magnitude
    return f"{limit / si:g} {unit}"

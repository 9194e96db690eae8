"""The units a case file may use.

Radians are a dimension of their own here. So `rpm` and `rad/s` are angular speeds
while `Hz` and `1/min` are not (pint's stock registry takes 1 Hz for 1 rad/s), and a
stiffness is told from a torque.
"""

from __future__ import annotations

import re
from functools import cache
from tokenize import TokenError
from typing import TYPE_CHECKING, cast

if TYPE_CHECKING:
    import pint

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

# What pint makes of the usual units, by SI unit: a case in these alone does not wait
# for pint, which takes a quarter of a design's start. The tests compare each with pint.
_USUAL = {
    "m": {"m": 1.0, "cm": 1e-2, "mm": 1e-3},
    "s": {"s": 1.0, "ms": 1e-3, "min": 60.0},
    "kg": {"kg": 1.0, "t": 1e3},
    "rad": {"rad": 1.0, "deg": 0.017453292519943295},
    "N": {"N": 1.0, "kN": 1e3, "MN": 1e6},
    "N*m": {"N*m": 1.0, "Nm": 1.0, "kN*m": 1e3, "kNm": 1e3, "MN*m": 1e6, "MNm": 1e6},
    "Pa": {"Pa": 1.0, "kPa": 1e3, "MPa": 1e6, "GPa": 1e9, "bar": 1e5, "N/mm^2": 1e6},
    "W": {"W": 1.0, "kW": 1e3, "MW": 1e6},
    "rad/s": {"rad/s": 1.0, "rpm": 0.10471975511965977},
    "N*m/rad": {
        **{"N*m/rad": 1.0, "kN*m/rad": 1e3, "MN*m/rad": 1e6},
        **{"Nm/rad": 1.0, "kNm/rad": 1e3, "MNm/rad": 1e6},
    },
    "N*m*s/rad": {"N*m*s/rad": 1.0, "kN*m*s/rad": 1e3, "Nm*s/rad": 1.0},
    "kg*m^2": {"kg*m^2": 1.0},
    "m^2/s": {"m^2/s": 1.0, "mm^2/s": 1e-6},
    "1/m": {"1/m": 1.0, "1/mm": 1e3},
    "Pa/N^0.5": {"Pa/N^0.5": 1.0, "MPa/N^0.5": 1e6},
    "Pa/N^(1/3)": {"Pa/N^(1/3)": 1.0, "MPa/N^(1/3)": 1e6},
    "": {"%": 0.01},
}
_FACTORS = {unit: value for units in _USUAL.values() for unit, value in units.items()}

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
    "Pa/N^(1/3)": "a stress per cube root of force",
    "m^2": "an area",
    "m/s": "a speed along a line",
    "": "a plain number",
}


class UnitError(ValueError):
    """What is wrong with a written unit."""


def to_si(number: float, unit: str, si_unit: str) -> float | None:
    """Return a number in its SI unit; None if the unit is of another dimension."""
    factor = _USUAL.get(si_unit, {}).get(unit)
    if factor is None and unit in _FACTORS and si_unit in _USUAL:
        return None  # a usual unit of another dimension, told without pint
    si = _convert(number, unit, si_unit) if factor is None else number * factor
    if si is None:
        return None
    # 0.28 mm is 0.00028 m: drop the conversion's rounding, 1e-15 of the value.
    return number if si == number else float(f"{si:.15g}")


def from_si(value: float, unit: str) -> float:
    """Return an SI value in another unit of its dimension."""
    factor = _FACTORS.get(unit)
    if factor is None:
        one = _registry().Quantity(1.0, _parse_unit(unit))
        factor = one.to_base_units().magnitude
    return float(value / factor)


def describe(unit: str) -> str:
    """Return what a unit measures, in words: `a length`."""
    dimension = _parse_unit(unit).dimensionality
    for known, name in _DIMENSIONS.items():
        if _registry().parse_units(known).dimensionality == dimension:
            return name
    return f"of dimension {dimension}"


@cache
def _registry() -> pint.UnitRegistry[float]:
    import pint

    return pint.UnitRegistry(_UNITS.strip().splitlines())


def _convert(number: float, unit: str, si_unit: str) -> float | None:
    """Return what `to_si` does, unrounded, of any unit."""
    import pint

    try:
        return _registry().Quantity(number, _parse_unit(unit)).to(si_unit).magnitude
    except pint.DimensionalityError:
        return None


def _parse_unit(text: str) -> pint.Unit:
    """Return the unit a text names, or raise `UnitError`."""
    import pint

    unreadable = f"'{text}' is not a unit that can be read"
    if not _UNIT_CHARACTERS.fullmatch(text):
        raise UnitError(unreadable)
    try:
        return _registry().parse_units(_NEWTON_METRE.sub(r"(\1*m)", text))
    except pint.UndefinedUnitError as error:
        names = cast("str | tuple[str, ...]", error.unit_names)
        listed = names if isinstance(names, str) else ", ".join(names)
        raise UnitError(f"unknown unit '{listed}'") from None
    # pint's parser has no error of its own: it fails in any of these ways.
    except (
        ArithmeticError,
        AssertionError,
        AttributeError,
        RecursionError,
        TokenError,
        TypeError,
        ValueError,
        pint.PintError,
    ):
        raise UnitError(unreadable) from None

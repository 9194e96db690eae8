"""The stress coefficient K1 of a case file against the type of its bearing."""

from __future__ import annotations

from collections.abc import Iterator

from coupling_design.bearing.contact_stress import point_contact_coefficient
from coupling_design.bearing.parameters import BearingType
from coupling_design.case.kinds import Stress, StressCoefficient
from coupling_design.case.problem import Path, Problem
from coupling_design.case.root_kind import (
    LINE_UNIT,
    POINT_UNIT,
    WrittenCoefficient,
)
from coupling_design.case.values import Values


def coefficient_of(
    written: float, bearing_type: BearingType, minimum_stress: float
) -> float:
    """Return K1 in the unit of the bearing's contact [Pa/N^0.5 or Pa/N^(1/3)].

    A ball bearing's may be written per square root of force: its load limit is then
    that of what was written, which is all the method takes from it.
    """
    unit = written.unit if isinstance(written, WrittenCoefficient) else LINE_UNIT
    if bearing_type is BearingType.RADIAL_BALL and unit == LINE_UNIT:
        return float(point_contact_coefficient(float(written), minimum_stress))
    return float(written)


def check_stress_coefficients(values: Values) -> Iterator[Problem]:
    """Yield a problem for each roller bearing whose K1 is a point contact's."""
    for index in range(values.count("bearings")):
        bearing: Path = ("bearings", index)
        path = (*bearing, "stress_coefficient")
        kind = values.read(BearingType, *bearing, "type")
        written = values.read(StressCoefficient, *path)
        if kind is not BearingType.RADIAL_ROLLER or written is None:
            continue
        if written.unit == POINT_UNIT:
            stress = values.read(Stress, *bearing, "minimum_stress")
            yield Problem(path, _refusal(values.text(*path), float(written), stress))


def _refusal(text: str, coefficient: float, stress: float | None) -> str:
    if stress is None:
        line = "K1 = S_min / F_min^0.5"
    else:
        same = stress / (stress / coefficient) ** 1.5
        line = f"{same / 1e6:.6g} MPa/N^0.5, for the same load limit"
    return (
        f"found '{text}', the law of a ball's point contact; allowed for radial_roller "
        f"is a line contact's, in MPa/N^0.5; write {line}, or correct the type"
    )

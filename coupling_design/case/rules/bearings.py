"""What must hold between the values of one bearing."""

from __future__ import annotations

from collections.abc import Iterator

from coupling_design.case.schema.single_values import Values
from coupling_design.case.text.fault import Path, Problem
from coupling_design.case.values.kinds import (
    STRESS_COEFFICIENT,
    Stress,
    StressCoefficient,
)
from coupling_design.parts.bearing.parameters import BearingType


def check_contacts(values: Values) -> Iterator[Problem]:
    """Yield a roller bearing whose stress coefficient is that of a point contact.

    A ball's may be a line's, as the paper's equation is: it is said in the report.
    """
    for index in range(values.count("bearings")):
        bearing: Path = ("bearings", index)
        path = (*bearing, "stress_coefficient")
        kind = values.read(BearingType, *bearing, "type")
        K_1 = values.read(StressCoefficient, *path)
        if kind is not BearingType.RADIAL_ROLLER or K_1 is None:
            continue
        text = values.text(*path)
        if STRESS_COEFFICIENT.unit_of(text) != STRESS_COEFFICIENT.unit:
            S_min = values.read(Stress, *bearing, "minimum_stress")
            yield Problem(path, _refusal(text, K_1, S_min))


def _refusal(text: str, K_1: float, S_min: float | None) -> str:
    same = "S_min / F_min^0.5"
    if S_min is not None:
        same = f"{S_min / (S_min / K_1) ** 1.5 / 1e6:.6g} MPa/N^0.5, for the same F_min"
    return (
        f"found '{text}', by the law of a ball's point contact; rollers touch in a "
        f"line, allowed is MPa/N^0.5: write {same}, or correct the type"
    )

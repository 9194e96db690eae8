"""A measured cylinder pressure: a CSV file to a `PressureTrace`.

The first line names both columns with their units, the others hold numbers; the crank
angle counts from firing top dead centre, the pressure is absolute:

    crank angle [deg], pressure [bar]
    -360, 1.02
"""

from __future__ import annotations

import csv
import math
import os
import re
from itertools import pairwise
from pathlib import Path

from coupling_design.case.text.file import decode, read_bytes
from coupling_design.case.values.kinds import ANGLE, PRESSURE
from coupling_design.case.values.quantity import Kind, QuantityError
from coupling_design.engine import Cycle, PressureTrace
from coupling_design.errors import CaseError

WIDEST_STEP = math.radians(10.0)
_ROUNDING = 1e-9
_HEADING = re.compile(r"[^\[\]]*\[(?P<unit>[^\[\]]+)\]\s*")
_EXAMPLE = "crank angle [deg], pressure [bar]"


def load_trace(entry: str, case_file: str, cycle: Cycle) -> PressureTrace:
    """Return the trace of a file next to its case, or raise CaseError."""
    location = Path(os.path.normpath(Path(case_file).parent / entry))
    file = str(location)
    rows = _rows(decode(read_bytes(location, file), file), file)
    if not rows:
        raise CaseError([f"{file}:1: the file is empty; begin it with '{_EXAMPLE}'"])
    scales = _scales(*rows[0], file)
    points = [_point(line, cells, scales, file) for line, cells in rows[1:]]
    return _checked(points, cycle, file)


def _rows(text: str, file: str) -> list[tuple[int, list[str]]]:
    """Return the cells of each line that has some, with its number."""
    lines = enumerate(text.splitlines(), start=1)
    kept = [(n, line) for n, line in lines if line.strip() and line.lstrip()[0] != "#"]
    return [(n, _cells(line, n, file)) for n, line in kept]


def _cells(text: str, line: int, file: str) -> list[str]:
    try:
        return next(csv.reader([text], quoting=csv.QUOTE_NONE))
    except csv.Error:
        raise CaseError(
            [f"{file}:{line}: found a field of up to {len(text)} characters, allowed "
             f"are {csv.field_size_limit()}; write a number, such as '-360, 1.02'"]
        ) from None  # fmt: skip


def _scales(line: int, cells: list[str], file: str) -> tuple[float, float]:
    """Return what one of each column's unit is in SI."""
    units = [_HEADING.fullmatch(cell) for cell in cells]
    if len(units) != 2 or None in units:
        raise CaseError(
            [f"{file}:{line}: found '{','.join(cells)}', expected two headings with "
             f"their units, such as '{_EXAMPLE}'"]
        )  # fmt: skip
    angle, pressure = (match["unit"] for match in units if match)
    return _scale(ANGLE, angle, file, line), _scale(PRESSURE, pressure, file, line)


def _scale(kind: Kind, unit: str, file: str, line: int) -> float:
    try:
        return kind.parse(f"1 {unit}")
    except QuantityError as error:
        raise CaseError([f"{file}:{line}: found '[{unit}]', {error}"]) from None


def _point(
    line: int, cells: list[str], scales: tuple[float, float], file: str
) -> tuple[int, float, float]:
    try:
        angle, pressure = map(float, cells)
    except ValueError:
        angle, pressure = math.nan, math.nan
    si = pressure * scales[1]
    if not (math.isfinite(angle) and PRESSURE.lower <= si <= PRESSURE.upper):
        raise CaseError(
            [f"{file}:{line}: found '{','.join(cells)}', expected a crank angle and an "
             "absolute pressure above zero, such as '-360, 1.02'"]
        )  # fmt: skip
    return line, angle * scales[0], si


def _checked(
    points: list[tuple[int, float, float]], cycle: Cycle, file: str
) -> PressureTrace:
    """Return a trace that covers its cycle once, without its repeated end."""
    for (_, before, _), (line, angle, _) in pairwise(points):
        if not 0 < angle - before <= WIDEST_STEP * (1 + _ROUNDING):
            raise CaseError(
                [f"{file}:{line}: the crank angle is {math.degrees(angle - before):g} "
                 "deg after the one before it; allowed is up to 10 deg, and never back"]
            )  # fmt: skip
    span = points[-1][1] - points[0][1] if points else 0.0
    open_end = cycle.angle - span
    if not -_ROUNDING <= open_end <= WIDEST_STEP:
        raise CaseError(
            [f"{file}: the crank angles span {math.degrees(span):g} deg; allowed is "
             f"the whole cycle once, {math.degrees(cycle.angle):g} deg"]
        )  # fmt: skip
    kept = points if open_end > _ROUNDING else points[:-1]
    return PressureTrace(
        angles=tuple(angle for _, angle, _ in kept),
        pressures=tuple(pressure for _, _, pressure in kept),
    )

"""What varies in a sweep, as one writes it: `stiffness=0.5..2x:31`."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from coupling_design.case.edit.overrides import override
from coupling_design.case.edit.places import find_place
from coupling_design.case.load import case_of
from coupling_design.case.text.document import Document
from coupling_design.case.text.fault import dotted
from coupling_design.case.values.kinds import GAP, STIFFNESS
from coupling_design.case.values.quantity import Kind, QuantityError
from coupling_design.errors import CaseError
from coupling_design.explore.grid import Quantity, Values
from coupling_design.explore.points import parse_relative, present_point
from coupling_design.machine.machine import Case
from coupling_design.machine.sourced_value import SourcedValue

STIFFNESS_PATH = "driveline.coupling.torsional_stiffness"
GAP_PATH = "driveline.connection.gap"
_SHORT = {"stiffness": STIFFNESS_PATH, "gap": GAP_PATH}
_COUNT = 11
_NUMBER = r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?"
_RANGE = re.compile(
    rf"\s*(?P<low>{_NUMBER})(?P<low_unit>.*?)\.\.\s*(?P<high>{_NUMBER})(?P<unit>[^:]*)"
    r"(?::(?P<count>\d+)(?P<log>log)?)?\s*"
)
_EXPECTED = (
    "expected a range, 0..0.3mm:7 or 0.5..2x:31 or 1..100 kN*m/rad:9log, "
    "or values between commas"
)


@dataclass(frozen=True)
class Axis:
    """One thing that varies.

    `path` is its place in the case; `quantity` its SI values, `texts` the same as
    written in a case file. `is_design` says that stiffness or gap varies: those need
    no new case, and may leave the range of their type.
    """

    path: str
    quantity: Quantity
    texts: tuple[str, ...]

    @property
    def is_design(self) -> bool:
        """Whether it is a design variable, stiffness or gap."""
        return self.path in (STIFFNESS_PATH, GAP_PATH)


def parse_axes(
    document: Document, case: Case, written: Sequence[str]
) -> tuple[Axis, ...]:
    """Return the axes of a sweep, or raise CaseError with all that is wrong."""
    axes, problems = list[Axis](), list[str]()
    for each in written:
        try:
            axes.append(_axis(document, case, each))
        except (ValueError, QuantityError) as error:
            problems.append(f"{each}: {error}")
        except CaseError as error:
            problems += [p.replace("--set ", "", 1) for p in error.problems]
    paths = [axis.path for axis in axes]
    problems += [
        f"{path} is swept twice" for path in set(paths) if paths.count(path) > 1
    ]
    if problems:
        raise CaseError(problems)
    return tuple(axes)


def _axis(document: Document, case: Case, written: str) -> Axis:
    name, equals, spec = written.partition("=")
    if not equals or not spec.strip():
        raise ValueError(f"{_EXPECTED}, after the name and =")
    name = name.strip()
    path = _SHORT.get(name) or dotted(find_place(name, document))
    if path == STIFFNESS_PATH:
        present = present_point(case).torsional_stiffness
        return _design_axis("stiffness", path, STIFFNESS.positive(), present, spec)
    if path == GAP_PATH:
        if "gap" not in vars(case.driveline.connection):
            raise ValueError("the present tight_fit has no gap to vary")
        return _design_axis("gap", path, GAP, present_point(case).key_gap, spec)
    known = {value.path: value for value in case.provenance}
    texts = _texts(spec, known.get(path))
    values = _values(document, path, texts)
    unit = values[0].unit or ("1" if isinstance(values[0].value, float) else "")
    array: Values = np.array([value.value for value in values])
    return Axis(path, Quantity(path, unit, path, array), texts)


def _design_axis(name: str, path: str, kind: Kind, present: float, spec: str) -> Axis:
    texts = _texts(spec, None)
    array = np.array([parse_relative(text, kind, present) for text in texts])
    meaning = {"stiffness": "dynamic torsional stiffness C_Tdyn", "gap": "key gap"}
    return Axis(path, Quantity(name, kind.unit, meaning[name], array), texts)


def _texts(spec: str, present: SourcedValue | None) -> tuple[str, ...]:
    """Return each value as one would write it; `x` becomes so many times the present.

    Without a present value, it is left to who reads the text.
    """
    texts = _range(spec) if ".." in spec else _list(spec)
    return tuple(_times(text, present) for text in texts)


def _list(spec: str) -> list[str]:
    """Return texts between commas; numbers alone take the unit of the last."""
    texts = [part.strip() for part in spec.split(",") if part.strip()]
    last = re.fullmatch(rf"{_NUMBER}(?P<unit>.*)", texts[-1]) if texts else None
    if last is None:
        return texts
    return [
        text + last["unit"] if re.fullmatch(_NUMBER, text) else text for text in texts
    ]


def _range(spec: str) -> list[str]:
    match = _RANGE.fullmatch(spec)
    if match is None:
        raise ValueError(f"'{spec}' cannot be read; {_EXPECTED}")
    unit, low_unit = match["unit"].strip(), match["low_unit"].strip()
    if low_unit not in ("", unit):
        raise ValueError(f"write both ends in the same unit, not {low_unit} and {unit}")
    count, low, high = int(match["count"] or _COUNT), match["low"], match["high"]
    if count < 1:
        raise ValueError("allowed is 1 value or more")
    ends = float(low), float(high)
    if match["log"]:
        if min(ends) <= 0:
            raise ValueError("a range in equal ratios, log, must lie above zero")
        numbers = np.geomspace(*ends, count)
    else:
        numbers = np.linspace(*ends, count)
    # 0.3 is better than 0.30000000000000004, in files and messages alike.
    return [f"{float(f'{number:.12g}')!r}{unit}" for number in numbers]


def _times(text: str, present: SourcedValue | None) -> str:
    factor = text.removesuffix("x")
    if present is None or factor == text or not re.fullmatch(_NUMBER, factor.strip()):
        return text
    if not isinstance(present.value, float):
        raise QuantityError(f"'{text}': {present.path} is no number")
    return f"{float(factor) * present.value!r} {present.unit}".strip()


def _values(document: Document, path: str, texts: Sequence[str]) -> list[SourcedValue]:
    """Return what a case understands each text to be; all problems at once."""
    found, problems = list[SourcedValue](), list[str]()
    for text in texts:
        try:
            case = case_of(override(document, [f"{path}={text}"]))
        except CaseError as error:
            problems += error.problems
            continue
        plain = SourcedValue(path, text, text, "", None, "")
        values = (value for value in case.provenance if value.path == path)
        found.append(next(values, plain))
    if problems:
        raise CaseError(problems)
    return found

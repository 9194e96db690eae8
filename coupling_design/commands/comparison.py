"""Two sides of a comparison: what each was given, and what each came to."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from coupling_design.errors import CaseError

Shown = float | str | None

# Keys of design.json, with the SI unit of their numbers.
_NAMES = {
    "coupling_type": "",
    "size": "",
    "connection": "",
    "plan": "",
    "torsional_stiffness": "N*m/rad",
    "key_gap": "m",
    "natural_frequency": "Hz",
    "peak_transmission_force": "N",
    "peak_combined_load": "N",
    "damages": "1",
    "damage": "1",
    "damage_reduction": "1",
    "chaotic": "",
}
_PARTS = {"baseline": "present", "chosen": "chosen"}


@dataclass(frozen=True)
class Side:
    """A case or a result.

    Attributes
    ----------
    label : its file
    warnings : what must be read first
    inputs : SI value or word and the text as written, by path; None where a result
        does not record them
    results : value and SI unit, by name
    """

    label: str
    inputs: Mapping[str, tuple[Shown, str]] | None
    results: Mapping[str, tuple[Shown, str]]
    warnings: tuple[str, ...] = ()


@dataclass(frozen=True)
class Difference:
    """One line: what, both sides, the unit, and by how much B differs from A."""

    name: str
    first: Shown
    second: Shown
    unit: str
    change: float | None = None


def read_side(file: str, *, design: bool, size: str | None = None) -> Side:
    """Return what a case (.yaml) or a result (design.json) has to compare.

    A case's present coupling is rolled out, or a size of its catalogue in its place;
    with `design` the whole flow is run.
    """
    if Path(file).suffix == ".json":
        return _of_document(file, _read_result(file))
    from coupling_design.case.echo import echo
    from coupling_design.case.load import case_of, read_document
    from coupling_design.checks.warnings import case_warnings
    from coupling_design.flow.design import run_design
    from coupling_design.report.files.json import build_document

    document = read_document(file)
    case = case_of(document)
    given = (value for value in echo(document) if not value.is_default)
    inputs = {value.path: (value.value, value.text) for value in given}
    if design:
        results = _of_document(file, build_document(run_design(case))).results
        return Side(file, inputs, results, case_warnings(case))
    present, remarks = _present(case, size)
    results = dict(_results({"baseline": present}))
    return Side(file, inputs, results, (*case_warnings(case), *remarks))


def differing_inputs(first: Side, second: Side) -> tuple[Difference, ...] | None:
    """Return the inputs that differ, as written; None where one side has none."""
    if first.inputs is None or second.inputs is None:
        return None
    a, b = dict(first.inputs), dict(second.inputs)
    if {Path(first.label).suffix, Path(second.label).suffix} & {".json"}:
        # A result records the values with a unit or a source only.
        a, b = ({k: v for k, v in x.items() if k in y} for x, y in ((a, b), (b, a)))
    nothing = (None, "")
    return tuple(
        Difference(path, _text(a.get(path)), _text(b.get(path)), "")
        for path in dict.fromkeys((*a, *b))
        if a.get(path, nothing)[0] != b.get(path, nothing)[0]
    )


def compare_results(first: Side, second: Side) -> tuple[Difference, ...]:
    """Return every result of both sides, with its relative change."""
    names = dict.fromkeys((*first.results, *second.results))
    return tuple(_difference(name, first, second) for name in names)


def _difference(name: str, first: Side, second: Side) -> Difference:
    a, unit_a = first.results.get(name, (None, ""))
    b, unit_b = second.results.get(name, (None, ""))
    change = None
    if isinstance(a, float) and isinstance(b, float) and a:
        change = b / a - 1
    return Difference(name, a, b, unit_a or unit_b, change)


def _text(side: tuple[Shown, str] | None) -> str | None:
    return None if side is None else side[1] or str(side[0])


def _present(case: Any, size: str | None) -> tuple[dict[str, Any], tuple[str, ...]]:
    """Return what a case's coupling does, and what is to be said of it."""
    from coupling_design.checks.warnings import run_down_warnings, stop_remark
    from coupling_design.explore.points import find_point
    from coupling_design.wear.conditioning import chaotic
    from coupling_design.wear.evaluator import Evaluator

    point = find_point(case, size=size)
    evaluator = Evaluator(case, point.candidate)
    performance = evaluator.performance(point.torsional_stiffness, point.key_gap)
    real = point.candidate.size
    remark = stop_remark(case, performance)
    told = (
        *run_down_warnings(case, performance, "Present coupling"),
        *([f"Present coupling: {remark}."] if remark else ()),
    )
    return {
        "size": real.name if real else None,
        "chaotic": "yes" if chaotic(evaluator, performance) else None,
        "coupling_type": point.candidate.coupling_type.name,
        "connection": point.candidate.connection.kind.value,
        "damage": performance.damage,
        **vars(performance),
    }, told


def _read_result(file: str) -> dict[str, Any]:
    try:
        document = json.loads(Path(file).read_text(encoding="utf-8"))
    except FileNotFoundError:
        raise CaseError([f"{file}: there is no such file; check the path"]) from None
    except (OSError, ValueError) as error:
        raise CaseError([f"{file}: cannot be read as JSON: {error}"]) from None
    if not isinstance(document, dict) or "baseline" not in document:
        raise CaseError([f"{file}: is no design.json; name the one of a design"])
    return document


def _of_document(file: str, document: Mapping[str, Any]) -> Side:
    recorded = document.get("inputs")
    inputs = recorded and {
        path: (each["value"], each["text"]) for path, each in recorded.items()
    }
    warned = document.get("warnings")
    known = [each for each in warned or () if isinstance(each, str)]
    return Side(file, inputs, dict(_results(document)), tuple(known))


def _results(document: Mapping[str, Any]) -> Iterator[tuple[str, tuple[Shown, str]]]:
    for key, role in _PARTS.items():
        part = document.get(key) or {}
        for name, unit in _NAMES.items():
            value = part.get(name)
            values = value if isinstance(value, list | tuple) else [value]
            for index, each in enumerate(values, start=1):
                if each is not None:
                    number = f" {index}" if len(values) > 1 else ""
                    word = name.replace("damages", "damage").replace("_", " ")
                    label = f"{role}: {word}{number}"
                    shown = each if isinstance(each, str) else float(each)
                    yield label, (shown, unit)

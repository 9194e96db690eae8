"""What must hold between the values of a case file.

Each rule reads the few values it needs straight from the data, so that it still
speaks when something else in the file is wrong; it is silent when they are.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from pydantic import TypeAdapter, ValidationError

from coupling_design.case.case import ConnectionKind
from coupling_design.case.document import Document
from coupling_design.case.kinds import (
    AngularSpeed,
    Gap,
    Number,
    PositiveTorque,
    Stiffness,
    Time,
)
from coupling_design.case.problem import Path, Problem, suggestion
from coupling_design.case.stated import Stated

_GAPPED = (ConnectionKind.KEY, ConnectionKind.SPLINE)
_CONNECTION: Path = ("driveline", "connection")
_SPACE: Path = ("design_space", "connections")
_MOST_STEPS = 10_000_000


class _Values:
    """Reads single values of a document; None where one is absent or wrong."""

    def __init__(self, document: Document) -> None:
        self._document = document

    def raw(self, *path: str | int) -> Any:
        value = self._document.data
        for element in path:
            try:
                value = value[element]
            except (LookupError, TypeError):
                return None
        return value

    def read(self, kind: Any, *path: str | int) -> Any:
        try:
            return TypeAdapter(Stated[kind]).validate_python(self.raw(*path)).value
        except ValidationError:
            return None

    def text(self, *path: str | int) -> str:
        texts = self._document.texts
        return texts.get((*path, "value"), texts.get(path, ""))

    def count(self, *path: str | int) -> int:
        entries = self.raw(*path)
        return len(entries) if isinstance(entries, list) else 0


def check_relations(document: Document) -> Iterator[Problem]:
    """Yield every broken relation whose values can be read."""
    values = _Values(document)
    for rule in (
        _ordered_pairs,
        _unique_entries,
        _shutdown,
        _present_coupling,
        _present_connection,
        _contact_parameters,
        _offered_connections,
    ):
        yield from rule(values)


def _ordered_pairs(values: _Values) -> Iterator[Problem]:
    pairs: list[tuple[Any, Path, Path]] = [
        (
            AngularSpeed,
            ("duty", "working_speed", "lowest"),
            ("duty", "working_speed", "highest"),
        ),
        (PositiveTorque, ("duty", "rated_torque"), ("duty", "peak_torque")),
    ]
    for kind in _GAPPED:
        space = (*_SPACE, kind)
        pairs.append((Gap, (*space, "minimum_gap"), (*space, "maximum_gap")))
    for index in range(values.count("coupling_types")):
        entry: Path = ("coupling_types", index)
        low, high = (*entry, "stiffness", "lowest"), (*entry, "stiffness", "highest")
        pairs.append((Stiffness, low, high))
        low, high = (*entry, "nominal_torque"), (*entry, "maximum_torque")
        pairs.append((PositiveTorque, low, high))
    for kind, lower, upper in pairs:
        small, large = values.read(kind, *lower), values.read(kind, *upper)
        if small is not None and large is not None and small > large:
            yield Problem(
                upper,
                f"found '{values.text(*upper)}', allowed {lower[-1]} "
                f"'{values.text(*lower)}' or more; exchange or correct them",
            )


def _unique_entries(values: _Values) -> Iterator[Problem]:
    yield from _repeated(values, ("driveline", "excitation"), "order", Number)
    yield from _repeated(values, ("coupling_types",), "name", None)
    yield from _repeated(values, ("bearings",), "name", None)


def _repeated(values: _Values, entries: Path, key: str, kind: Any) -> Iterator[Problem]:
    seen: set[Any] = set()
    for index in range(values.count(*entries)):
        path = (*entries, index, key)
        value = values.read(kind, *path) if kind else values.text(*path) or None
        if value in seen:
            yield Problem(
                path,
                f"{key} '{values.text(*path)}' is given twice; "
                "delete one entry or correct it",
            )
        elif value is not None:
            seen.add(value)


def _shutdown(values: _Values) -> Iterator[Problem]:
    path: Path = ("shutdown", "time_step")
    step = values.read(Time, *path)
    duration = values.read(Time, "shutdown", "duration")
    if step is None or duration is None:
        return
    found = f"found '{values.text(*path)}'"
    if step > duration:
        limit = values.text("shutdown", "duration")
        yield Problem(path, f"{found}, allowed at most the duration '{limit}'")
    elif duration / step > _MOST_STEPS:
        yield Problem(
            path,
            f"{found}, which makes {duration / step:.3g} steps; "
            f"allowed {duration / _MOST_STEPS:g} s or more",
        )
    elif abs(round(duration / step) * step - duration) > 1e-6 * duration:
        whole = duration / round(duration / step)
        yield Problem(
            path,
            f"{found}, which does not divide the duration; write {whole:.9g} s",
        )


def _present_coupling(values: _Values) -> Iterator[Problem]:
    path: Path = ("driveline", "coupling", "type")
    present = values.text(*path)
    names = [
        values.text("coupling_types", index, "name")
        for index in range(values.count("coupling_types"))
    ]
    if not present or not names:
        return
    if present not in names:
        yield Problem(
            path,
            f"found '{present}', which is not among the coupling_types; "
            f"{suggestion(present, names)}allowed: {', '.join(names)}",
        )
        return
    entry = ("coupling_types", names.index(present))
    yield from _outside(
        values,
        Stiffness,
        ("driveline", "coupling", "torsional_stiffness"),
        ((*entry, "stiffness", "lowest"), (*entry, "stiffness", "highest")),
        f"the range of coupling type '{present}'",
    )
    yield from _kind_of_type(values, entry, present)


def _kind_of_type(values: _Values, entry: Path, present: str) -> Iterator[Problem]:
    kind = values.read(ConnectionKind, *_CONNECTION, "kind")
    made_with = values.raw(*entry, "connections")
    if kind and isinstance(made_with, list) and kind not in made_with:
        yield Problem(
            (*_CONNECTION, "kind"),
            f"found '{kind}', but coupling type '{present}' is made with: "
            f"{', '.join(map(str, made_with))}; add it there or correct it here",
        )


def _outside(
    values: _Values, kind: Any, path: Path, limits: tuple[Path, Path], range_name: str
) -> Iterator[Problem]:
    value = values.read(kind, *path)
    lower, upper = (values.read(kind, *limit) for limit in limits)
    if None in (value, lower, upper) or lower <= value <= upper or lower > upper:
        return
    low, high = (values.text(*limit) for limit in limits)
    yield Problem(
        path,
        f"found '{values.text(*path)}', allowed {low} to {high}, {range_name}",
    )


def _present_connection(values: _Values) -> Iterator[Problem]:
    kind = values.read(ConnectionKind, *_CONNECTION, "kind")
    path = (*_CONNECTION, "gap")
    if kind is None:
        return
    if kind is ConnectionKind.TIGHT_FIT:
        if values.read(Gap, *path):
            yield Problem(
                path,
                f"found '{values.text(*path)}', but a tight_fit has no gap; "
                "delete the key or change the kind",
            )
        return
    if values.raw(*path) is None:
        yield Problem(
            _CONNECTION, f"missing key 'gap'; a {kind} has one, such as 0.28 mm"
        )
    limits = ((*_SPACE, kind, "minimum_gap"), (*_SPACE, kind, "maximum_gap"))
    yield from _outside(
        values, Gap, path, limits, f"the range of a {kind} in design_space"
    )


def _contact_parameters(values: _Values) -> Iterator[Problem]:
    kind = values.read(ConnectionKind, *_CONNECTION, "kind")
    offered = [option for option in _GAPPED if values.raw(*_SPACE, option) is not None]
    if kind not in _GAPPED and not offered:
        return
    if not isinstance(values.raw(*_CONNECTION), dict):
        return
    reason = (
        f"the present {kind} needs it"
        if kind in _GAPPED
        else f"the {offered[0]} in design_space needs it"
    )
    for key, example in (
        ("contact_stiffness", "1e8 N*m/rad"),
        ("oil_damping", "100 N*m*s/rad"),
        ("smoothing", "1000 1/mm"),
    ):
        if values.raw(*_CONNECTION, key) is None:
            yield Problem(
                _CONNECTION, f"missing key '{key}'; {reason}, such as {example}"
            )


def _offered_connections(values: _Values) -> Iterator[Problem]:
    space = values.raw(*_SPACE)
    if not isinstance(space, dict):
        return
    offered = [kind for kind in ConnectionKind if kind in space]
    if not offered:
        words = ", ".join(ConnectionKind)
        yield Problem(_SPACE, f"offers no connection; write at least one of {words}")
        return
    for index in range(values.count("coupling_types")):
        entry = ("coupling_types", index, "connections")
        for place in range(values.count(*entry)):
            kind = values.read(ConnectionKind, *entry, place)
            if kind and kind not in offered:
                yield Problem(
                    (*entry, place),
                    f"found '{kind}', which design_space.connections does not offer; "
                    f"allowed: {', '.join(offered)}",
                )

"""What the machine has must be among what a case file offers to choose from."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from coupling_design.case.schema.machine import PresentConnection
from coupling_design.case.schema.single_values import Values, check_between
from coupling_design.case.text.fault import Path, Problem, suggestion
from coupling_design.case.values.kinds import Gap, Stiffness
from coupling_design.machine.words import ConnectionKind

_CONNECTION: Path = ("driveline", "connection")
_SPACE: Path = ("design_space", "connections")
GAPPED = (ConnectionKind.KEY, ConnectionKind.SPLINE)


def check_choices(
    values: Values, series: Sequence[str] | None = ()
) -> Iterator[Problem]:
    """Yield what is present but not offered, or offered but not described.

    `series` are the names of the catalogues' series, None if not all could be read.
    """
    yield from _present_coupling(values, series)
    yield from _present_connection(values)
    yield from _contact_parameters(values)
    yield from _offered_connections(values)


def _present_coupling(
    values: Values, series: Sequence[str] | None
) -> Iterator[Problem]:
    path: Path = ("driveline", "coupling", "type")
    present = values.text(*path)
    names = [
        values.text("coupling_types", index, "name")
        for index in range(values.count("coupling_types"))
    ]
    allowed = [*names, *(series or ())]
    if not present or not allowed or present in (series or ()):
        return
    if present not in names and series is None:
        return
    if present not in names:
        among = "coupling_types and series" if series else "coupling_types"
        yield Problem(
            path,
            f"found '{present}', which is not among the {among}; "
            f"{suggestion(present, allowed)}allowed: {', '.join(allowed)}",
        )
        return
    entry = ("coupling_types", names.index(present))
    yield from check_between(
        values,
        Stiffness,
        ("driveline", "coupling", "torsional_stiffness"),
        ((*entry, "stiffness", "lowest"), (*entry, "stiffness", "highest")),
        f"the range of coupling type '{present}'",
    )
    yield from _kind_of_type(values, entry, present)


def _kind_of_type(values: Values, entry: Path, present: str) -> Iterator[Problem]:
    kind = values.read(ConnectionKind, *_CONNECTION, "kind")
    made_with = values.raw(*entry, "connections")
    if kind and made_with and isinstance(made_with, list) and kind not in made_with:
        yield Problem(
            (*_CONNECTION, "kind"),
            f"found '{kind}', but coupling type '{present}' is made with: "
            f"{', '.join(map(str, made_with))}; add it there or correct it here",
        )


def _present_connection(values: Values) -> Iterator[Problem]:
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
    if _lacks(values, "gap"):
        yield Problem(
            _CONNECTION, f"missing key 'gap'; a {kind} has one, such as 0.28 mm"
        )
    limits = ((*_SPACE, kind, "minimum_gap"), (*_SPACE, kind, "maximum_gap"))
    yield from check_between(
        values, Gap, path, limits, f"the range of a {kind} in design_space"
    )


def _lacks(values: Values, key: str) -> bool:
    """Return whether the connection has neither that key nor a misspelling of it."""
    section = values.raw(*_CONNECTION)
    if not isinstance(section, dict):
        return False
    unknown = [
        str(word) for word in section if word not in PresentConnection.model_fields
    ]
    return key not in section and not any(suggestion(word, [key]) for word in unknown)


def _contact_parameters(values: Values) -> Iterator[Problem]:
    kind = values.read(ConnectionKind, *_CONNECTION, "kind")
    offered = [option for option in GAPPED if values.raw(*_SPACE, option) is not None]
    if kind not in GAPPED and not offered:
        return
    reason = (
        f"the present {kind} needs it"
        if kind in GAPPED
        else f"the {offered[0]} in design_space needs it"
    )
    for key, example in (
        ("contact_stiffness", "1e8 N*m/rad"),
        ("oil_damping", "100 N*m*s/rad"),
        ("smoothing", "1000 1/mm"),
    ):
        if _lacks(values, key):
            yield Problem(
                _CONNECTION, f"missing key '{key}'; {reason}, such as {example}"
            )


def _offered_connections(values: Values) -> Iterator[Problem]:
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

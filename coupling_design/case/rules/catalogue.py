"""What must hold between a case file and the catalogues it names."""

from __future__ import annotations

from collections.abc import Iterator

from coupling_design.case.build.catalogue import Catalogues
from coupling_design.case.schema.machine import CaseSection
from coupling_design.case.schema.single_values import Values, check_ordered
from coupling_design.case.text.fault import Path, Problem, suggestion
from coupling_design.case.values.kinds import Inertia, PositiveTorque, Stiffness
from coupling_design.machine.coupling_type import CouplingType
from coupling_design.machine.words import Choice, ConnectionKind

_FILES: Path = ("catalogue",)
_COUPLING: Path = ("driveline", "coupling")


def check_catalogues(values: Values, catalogues: Catalogues) -> Iterator[Problem]:
    """Yield what is wrong between a case and its catalogues."""
    yield from catalogues.problems
    yield from _something_to_choose(values)
    yield from _names(values, catalogues)
    yield from _connections(values, catalogues)
    yield from _duty(values)
    if present := _present_series(values, catalogues):
        yield from _present_size(values, present)
    path: Path = ("design_space", "choose")
    if values.raw(*path) == Choice.CATALOGUE and values.raw(*_FILES) is None:
        yield Problem(
            path,
            "found 'catalogue', but the case names none; write the key catalogue "
            f"with a list of files, or {Choice.OPTIMUM}",
        )


def _something_to_choose(values: Values) -> Iterator[Problem]:
    data = values.raw()
    keys = ("coupling_types", "catalogue")
    if not isinstance(data, dict) or any(key in data for key in keys):
        return
    unknown = [str(key) for key in data if key not in CaseSection.model_fields]
    if not any(suggestion(key, keys) for key in unknown):
        yield Problem(
            (),
            "missing key 'coupling_types'; write a list, each entry with a leading "
            "'- ', or name files of real sizes with the key catalogue",
        )


def _names(values: Values, catalogues: Catalogues) -> Iterator[Problem]:
    count = values.count("coupling_types")
    taken = {values.text("coupling_types", index, "name") for index in range(count)}
    for series in catalogues.types:
        if series.name in taken:
            yield Problem(
                _FILES,
                f"the series '{series.name}' is there twice, in the catalogues or "
                "among the coupling_types; rename or delete one",
            )
        taken.add(series.name)


def _connections(values: Values, catalogues: Catalogues) -> Iterator[Problem]:
    space = values.raw("design_space", "connections")
    if not isinstance(space, dict):
        return
    kinds = [kind for kind in ConnectionKind if kind in space]
    for series in catalogues.types:
        if kinds and not set(kinds) & set(series.connections):
            yield Problem(
                _FILES,
                f"the series '{series.name}' is made with "
                f"{', '.join(series.connections)}, but design_space.connections "
                f"offers {', '.join(kinds)}; offer one of its own there",
            )


def _duty(values: Values) -> Iterator[Problem]:
    duty: Path = ("duty",)
    pairs = [
        (PositiveTorque, (*duty, "peak_torque"), (*duty, "rare_torque")),
        (Inertia, (*_COUPLING, "driving_inertia"), ("driveline", "engine_inertia")),
    ]
    yield from check_ordered(values, pairs)


def _present_series(values: Values, catalogues: Catalogues) -> CouplingType | None:
    present = values.text(*_COUPLING, "type")
    return next((t for t in catalogues.types if t.name == present), None)


def _present_size(values: Values, series: CouplingType) -> Iterator[Problem]:
    """Yield what the present coupling has that its series has not."""
    path: Path = (*_COUPLING, "torsional_stiffness")
    stiffness = values.read(Stiffness, *path)
    low, high = series.stiffness_range
    if stiffness is not None and not low * (1 - 1e-9) <= stiffness <= high * (1 + 1e-9):
        yield Problem(
            path,
            f"found '{values.text(*path)}', allowed {low / 1e6:.6g} to "
            f"{high / 1e6:.6g} MN*m/rad, the sizes of the series '{series.name}'; "
            "correct one of them",
        )
    path = ("driveline", "connection", "kind")
    kind = values.read(ConnectionKind, *path)
    if kind and kind not in series.connections:
        yield Problem(
            path,
            f"found '{kind}', but the series '{series.name}' is made with: "
            f"{', '.join(series.connections)}; correct one of them",
        )

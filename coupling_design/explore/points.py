"""Which coupling of a case, at which stiffness and gap: as one writes it."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, replace

from coupling_design.case.text.fault import suggestion
from coupling_design.case.values.kinds import GAP, STIFFNESS
from coupling_design.case.values.quantity import Kind, QuantityError
from coupling_design.errors import CaseError
from coupling_design.machine.candidate import Candidate
from coupling_design.machine.coupling_type import CouplingType
from coupling_design.machine.machine import Case
from coupling_design.machine.words import ConnectionKind
from coupling_design.steps.present import present_candidate
from coupling_design.steps.so_far import connection_option

_TIMES_PRESENT = re.compile(r"\s*[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?\s*x\s*")


@dataclass(frozen=True)
class Point:
    """A candidate at a torsional stiffness [N m/rad] and a gap [m]."""

    candidate: Candidate
    torsional_stiffness: float
    key_gap: float


def present_point(case: Case) -> Point:
    """Return the coupling the machine has."""
    driveline = case.driveline
    return Point(
        present_candidate(case),
        driveline.coupling.torsional_stiffness,
        getattr(driveline.connection, "gap", 0.0),
    )


def find_point(
    case: Case,
    stiffness: str | None = None,
    gap: str | None = None,
    coupling_type: str | None = None,
    connection: str | None = None,
    size: str | None = None,
) -> Point:
    """Return the present point with what is said otherwise.

    `stiffness` and `gap` are quantities, `12 kN*m/rad`, or times the present value,
    `0.5x`. A size of a catalogue brings its own stiffness, damping and inertias;
    another type has the stiffness of its range nearest to the present one, unless one
    is given. Raises CaseError with all that cannot be understood.
    """
    present, problems = present_point(case), list[str]()
    candidate = present.candidate
    try:
        candidate = _candidate(case, candidate, coupling_type, connection, size)
    except ValueError as error:
        problems.append(str(error))
    values = [_stiffness(candidate, present), present.key_gap]
    if size is not None and stiffness is not None:
        problems.append(f"--stiffness '{stiffness}': the size '{size}' has its own")
    given = (("--stiffness", STIFFNESS.positive(), stiffness), ("--gap", GAP, gap))
    for index, (option, kind, written) in enumerate(given):
        try:
            if written is not None:
                values[index] = parse_relative(written, kind, values[index])
        except QuantityError as error:
            problems.append(f"{option} '{written}': {error}")
    has_gap = candidate.connection.kind is not ConnectionKind.TIGHT_FIT
    if values[1] and not has_gap:
        if gap is not None:
            problems.append(f"--gap '{gap}': a tight_fit has no gap")
        values[1] = 0.0
    if problems:
        raise CaseError(problems)
    if size is None and stiffness is not None:
        # Its own stiffness makes a size of its series again, or none.
        found = candidate.coupling_type.size_of(values[0])
        candidate = replace(candidate, size=found)
    return Point(candidate, *values)


def _stiffness(candidate: Candidate, present: Point) -> float:
    """Return a candidate's stiffness where none is given [N m/rad]."""
    if candidate.size is not None:
        return candidate.size.torsional_stiffness
    if candidate.coupling_type == present.candidate.coupling_type:
        return present.torsional_stiffness
    low, high = candidate.coupling_type.stiffness_range
    return min(max(present.torsional_stiffness, low), high)


def parse_relative(written: str, kind: Kind, present: float) -> float:
    """Return the SI value of a quantity or of so many times the present one."""
    times = _TIMES_PRESENT.fullmatch(written)
    if times is None:
        return kind.parse(written)
    value = float(written.strip().removesuffix("x")) * present
    return kind.parse(f"{value!r} {kind.unit}")


def find_size(case: Case, name: str, series: str | None = None) -> Candidate:
    """Return a size of the case's catalogues in the present kind of connection.

    Where its series is not made with that, in the first it is made with. Raises
    ValueError, with what is allowed, where there is no such size.
    """
    sizes = {
        size.name: (each, size)
        for each in case.coupling_types
        if series in (None, each.name)
        for size in each.sizes
    }
    if name not in sizes:
        near = suggestion(name, sizes)
        allowed = ", ".join(sizes) or "none, the case names no catalogue of that type"
        raise ValueError(f"--size '{name}': {near}allowed: {allowed}")
    each, size = sizes[name]
    kind = case.present_connection
    if kind not in each.connections:
        kind = each.connections[0]
    return Candidate(each, connection_option(case, kind), size)


def _candidate(
    case: Case,
    present: Candidate,
    coupling_type: str | None,
    connection: str | None,
    size: str | None,
) -> Candidate:
    types = {t.name: t for t in case.coupling_types}
    kinds = {option.kind.value: option.kind for option in case.connections}
    if coupling_type is not None and coupling_type not in types:
        near = suggestion(coupling_type, types)
        raise ValueError(f"--type '{coupling_type}': {near}allowed: {', '.join(types)}")
    if connection is not None and connection not in kinds:
        near = suggestion(connection, kinds)
        raise ValueError(
            f"--connection '{connection}': {near}allowed: {', '.join(kinds)}"
        )
    if size is not None:
        found = find_size(case, size, coupling_type)
    elif coupling_type is None or coupling_type == present.coupling_type.name:
        found = present
    else:
        found = _of_type(case, present, types[coupling_type])
    if connection is None:
        return found
    return replace(found, connection=connection_option(case, kinds[connection]))


def _of_type(case: Case, present: Candidate, kind: CouplingType) -> Candidate:
    """Return a type in the present connection, a series at its nearest size."""
    stiffness = case.driveline.coupling.torsional_stiffness
    nearest = min(
        kind.sizes,
        key=lambda size: abs(math.log(size.torsional_stiffness / stiffness)),
        default=None,
    )
    option = present.connection
    if option.kind not in kind.connections:
        option = connection_option(case, kind.connections[0])
    return Candidate(kind, option, nearest)

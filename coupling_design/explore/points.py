"""Which coupling of a case, at which stiffness and gap: as one writes it."""

from __future__ import annotations

import re
from dataclasses import dataclass

from coupling_design.case.case import Case, ConnectionKind
from coupling_design.case.kinds import GAP, STIFFNESS
from coupling_design.case.problem import suggestion
from coupling_design.case.quantity import Kind, QuantityError
from coupling_design.design.baseline import present_candidate
from coupling_design.design.candidate import Candidate
from coupling_design.design.state import connection_option
from coupling_design.errors import CaseError

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
) -> Point:
    """Return the present point with what is said otherwise.

    `stiffness` and `gap` are quantities, `12 kN*m/rad`, or times the present value,
    `0.5x`. Raises CaseError with all that cannot be understood.
    """
    present, problems = present_point(case), list[str]()
    candidate = present.candidate
    try:
        candidate = _candidate(case, candidate, coupling_type, connection)
    except ValueError as error:
        problems.append(str(error))
    values = [present.torsional_stiffness, present.key_gap]
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
    return Point(candidate, *values)


def parse_relative(written: str, kind: Kind, present: float) -> float:
    """Return the SI value of a quantity or of so many times the present one."""
    times = _TIMES_PRESENT.fullmatch(written)
    if times is None:
        return kind.parse(written)
    value = float(written.strip().removesuffix("x")) * present
    return kind.parse(f"{value!r} {kind.unit}")


def _candidate(
    case: Case, present: Candidate, coupling_type: str | None, connection: str | None
) -> Candidate:
    types = {t.name: t for t in case.coupling_types}
    kinds = {option.kind.value: option.kind for option in case.connections}
    name = coupling_type or present.coupling_type.name
    kind = connection or present.connection.kind.value
    if name not in types:
        near = suggestion(name, types)
        raise ValueError(f"--type '{name}': {near}allowed: {', '.join(types)}")
    if kind not in kinds:
        near = suggestion(kind, kinds)
        raise ValueError(f"--connection '{kind}': {near}allowed: {', '.join(kinds)}")
    return Candidate(types[name], connection_option(case, kinds[kind]))

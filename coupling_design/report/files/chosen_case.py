"""The chosen design as a case of its own, which runs again to the same numbers."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from coupling_design import __version__
from coupling_design.case.edit.text import changed_text, exact_text, moved, quoted
from coupling_design.case.load import case_of, read_document
from coupling_design.case.text.document import Document, parse_text
from coupling_design.case.values.kinds import GAP, INERTIA, STIFFNESS
from coupling_design.case.values.quantity import Kind
from coupling_design.errors import CaseError, DesignError
from coupling_design.flow.outcome import ChosenDesign, DesignOutcome
from coupling_design.line.parameters import Driveline
from coupling_design.machine.candidate import Candidate, candidate_driveline
from coupling_design.machine.coupling_size import CouplingSize
from coupling_design.machine.machine import Case
from coupling_design.machine.words import ConnectionKind
from coupling_design.steps.so_far import connection_option

_DRIVELINE = "driveline"
_STIFFNESS = f"{_DRIVELINE}.coupling.torsional_stiffness"
_GAP = f"{_DRIVELINE}.connection.gap"


def chosen_case_text(outcome: DesignOutcome, directory: Path) -> str:
    """Return the case of an outcome's chosen design, as a file in a directory.

    Everything but coupling, connection and overridden values stays as the user wrote
    it. Raises DesignError, with the reason, if that cannot be done exactly.
    """
    case, chosen = outcome.case, outcome.chosen
    if chosen is None:
        raise DesignError(f"{case.file}: no design was chosen")
    try:
        document = read_document(case.file)
        text = Path(case.file).read_text(encoding="utf-8-sig")
    except (CaseError, OSError) as error:
        raise DesignError(str(error)) from None
    if document.sha256 != case.sha256:
        raise DesignError(f"{case.file}: was changed during the run")
    changes = (*case.overrides, *moved(document, directory))
    changes += tuple(_changes(case, chosen, document))
    written = _heading(case, chosen) + changed_text(text, document, changes)
    file = str(directory / "chosen.yaml")
    try:
        again = case_of(parse_text(written, file))
    except CaseError as error:
        raise DesignError(f"the chosen design is no valid case: {error}") from None
    if again.driveline != _chosen_driveline(case, chosen):
        raise DesignError("a case file cannot say what the chosen design is")
    return written


def _heading(case: Case, chosen: ChosenDesign) -> str:
    size = f", size {chosen.size}" if chosen.size else ""
    lines = [
        f"The design that coupling_design {__version__} chose for {case.file}",
        f"(sha256 {case.sha256}):",
        f"{chosen.coupling_type}{size}, {chosen.connection.replace('_', ' ')}.",
        *(f"Overridden there: --set {each}" for each in case.overrides),
    ]
    return "".join(f"# {line}\n" for line in lines) + "\n"


def _changes(case: Case, chosen: ChosenDesign, document: Document) -> Iterator[str]:
    """Yield what makes the chosen design the present one."""
    design = chosen.performance
    stiffness, gap = float(design.torsional_stiffness), float(design.key_gap)
    connection = f"{_DRIVELINE}.connection"
    yield f"{_DRIVELINE}.coupling.type={quoted(chosen.coupling_type)}"
    about = f"chosen, {stiffness / 1e6:.4g} MN*m/rad"
    yield _stated(_STIFFNESS, stiffness, STIFFNESS, document, about)
    kind = f"{{value: {chosen.connection}, source: derived, note: chosen}}"
    yield f"{connection}.kind={kind}"
    if chosen.connection != ConnectionKind.TIGHT_FIT:
        yield _stated(_GAP, gap, GAP, document, "chosen")
    elif document.raw(("driveline", "connection", "gap")) is not None or any(
        each.startswith(f"{_GAP}=") for each in case.overrides
    ):
        yield f"{_GAP}="
    if chosen.size:
        yield from _inertias(case, chosen, document)


def _inertias(case: Case, chosen: ChosenDesign, document: Document) -> Iterator[str]:
    """Yield the inertias that a size of a catalogue brings."""
    size, driveline = _size(case, chosen), _chosen_driveline(case, chosen)
    about = f"with size {chosen.size}"
    for name in ("engine_inertia", "coupling_inertia"):
        value = float(getattr(driveline, name))
        if value != getattr(case.driveline, name):
            yield _stated(f"{_DRIVELINE}.{name}", value, INERTIA, document, about)
    if size and size.driving_inertia and case.present_driving_inertia is not None:
        path = f"{_DRIVELINE}.coupling.driving_inertia"
        yield _stated(path, size.driving_inertia, INERTIA, document, about)


def _stated(path: str, value: float, kind: Kind, document: Document, note: str) -> str:
    written = document.text(tuple(path.split(".")))
    text = exact_text(value, kind, written)
    return f"{path}={{value: {text}, source: derived, note: {quoted(note)}}}"


def _chosen_driveline(case: Case, chosen: ChosenDesign) -> Driveline:
    kind = next(t for t in case.coupling_types if t.name == chosen.coupling_type)
    option = connection_option(case, ConnectionKind(chosen.connection))
    candidate = Candidate(kind, option, _size(case, chosen))
    design = chosen.performance
    return candidate_driveline(
        case, candidate, float(design.torsional_stiffness), float(design.key_gap)
    )


def _size(case: Case, chosen: ChosenDesign) -> CouplingSize | None:
    kind = next(t for t in case.coupling_types if t.name == chosen.coupling_type)
    return next((size for size in kind.sizes if size.name == chosen.size), None)

"""The catalogues a case names: YAML files of real sizes, to series of couplings."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path as FilePath
from typing import Any

from coupling_design.case.build.coupling import build_damping_law
from coupling_design.case.schema.catalogue import (
    CatalogueSection,
    SeriesSection,
    SizeSection,
)
from coupling_design.case.schema.single_values import (
    Values,
    check_ordered,
    check_unique,
)
from coupling_design.case.schema.validation import check_form
from coupling_design.case.text.document import Document, parse_text
from coupling_design.case.text.fault import Path, Problem
from coupling_design.case.text.file import decode, read_bytes
from coupling_design.case.values.kinds import PositiveTorque
from coupling_design.errors import CaseError
from coupling_design.machine.coupling_size import CatalogueFile, CouplingSize
from coupling_design.machine.coupling_type import CouplingType
from coupling_design.machine.sourced_value import SourcedValue
from coupling_design.machine.words import Source


@dataclass(frozen=True)
class Catalogues:
    """What the catalogues of a case hold, and what is wrong with them.

    `problems` stand in the case's own list of files, `sentences` in the files.
    """

    types: tuple[CouplingType, ...] = ()
    files: tuple[CatalogueFile, ...] = ()
    provenance: tuple[SourcedValue, ...] = ()
    problems: tuple[Problem, ...] = ()
    sentences: tuple[str, ...] = ()

    @property
    def is_sound(self) -> bool:
        """Whether everything could be read."""
        return not self.problems and not self.sentences


NO_CATALOGUES = Catalogues()


def load_catalogues(document: Document) -> Catalogues:
    """Return the catalogues that a case's document names, next to its own file."""
    entries = document.raw(("catalogue",))
    found = NO_CATALOGUES
    for index, entry in enumerate(entries if isinstance(entries, list) else ()):
        if isinstance(entry, str) and entry:
            found = _joined(found, _load(document.file, entry, ("catalogue", index)))
    return found


def _load(case_file: str, entry: str, path: Path) -> Catalogues:
    location = FilePath(os.path.normpath(FilePath(case_file).parent / entry))
    file = str(location)
    try:
        content = read_bytes(location, file)
        document = parse_text(decode(content, file), file)
    except CaseError as error:
        if location.is_file():
            return Catalogues(sentences=tuple(error.problems))
        sentence = (
            f"found '{entry}', but there is no file '{file}'; "
            "write its path as seen from the case file"
        )
        return Catalogues(problems=(Problem(path, sentence),))
    section, sentences = check_form(document, CatalogueSection, _relations(document))
    if section is None or sentences:
        return Catalogues(sentences=tuple(sentences))
    return Catalogues(
        types=tuple(_series_type(series) for series in section.series),
        files=(CatalogueFile(file, hashlib.sha256(content).hexdigest(), section.name),),
        provenance=tuple(_provenance(series) for series in section.series),
    )


def _joined(before: Catalogues, more: Catalogues) -> Catalogues:
    return Catalogues(
        before.types + more.types,
        before.files + more.files,
        before.provenance + more.provenance,
        before.problems + more.problems,
        before.sentences + more.sentences,
    )


def _relations(document: Document) -> Iterator[Problem]:
    """Yield what is wrong between the values of one catalogue."""
    values = Values(document)
    yield from check_unique(values, ("series",), "name")
    for series in range(values.count("series")):
        sizes: Path = ("series", series, "sizes")
        yield from check_unique(values, sizes, "name")
        pairs: list[tuple[Any, Path, Path]] = []
        for index in range(values.count(*sizes)):
            nominal, maximum, rare = (
                (*sizes, index, key)
                for key in ("nominal_torque", "maximum_torque", "rare_maximum_torque")
            )
            pairs += [(PositiveTorque, nominal, maximum)]
            pairs += [(PositiveTorque, maximum, rare)]
        yield from check_ordered(values, pairs)


def _series_type(series: SeriesSection) -> CouplingType:
    sizes = tuple(_size(series, size) for size in series.sizes)
    empty = CouplingType(
        name=series.name,
        description=series.description,
        plan=series.plan,
        nominal_torque=0.0,
        maximum_torque=0.0,
        maximum_speed=0.0,
        stiffness_range=(0.0, 0.0),
        damping_law=build_damping_law(series.damping),
        connections=series.connections,
    )
    return empty.with_sizes(sizes)


def _size(series: SeriesSection, size: SizeSection) -> CouplingSize:
    said = size.model_dump(exclude={"damping", "source", "note"})
    return CouplingSize(
        **said,
        series=series.name,
        kind=series.type,
        damping_law=build_damping_law(size.damping or series.damping),
        source=(size.source or series.source).value,
        note=size.note or series.note,
    )


def _provenance(series: SeriesSection) -> SourcedValue:
    """Return one line for a series; its weakest size says where it comes from."""
    sources = [size.source or series.source for size in series.sizes]
    judged = (Source.INVENTED, Source.ASSUMED, Source.FITTED)
    weakest = next((source for source in judged if source in sources), series.source)
    names = ", ".join(size.name for size in series.sizes)
    return SourcedValue(
        path=f"catalogue.{series.name}",
        text=f"{len(series.sizes)} sizes",
        value=names,
        unit="",
        source=weakest,
        note=series.note,
    )


def offered(coupling_type: CouplingType, kinds: set[str]) -> CouplingType:
    """Return a type with those of its connections that a case offers."""
    left = tuple(kind for kind in coupling_type.connections if kind in kinds)
    return replace(coupling_type, connections=left)

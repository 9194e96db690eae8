"""A case file to a `Case`: text -> data -> checked section -> case."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from coupling_design.case.build.catalogue import (
    NO_CATALOGUES,
    Catalogues,
    load_catalogues,
)
from coupling_design.case.build.machine import build_case
from coupling_design.case.build.provenance import list_provenance
from coupling_design.case.edit.overrides import override
from coupling_design.case.rules.machine import check_relations
from coupling_design.case.schema.machine import CaseSection
from coupling_design.case.schema.validation import check_form
from coupling_design.case.text.document import Document, parse_text
from coupling_design.case.text.file import decode, read_bytes
from coupling_design.errors import CaseError
from coupling_design.machine.machine import Case


def load_case(path: str | os.PathLike[str], overrides: Sequence[str] = ()) -> Case:
    """Return the case a YAML file describes, with the catalogues it names.

    Parameters
    ----------
    path : of the file
    overrides : values that replace the file's, each `connection.gap=0.1 mm`

    Raises
    ------
    CaseError
        With every problem of the file and its catalogues, each with its line.
    """
    return case_of(override(read_document(path), overrides))


def read_document(path: str | os.PathLike[str]) -> Document:
    """Return a file's content, not yet validated; raise CaseError if it is no YAML."""
    file = os.fspath(path)
    content = read_bytes(Path(path), file)
    document = parse_text(decode(content, file), file)
    return replace(document, sha256=hashlib.sha256(content).hexdigest())


def case_of(document: Document) -> Case:
    """Return the case a document describes, or raise CaseError with every problem."""
    catalogues = load_catalogues(document)
    section = validate(document, catalogues)
    provenance = (*list_provenance(section, document), *catalogues.provenance)
    case = build_case(section, document.file, document.sha256, provenance, catalogues)
    return replace(case, overrides=tuple(document.overrides.values()))


def validate(document: Document, catalogues: Catalogues = NO_CATALOGUES) -> CaseSection:
    """Return the document's content in the shape of a case, or raise CaseError."""
    section, sentences = check_form(
        document, CaseSection, check_relations(document, catalogues)
    )
    if sentences or catalogues.sentences or section is None:
        raise CaseError([*sentences, *catalogues.sentences])
    return section

"""A case file to a `Case`: text -> data -> checked section -> case."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from coupling_design.case.build import build_case
from coupling_design.case.case import Case
from coupling_design.case.document import Document, parse_text
from coupling_design.case.messages import problems_of
from coupling_design.case.problem import Path as DataPath
from coupling_design.case.problem import Problem, dotted
from coupling_design.case.provenance import list_provenance
from coupling_design.case.relations import check_relations
from coupling_design.case.schema import CaseSection
from coupling_design.errors import CaseError


def load_case(path: str | os.PathLike[str]) -> Case:
    """Return the case a YAML file describes.

    Raises
    ------
    CaseError
        With every problem of the file, each with its line.
    """
    file = os.fspath(path)
    content = _read(Path(path), file)
    document = parse_text(_decode(content, file), file)
    section = validate(document)
    provenance = list_provenance(section, document)
    return build_case(section, file, hashlib.sha256(content).hexdigest(), provenance)


def validate(document: Document) -> CaseSection:
    """Return the document's content in the shape of a case, or raise CaseError."""
    if not isinstance(document.data, dict):
        keys = ", ".join(CaseSection.model_fields)
        raise CaseError(
            [f"{document.file}:{document.line(())}: the file holds no mapping; "
             f"expected the keys {keys}"]
        )  # fmt: skip
    problems = [*document.problems]
    section: CaseSection | None = None
    try:
        section = CaseSection.model_validate(document.data)
    except ValidationError as error:
        problems += problems_of(error, CaseSection, document)
    told = {problem.path for problem in problems}
    empty = _empty_values(document.data, ())
    problems += [problem for problem in empty if problem.path not in told]
    problems += check_relations(document)
    if problems or section is None:
        raise CaseError(_sentences(problems, document))
    return section


def _read(path: Path, file: str) -> bytes:
    try:
        if path.is_dir():
            raise CaseError([f"{file}: is a directory; name the case file in it"])
        return path.read_bytes()
    except FileNotFoundError:
        raise CaseError([f"{file}: there is no such file; check the path"]) from None
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or error
        raise CaseError([f"{file}: cannot be read: {reason}"]) from None


def _decode(content: bytes, file: str) -> str:
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = content.count(b"\n", 0, error.start) + 1
        found = content[error.start]
        raise CaseError(
            [f"{file}:{line}: not UTF-8: found the byte 0x{found:02x}; "
             "save the file as UTF-8 text"]
        ) from None  # fmt: skip


def _empty_values(data: Any, path: DataPath) -> Iterator[Problem]:
    if data is None:
        yield Problem(path, "found nothing; write a value or delete the key")
    elif isinstance(data, dict):
        for key, value in data.items():
            yield from _empty_values(value, (*path, key))
    elif isinstance(data, list):
        for index, value in enumerate(data):
            yield from _empty_values(value, (*path, index))


def _sentences(problems: list[Problem], document: Document) -> list[str]:
    """Return the problems as the user reads them, in the order of the file."""
    located = {
        (
            problem.line or document.line(problem.path),
            f"{dotted(problem.path)}: " if problem.path else "",
            problem.sentence,
        )
        for problem in problems
    }
    return [
        f"{document.file}:{line}: {path}{sentence}"
        for line, path, sentence in sorted(located)
    ]

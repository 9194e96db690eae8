"""Values from the command line in place of the file's."""

from __future__ import annotations

import copy
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from coupling_design.case.edit.places import find_place
from coupling_design.case.text.document import Document, parse_text
from coupling_design.case.text.fault import Path, dotted
from coupling_design.errors import CaseError


def override(document: Document, assignments: Sequence[str]) -> Document:
    """Return a document with some of its values replaced.

    Parameters
    ----------
    document : as read from a file
    assignments : each `path=value`; the path in full or as much of its end as tells
        it from all others, the value as one would write it in the file; no value
        takes the key out

    Raises
    ------
    CaseError
        With every assignment that cannot be understood. Values are not validated.
    """
    if not assignments or not isinstance(document.data, dict):
        return document
    document = replace(
        document,
        data=copy.deepcopy(document.data),
        lines=dict(document.lines),
        texts=dict(document.texts),
        overrides=dict(document.overrides),
    )
    problems: list[str] = []
    for assignment in assignments:
        try:
            _assign(document, assignment)
        except ValueError as error:
            problems.append(f"--set {assignment}: {error}")
    if problems:
        raise CaseError(problems)
    return document


def parse_assignment(assignment: str, document: Document) -> tuple[Path, str]:
    """Return the place an assignment means and the value as written, or ValueError."""
    name, equals, text = assignment.partition("=")
    if not equals or not name.strip():
        raise ValueError("expected path=value, such as connection.gap=0.1mm")
    return find_place(name, document), text.strip()


def _assign(document: Document, assignment: str) -> None:
    path, text = parse_assignment(assignment, document)
    _forget(document, path)
    holder = _holder(document, path)
    if text:
        value = _value(text)
        holder[path[-1]] = value.data
        document.texts.update({(*path, *p): t for p, t in value.texts.items()})
    elif isinstance(path[-1], int):
        raise ValueError("an entry of a list cannot be taken out; write its value")
    else:
        holder.pop(path[-1], None)
    document.overrides.pop(path, None)  # a second one counts as written last
    document.overrides[path] = f"{dotted(path)}={text}"


def _value(text: str) -> Document:
    try:
        value = parse_text(text, "")
    except CaseError as error:
        said = error.problems[0].removeprefix(":1: ")
        raise ValueError(f"the value cannot be read: {said}") from None
    if value.problems:
        raise ValueError(value.problems[0].sentence)
    return value


def _forget(document: Document, path: Path) -> None:
    """Drop what is known of all that stands at a path."""
    for known in (document.texts, document.overrides):
        for inner in [p for p in known if p[: len(path)] == path]:
            del known[inner]


def _holder(document: Document, path: Path) -> Any:
    """Return the mapping or list that holds a path; make it if there is none."""
    holder = document.data
    for element in path[:-1]:
        inner = holder.get(element) if isinstance(holder, dict) else holder[element]
        if not isinstance(inner, dict | list):
            inner = holder[element] = {}
        holder = inner
    return holder

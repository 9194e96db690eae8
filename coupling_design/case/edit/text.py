"""A case file with other values in it: its comments, order and units stay."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Sequence
from contextlib import suppress
from pathlib import Path as FilePath
from typing import Any

import yaml

from coupling_design.case.edit.overrides import override, parse_assignment
from coupling_design.case.edit.places import list_places
from coupling_design.case.text.document import Document, parse_text
from coupling_design.case.text.fault import Path, dotted
from coupling_design.case.text.nodes import compose
from coupling_design.case.values.quantity import Kind
from coupling_design.case.values.units import from_si
from coupling_design.errors import CaseError

_FILES = ("catalogue", "driveline.excitation.pressure_trace")


def changed_text(text: str, document: Document, assignments: Sequence[str]) -> str:
    """Return a case file's text with some values changed.

    Parameters
    ----------
    text, document : the file, as text and as read from it
    assignments : each `path=value`, as for `overrides.override`

    Notes
    -----
    Only the values are exchanged in the text. Where that does not lead to the data it
    should, the data are written out instead, without the comments.
    """
    wanted = document
    for assignment in assignments:
        path, value = parse_assignment(assignment, wanted)
        wanted = override(wanted, [assignment])
        with suppress(yaml.YAMLError, ValueError):  # no YAML now: written out below
            text = _with(text, path, value) if value else _without(text, path)
    if _read(text) == wanted.data:
        return text
    return yaml.safe_dump(wanted.data, sort_keys=False, allow_unicode=True)


def moved(document: Document, directory: FilePath) -> tuple[str, ...]:
    """Return the assignments that keep a case's files found from another directory."""
    home = FilePath(document.file).parent
    return tuple(
        f"{dotted(path)}={quoted(_seen_from(directory, home / document.text(path)))}"
        for path in list_places(document)
        if dotted(path).partition("[")[0] in _FILES and document.text(path)
    )


def exact_text(value: float, kind: Kind, like: str) -> str:
    """Return a quantity that reads back to the last bit, in the unit of another text.

    In SI where no number in that unit does.
    """
    unit = like.strip().lstrip("+-0123456789.eE").strip() or kind.unit
    for digits in range(6, 18):
        text = f"{from_si(value, unit):.{digits}g} {unit}"
        if kind.parse(text) == value:
            return text
    return f"{value!r} {kind.unit}"


def quoted(text: str) -> str:
    """Return a text as YAML reads it back, in single quotes unless it is plain."""
    if re.fullmatch(r"[A-Za-z][\w ./-]*", text) and yaml.safe_load(text) == text:
        return text
    return "'" + text.replace("'", "''") + "'"


def _seen_from(directory: FilePath, file: FilePath) -> str:
    try:
        return FilePath(os.path.relpath(file, directory)).as_posix()
    except ValueError:  # another drive
        return str(file.absolute())


def _read(text: str) -> Any:
    try:
        return parse_text(text, "").data
    except CaseError:
        return None


def _with(text: str, path: Path, value: str) -> str:
    """Return a text with a value in place of what stands at a path, or added there."""
    known = 0
    node: Any = compose(text)
    for element in path:
        inner = _inside(node, element)
        if inner is None:
            break
        node, known = inner, known + 1
    if known == len(path):
        return text[: node.start_mark.index] + value + text[_end(node) :]
    for element in reversed(path[known + 1 :]):
        value = f"{{{element}: {value}}}"
    return _added(text, node, path[known], value)


def _added(text: str, node: yaml.Node, key: str | int, value: str) -> str:
    """Return a text with a key before the others of a mapping."""
    if not isinstance(node, yaml.MappingNode):
        return text
    at = node.start_mark.index
    if node.flow_style:
        comma = ", " if node.value else ""
        return f"{text[: at + 1]}{key}: {value}{comma}{text[at + 1 :]}"
    return f"{text[:at]}{key}: {value}\n{' ' * node.start_mark.column}{text[at:]}"


def _without(text: str, path: Path) -> str:
    node = compose(text)
    for element in path[:-1]:
        node = _inside(node, element)
    if not isinstance(node, yaml.MappingNode):
        return text
    for key, value in node.value:
        if key.value == path[-1]:
            rest = text[_end(value) :]
            before = text[: key.start_mark.index]
            if node.flow_style:
                rest = rest.lstrip(" ").removeprefix(",").lstrip(" ")
            elif not rest.partition("\n")[0].strip():  # nothing else on its line
                before, rest = before.rstrip(" "), rest.partition("\n")[2]
            return before + rest
    return text


def _inside(node: yaml.Node | None, element: str | int) -> yaml.Node | None:
    return next((value for key, value in _entries(node) if key == element), None)


def _entries(node: yaml.Node | None) -> Iterator[tuple[str | int, yaml.Node]]:
    if isinstance(node, yaml.MappingNode):
        yield from ((str(key.value), value) for key, value in node.value)
    elif isinstance(node, yaml.SequenceNode):
        yield from enumerate(node.value)


def _end(node: yaml.Node) -> int:
    """Return where a node's own text ends, without blank lines and comments after."""
    entries = [value for _, value in _entries(node)]
    if entries and not getattr(node, "flow_style", False):
        return _end(entries[-1])
    end: int = node.end_mark.index
    if getattr(node, "style", None) in ("|", ">"):
        end -= 1  # the line's end is the next one's
    return end

"""YAML text to data, with the line of every key, value and duplicate."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

import yaml

from coupling_design.case.text.fault import Path, Problem
from coupling_design.case.text.misreadings import misread, without_merge_keys
from coupling_design.case.text.nodes import compose, construct
from coupling_design.errors import CaseError


@dataclass(frozen=True)
class Document:
    """A case file as read: plain data, where each part stands, and its text.

    `lines` has the line of each path's key (of a list's entry: its first line),
    `texts` each scalar as written, `sha256` is the file's. `overrides` has, by path,
    each `path=value` that replaced what the file says.
    """

    file: str
    data: Any
    lines: dict[Path, int] = field(default_factory=dict)
    texts: dict[Path, str] = field(default_factory=dict)
    problems: tuple[Problem, ...] = ()
    sha256: str = ""
    overrides: dict[Path, str] = field(default_factory=dict)

    def override(self, path: Path) -> str | None:
        """Return the `path=value` that a value comes from; None: from the file."""
        inside = (path[:end] for end in range(len(path), 0, -1))
        return next((self.overrides[p] for p in inside if p in self.overrides), None)

    def line(self, path: Path) -> int:
        """Return the line of a value, or of the nearest thing that would hold it."""
        if (*path, "value") in self.lines:
            return self.lines[*path, "value"]
        while path and path not in self.lines:
            path = path[:-1]
        return self.lines.get(path, 1)

    def text(self, path: Path) -> str:
        """Return a value as written, without its source; nothing if it is no scalar."""
        return self.texts.get((*path, "value"), self.texts.get(path, ""))

    def raw(self, path: Path) -> Any:
        """Return what stands at a path, None if nothing does."""
        value = self.data
        for element in path:
            try:
                value = value[element]
            except (LookupError, TypeError):
                return None
        return value


def parse_text(text: str, file: str) -> Document:
    """Return the document a YAML text holds; raise CaseError if it is not YAML."""
    try:
        if "&" in text:
            _refuse_aliases(text, file)
        root = compose(text)
        if root is not None:
            return _document(root, file)
    except yaml.MarkedYAMLError as error:
        raise CaseError([_not_yaml(error, file)]) from None
    except yaml.reader.ReaderError as error:
        line = text.count("\n", 0, error.position) + 1
        raise CaseError(
            [f"{file}:{line}: not YAML: the character #x{error.character:04x} "
             "is not allowed; save the file as plain text"]
        ) from None  # fmt: skip
    except ValueError as error:
        raise CaseError([f"{file}:1: not YAML that can be read: {error}"]) from None
    except RecursionError:
        raise CaseError(
            [f"{file}:1: lists or mappings are nested too deeply for a case file"]
        ) from None
    raise CaseError(
        [f"{file}:1: the file is empty; copy cases/16v280.yaml and change it"]
    )


def _document(root: yaml.Node, file: str) -> Document:
    document = Document(file, None)
    document.lines[()] = _line(root.start_mark)
    problems = tuple(_walk(root, (), document))
    data = construct(root)
    return Document(file, data, document.lines, document.texts, problems)


def _refuse_aliases(text: str, file: str) -> None:
    for event in yaml.parse(text, Loader=yaml.SafeLoader):
        if isinstance(event, yaml.AliasEvent):
            raise CaseError(
                [f"{file}:{_line(event.start_mark)}: found the alias "
                 f"'*{event.anchor}'; aliases are not used in a case file, "
                 "write the values out"]
            )  # fmt: skip


def _not_yaml(error: yaml.MarkedYAMLError, file: str) -> str:
    mark = error.problem_mark or error.context_mark
    column = f" at column {mark.column + 1}" if mark else ""
    said = ", ".join(part for part in (error.context, error.problem) if part)
    return f"{file}:{_line(mark)}: not YAML{column}: {said}"


def _line(mark: Any) -> int:
    return mark.line + 1 if mark else 1


def _walk(node: yaml.Node, path: Path, document: Document) -> Iterator[Problem]:
    if isinstance(node, yaml.ScalarNode):
        document.texts[path] = node.value
        yield from misread(node, path)
    elif isinstance(node, yaml.SequenceNode):
        for index, entry in enumerate(node.value):
            document.lines[(*path, index)] = _line(entry.start_mark)
            yield from _walk(entry, (*path, index), document)
    elif isinstance(node, yaml.MappingNode):
        yield from _walk_mapping(node, path, document)


def _walk_mapping(
    node: yaml.MappingNode, path: Path, document: Document
) -> Iterator[Problem]:
    seen: dict[str, int] = {}
    yield from without_merge_keys(node, path)
    for key, value in node.value:
        name, line = str(key.value), _line(key.start_mark)
        inner = (*path, name)
        if name in seen:
            yield Problem(
                inner,
                f"key '{name}' is given twice, first in line {seen[name]}; "
                "delete one of them",
                line,
            )
        seen.setdefault(name, line)
        document.lines[inner] = line
        yield from _walk(value, inner, document)

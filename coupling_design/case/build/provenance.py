"""Where every value of a case file comes from."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from pydantic import BaseModel

from coupling_design.case.text.document import Document
from coupling_design.case.text.fault import Path, dotted
from coupling_design.case.values.quantity import Kind
from coupling_design.case.values.stated import Stated
from coupling_design.machine.sourced_value import SourcedValue


def list_provenance(section: BaseModel, document: Document) -> tuple[SourcedValue, ...]:
    """Return every stated value of a validated section, in the file's order."""
    return tuple(
        SourcedValue(
            path=dotted(path),
            text=_text(document, path),
            value=_value(stated),
            unit=_unit(stated, _text(document, path)),
            source=stated.source,
            note=stated.note,
            line=document.line(path) if document.override(path) is None else None,
        )
        for path, stated in _stated(section, ())
    )


def _stated(part: Any, path: Path) -> Iterator[tuple[Path, Stated[Any]]]:
    if isinstance(part, Stated):
        yield path, part
    elif isinstance(part, BaseModel):
        for name in type(part).model_fields:
            yield from _stated(getattr(part, name), (*path, name))
    elif isinstance(part, tuple):
        for index, entry in enumerate(part):
            yield from _stated(entry, (*path, index))


def _text(document: Document, path: Path) -> str:
    """Return a value as written, a list with commas."""
    written = document.raw(path)
    entries = written.get("value") if isinstance(written, dict) else written
    if isinstance(entries, list):
        return ", ".join(map(str, entries))
    return document.text(path)


def _value(stated: Stated[Any]) -> float | str:
    """Return a value; a list, such as a firing order, as text in SI."""
    if isinstance(stated.value, tuple):
        return ", ".join(map(str, stated.value))
    value: float | str = stated.value
    return value


def _unit(stated: Stated[Any], text: str) -> str:
    metadata = type(stated).model_fields["value"].metadata
    kinds = (item for item in metadata if isinstance(item, Kind))
    return next((kind.unit_of(text) for kind in kinds), "")

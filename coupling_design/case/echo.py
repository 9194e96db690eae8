"""What a case file was understood to say, value by value."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from pydantic import BaseModel

from coupling_design.case.build.catalogue import load_catalogues
from coupling_design.case.build.provenance import list_provenance
from coupling_design.case.load import validate
from coupling_design.case.text.document import Document
from coupling_design.case.text.fault import Path, dotted
from coupling_design.case.values.stated import Stated
from coupling_design.machine.sourced_value import SourcedValue


@dataclass(frozen=True)
class EchoedValue:
    """One value of a case.

    Attributes
    ----------
    path : of the value, dotted
    text : as written; nothing for a default
    value : SI number, or word; None for what is not given and has no default
    unit : SI
    source, note : where it comes from, as the file says
    line : in the file; None for a default or a value from the command line
    is_default, is_override : whether it is the one, or the other
    """

    path: str
    text: str
    value: float | str | None
    unit: str = ""
    source: str = ""
    note: str = ""
    line: int | None = None
    is_default: bool = False
    is_override: bool = False


def echo(document: Document) -> tuple[EchoedValue, ...]:
    """Return every value of a document, defaults too, or raise CaseError."""
    section = validate(document, load_catalogues(document))
    stated = {value.path: value for value in list_provenance(section, document)}
    return tuple(_values(section, (), document, stated))


def _values(
    part: Any, path: Path, document: Document, stated: Mapping[str, SourcedValue]
) -> Iterator[EchoedValue]:
    if isinstance(part, BaseModel) and not isinstance(part, Stated):
        for name in type(part).model_fields:
            inner, value = (*path, name), getattr(part, name)
            if name in part.model_fields_set:
                yield from _values(value, inner, document, stated)
            else:
                yield _default(value, inner)
    elif isinstance(part, tuple):
        for index, entry in enumerate(part):
            yield from _values(entry, (*path, index), document, stated)
    else:
        yield _echoed(part, path, document, stated.get(dotted(path)))


def _echoed(
    value: Any, path: Path, document: Document, stated: SourcedValue | None
) -> EchoedValue:
    is_override = document.override(path) is not None
    return EchoedValue(
        path=dotted(path),
        text=stated.text if stated else document.text(path),
        value=stated.value if stated else value,
        unit=stated.unit if stated else "",
        source=(stated and stated.source) or "",
        note=stated.note if stated else "",
        line=None if is_override else document.line(path),
        is_override=is_override,
    )


def _default(value: Any, path: Path) -> EchoedValue:
    known = value.value if isinstance(value, Stated) else value
    shown = known if isinstance(known, float | str) else None
    return EchoedValue(path=dotted(path), text="", value=shown, is_default=True)

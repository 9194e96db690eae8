"""The tables of docs/case-file.md, from the case file's own schema and case_notes.yaml.

`python docs/tools/case_keys.py` writes them anew.
"""

from __future__ import annotations

import math
import re
import sys
import types
import typing
from collections.abc import Iterator
from enum import StrEnum
from pathlib import Path
from typing import Any

import yaml
from pydantic import BaseModel

TOOLS = Path(__file__).resolve().parent
PAGE = TOOLS.parent / "case-file.md"
_HEAD = """\
| key | kind, unit | range | required | meaning |
|---|---|---|---|---|
"""
_PART = re.compile(r"(<!-- keys: (\w+) -->\n)(.*?)(<!-- end of keys -->)", re.DOTALL)


def page() -> str:
    """Return the page with its tables as the schema has them now."""
    from coupling_design.case.schema.catalogue import CatalogueSection
    from coupling_design.case.schema.machine import CaseSection

    notes = yaml.safe_load((TOOLS / "case_notes.yaml").read_text(encoding="utf-8"))
    models = {"case": CaseSection, "catalogue": CatalogueSection}

    def made(match: re.Match[str]) -> str:
        return match[1] + tables(models[match[2]], notes[match[2]]) + match[4]

    return _PART.sub(made, PAGE.read_text(encoding="utf-8"))


def tables(model: type[BaseModel], notes: dict[str, str]) -> str:
    """Return a table for each section of a model; a KeyError names a missing note."""
    left = set(notes)
    parts = []
    told = set()
    for path, section in sections(model):
        rows = []
        for key, field in section.model_fields.items():
            note = _note(f"{path}.{key}".lstrip("."), notes)
            asked, allowed = described(field.annotation, field.metadata)
            needed = "yes" if field.is_required() else "no"
            rows.append(
                f"| `{key}` | {asked} | {allowed} | {needed} | {notes[note]} |\n"
            )
            left.discard(note)
        title = _title(path, section)
        if rows and title not in told:
            told.add(title)
            parts.append(title + _HEAD + "".join(rows))
    if left:
        raise KeyError(f"notes of keys that are none: {', '.join(sorted(left))}")
    return "".join(parts) + "\n"


def _note(path: str, notes: dict[str, str]) -> str:
    """Return the key of the note of a path: its own, or one for any path."""
    for places in (2, 1):
        general = "*." + ".".join(path.split(".")[-places:])
        if path not in notes and general in notes:
            return general
    return path


def _title(path: str, section: type[BaseModel]) -> str:
    if not path:
        return "\n### Top level\n\n"
    law = section.model_fields.get("law")
    words = f" with law {typing.get_args(law.annotation)[0]}" if law else ""
    return f"\n### {path}{words}\n\n"


def sections(
    model: type[BaseModel], path: str = ""
) -> Iterator[tuple[str, type[BaseModel]]]:
    """Yield every section of a model with its path, `[]` after a list's."""
    yield path, model
    for key, field in model.model_fields.items():
        for inner, is_list in models_in(field.annotation):
            suffix = "[]" if is_list else ""
            yield from sections(inner, f"{path}.{key}{suffix}".lstrip("."))


def models_in(annotation: Any, is_list: bool = False) -> Iterator[tuple[Any, bool]]:
    """Yield the sections an annotation holds; a stated value is none."""
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        if not _is_stated(annotation):
            yield annotation, is_list
        return
    origin = typing.get_origin(annotation)
    for argument in typing.get_args(annotation):
        if argument is not Ellipsis:
            yield from models_in(argument, is_list or origin is tuple)


def described(annotation: Any, metadata: Any = ()) -> tuple[str, str]:
    """Return what is to be written at a key, and its range."""
    for extra in metadata:
        if hasattr(extra, "unit") and hasattr(extra, "lower"):
            return _kind(extra)
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        if _is_stated(annotation):
            field = annotation.model_fields["value"]
            return described(field.annotation, field.metadata)
        return "section", "see below" if annotation.model_fields else "`{}`"
    if isinstance(annotation, type) and issubclass(annotation, StrEnum):
        return "word", ", ".join(f"`{word}`" for word in annotation)
    if annotation is str:
        return "text", ""
    return _composed(annotation)


def _composed(annotation: Any) -> tuple[str, str]:
    origin, arguments = typing.get_origin(annotation), typing.get_args(annotation)
    if origin is typing.Annotated:
        return described(arguments[0], arguments[1:])
    if origin is typing.Literal:
        return "word", ", ".join(f"`{word}`" for word in arguments)
    if origin is tuple:
        asked, allowed = described(arguments[0])
        return f"list of {asked}", allowed
    if origin in (typing.Union, types.UnionType):
        found = [described(a) for a in arguments if a is not type(None)]
        asked = list(dict.fromkeys(each[0] for each in found))
        return " or ".join(asked), " or ".join(dict.fromkeys(each[1] for each in found))
    return str(annotation), ""


def _kind(kind: Any) -> tuple[str, str]:
    asked = f"{kind.name}, e. g. `{kind.example}`"
    unit = f" {kind.unit}" if kind.unit else ""
    lower, upper = (f"{limit:.6g}{unit}" for limit in (kind.lower, kind.upper))
    if kind.upper < math.inf:
        return asked, f"{kind.lower:.6g} to {upper}"
    if kind.lower == -math.inf:
        return asked, "any"
    return asked, f"more than {lower}" if kind.excludes_lower else f"{lower} or more"


def _is_stated(model: type[BaseModel]) -> bool:
    from coupling_design.case.values.stated import Stated

    return issubclass(model, Stated)


if __name__ == "__main__":
    sys.path.insert(0, str(TOOLS.parent.parent))
    PAGE.write_text(page(), encoding="utf-8", newline="\n")

"""Every place of a case file that can hold something, and finding one by its name."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from difflib import get_close_matches
from typing import Any, get_args, get_origin

from pydantic import BaseModel

from coupling_design.case.schema.machine import CaseSection
from coupling_design.case.text.document import Document
from coupling_design.case.text.fault import Path, dotted
from coupling_design.case.values.stated import Stated

_SHOWN = 6  # of many places that a name may mean


def list_places(document: Document) -> tuple[Path, ...]:
    """Return the path of each key a case may have, in lists of each entry it has."""
    return tuple(dict.fromkeys(_places(CaseSection, document.data, ())))


def find_place(name: str, document: Document) -> Path:
    """Return the one place whose path is a name or ends in it; else raise ValueError.

    An entry of a list goes by its number or by its own name: `coupling_types[0]`,
    `coupling_types[rubber]`. Where several places end so, that which the file fills is
    meant, or else that whose section the file has. The error's text says what was
    found and what is near.
    """
    wanted = split(name)
    places = list_places(document)
    matching = [place for place in places if _ends_in(place, wanted, document)]
    complete = [place for place in matching if len(place) == len(wanted)]
    for depth in (None, -1):  # the place itself, then the section it is in
        filled = [at for at in matching if document.raw(at[:depth]) is not None]
        if len(filled) == 1 and not complete:
            return filled[0]
    if len(complete or matching) == 1:
        return (complete or matching)[0]
    if matching:
        found = ", ".join(map(dotted, matching[:_SHOWN]))
        more = ", ..." if len(matching) > _SHOWN else ""
        raise ValueError(f"'{name}' may mean {found}{more}; write more of the path")
    raise ValueError(f"'{name}' is no key of a case; {_nearest(name, places)}")


def split(name: str) -> Path:
    """Return the elements of a path as users write it."""
    elements: list[str | int] = []
    for part in name.strip().replace("[", ".[").split("."):
        if part.startswith("[") and part.endswith("]"):
            inner = part[1:-1].strip()
            elements.append(int(inner) if inner.isdecimal() else f"[{inner}]")
        elif part:
            elements.append(part.strip())
    return tuple(elements)


def _places(model: type[BaseModel], data: Any, path: Path) -> Iterator[Path]:
    for name, field in model.model_fields.items():
        yield (*path, name)
        inner = data.get(name) if isinstance(data, dict) else None
        yield from _inside(field.annotation, inner, (*path, name))


def _inside(kind: Any, data: Any, path: Path) -> Iterator[Path]:
    if isinstance(kind, type) and issubclass(kind, BaseModel):
        if not issubclass(kind, Stated) and not isinstance(data, list):
            yield from _places(kind, data, path)
    elif get_origin(kind) is tuple:
        for index, entry in enumerate(data if isinstance(data, list) else ()):
            yield (*path, index)
            yield from _inside(get_args(kind)[0], entry, (*path, index))
    else:  # one of several, or something with annotations
        for choice in get_args(kind):
            yield from _inside(choice, data, path)


def _ends_in(place: Path, wanted: Path, document: Document) -> bool:
    """Return whether a place ends in what is wanted; numbers may be left out."""
    rest = list(wanted)
    for end in range(len(place), 0, -1):
        if not rest:
            break
        if _is_meant(place[:end], rest[-1], document):
            rest.pop()
        elif end == len(place) or not isinstance(place[end - 1], int):
            return False
    return not rest and len(wanted) > 0


def _is_meant(place: Path, wanted: str | int, document: Document) -> bool:
    last = place[-1]
    if isinstance(last, int) and isinstance(wanted, str):
        return wanted == f"[{document.text((*place, 'name'))}]"
    return last == wanted


def _nearest(name: str, places: Sequence[Path]) -> str:
    """Return the places most like a name, by their ends of the same length."""
    depth = len(split(name))
    ends = {dotted(place[-depth:]).lower(): dotted(place) for place in places}
    near = get_close_matches(name.lower(), ends, n=3, cutoff=0.5)
    if not near:
        return "allowed is any path of the case file, such as driveline.connection.gap"
    return f"did you mean {' or '.join(ends[each] for each in near)}?"

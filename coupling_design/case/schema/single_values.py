"""Single values of a document, for rules that hold between them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import cache
from typing import Any

from pydantic import TypeAdapter, ValidationError

from coupling_design.case.text.document import Document
from coupling_design.case.text.fault import Path, Problem
from coupling_design.case.values.quantity import exceeds
from coupling_design.case.values.stated import Stated


class Values:
    """Reads single values of a document; None where one is absent or wrong."""

    def __init__(self, document: Document) -> None:
        self._document = document

    def raw(self, *path: str | int) -> Any:
        """Return what stands at a path, unchecked."""
        return self._document.raw(path)

    def read(self, kind: Any, *path: str | int) -> Any:
        """Return the value at a path if it is of that kind (a type of `kinds`)."""
        try:
            return _adapter(kind).validate_python(self.raw(*path)).value
        except ValidationError:
            return None

    def text(self, *path: str | int) -> str:
        """Return a value as written, without its source."""
        return self._document.text(path)

    def count(self, *path: str | int) -> int:
        """Return how many entries a list has; 0 if it is none."""
        entries = self.raw(*path)
        return len(entries) if isinstance(entries, list) else 0


def check_between(
    values: Values, kind: Any, path: Path, limits: tuple[Path, Path], range_name: str
) -> Iterator[Problem]:
    """Yield a problem if a value lies outside two others."""
    value = values.read(kind, *path)
    lower, upper = (values.read(kind, *limit) for limit in limits)
    if None in (value, lower, upper) or exceeds(lower, upper):
        return
    if not exceeds(lower, value) and not exceeds(value, upper):
        return
    low, high = (values.text(*limit) for limit in limits)
    yield Problem(
        path,
        f"found '{values.text(*path)}', allowed {low} to {high}, {range_name}; "
        "correct one of them",
    )


def check_ordered(
    values: Values, pairs: Iterable[tuple[Any, Path, Path]]
) -> Iterator[Problem]:
    """Yield a problem for each (kind, smaller, larger) that is the other way round."""
    for kind, lower, upper in pairs:
        small, large = values.read(kind, *lower), values.read(kind, *upper)
        if None not in (small, large) and exceeds(small, large):
            yield Problem(
                upper,
                f"found '{values.text(*upper)}', allowed {lower[-1]} "
                f"'{values.text(*lower)}' or more; exchange or correct them",
            )


def check_unique(
    values: Values, entries: Path, key: str, kind: Any = None
) -> Iterator[Problem]:
    """Yield a problem for each entry of a list that repeats another's key.

    Compared as a value of that kind (a type of `kinds`), or as a text.
    """
    seen: set[Any] = set()
    for index in range(values.count(*entries)):
        path = (*entries, index, key)
        value = values.read(kind, *path) if kind else values.text(*path) or None
        if value in seen:
            yield Problem(
                path,
                f"{key} '{values.text(*path)}' is given twice; "
                "delete one entry or correct it",
            )
        elif value is not None:
            seen.add(value)


@cache
def _adapter(kind: Any) -> TypeAdapter[Any]:
    return TypeAdapter(Stated[kind])

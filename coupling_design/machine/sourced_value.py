"""One value of a case file, and where it comes from."""

from __future__ import annotations

from dataclasses import dataclass

from coupling_design.machine.words import Source


@dataclass(frozen=True)
class SourcedValue:
    """One value of the file: its path, as written, in SI, and where it comes from.

    `value` is a float in `unit`, or the word chosen; `source` is None if not stated,
    `line` if it stands in no file of its own.
    """

    path: str
    text: str
    value: float | str
    unit: str
    source: Source | None
    note: str
    line: int | None = None

"""One thing wrong with a case file, and where."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from difflib import get_close_matches

Path = tuple[str | int, ...]


@dataclass(frozen=True)
class Problem:
    """A sentence about what stands at `path`; `line` only if it is not the path's."""

    path: Path
    sentence: str
    line: int | None = None


def dotted(path: Path) -> str:
    """Return a path as users write it, `driveline.excitation[0].order`."""
    text = "".join(
        f"[{element}]" if isinstance(element, int) else f".{element}"
        for element in path
    )
    return text.removeprefix(".")


def suggestion(word: str, allowed: Iterable[str]) -> str:
    """Return `did you mean ...? ` if one of the allowed words is near, else nothing."""
    near = get_close_matches(word.lower(), list(allowed), n=1, cutoff=0.6)
    return f"did you mean '{near[0]}'? " if near else ""

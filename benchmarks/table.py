"""Rows of the table, and whether each keeps its bound."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field


@dataclass(frozen=True)
class Row:
    """One thing measured.

    Attributes
    ----------
    key : names the row, and the text that explains why its bound is not met
    what, measured, bound : as the table shows them
    met : None where there is no bound, or nothing could be measured
    numbers : what the page's texts may quote, by name
    """

    key: str
    what: str
    measured: str
    bound: str = "-"
    met: bool | None = None
    numbers: Mapping[str, str] = field(default_factory=dict)

    @property
    def verdict(self) -> str:
        """Return the last column."""
        if self.met is None:
            return "-"
        return "met" if self.met else "**not met**"


def at_most(key: str, what: str, shown: str, value: float, bound: float) -> Row:
    """Return a row whose value must not be larger."""
    return Row(key, what, shown, f"at most {bound:g}", value <= bound)


def at_least(key: str, what: str, shown: str, value: float, bound: float) -> Row:
    """Return a row whose value must not be smaller."""
    return Row(key, what, shown, f"at least {bound:g}", value >= bound)


def missing(key: str, what: str, reason: str) -> Row:
    """Return a row for what cannot be measured here."""
    return Row(key, what, reason)


def markdown(header: Iterable[str], lines: Iterable[Iterable[str]]) -> str:
    """Return a table in Markdown."""
    names = list(header)
    rows = [names, ["---"] * len(names), *map(list, lines)]
    return "\n".join("| " + " | ".join(row) + " |" for row in rows)


def table(rows: Iterable[Row]) -> str:
    """Return the table of all rows."""
    header = ("what", "measured", "bound", "")
    return markdown(header, ((r.what, r.measured, r.bound, r.verdict) for r in rows))

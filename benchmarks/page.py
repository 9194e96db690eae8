"""PERFORMANCE.md: the template's prose, the run's numbers."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path
from string import Template

from benchmarks.table import Row, table

_HERE = Path(__file__).parent
_PAGE, _REASONS = _HERE / "page.md", _HERE / "reasons.md"


def page(rows: Iterable[Row], texts: Mapping[str, str]) -> str:
    """Return the page.

    Parameters
    ----------
    rows : of the table
    texts : what the templates quote besides the rows' own numbers, by name
    """
    rows = list(rows)
    numbers = dict(texts)
    for row in rows:
        numbers |= {row.key: row.measured, **row.numbers}
    template = Template(_PAGE.read_text(encoding="utf-8"))
    explained = _explanations(rows, numbers)
    return template.substitute(numbers, table=table(rows), explanations=explained)


def _explanations(rows: list[Row], numbers: Mapping[str, str]) -> str:
    """Return why each bound that is not met is not met."""
    reasons = _reasons()
    failed = [row for row in rows if row.met is False]
    written = {key: Template(text).substitute(numbers) for key, text in reasons.items()}
    none = "No reason is known: the profile has to be looked at again."
    texts = [f"**{row.what}**: {written.get(row.key, none)}" for row in failed]
    return "\n\n".join(texts) or "All bounds are met."


def _reasons() -> dict[str, str]:
    """Return the texts of reasons.md by the key of the row they explain."""
    _, *sections = _REASONS.read_text(encoding="utf-8").split("\n## ")
    pairs = (section.partition("\n") for section in sections)
    return {key.strip(): text.strip() for key, _, text in pairs}

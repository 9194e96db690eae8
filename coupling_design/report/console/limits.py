"""Values against their limits: one table with margin, verdict and source."""

from __future__ import annotations

from collections.abc import Sequence

from rich.console import Group, RenderableType
from rich.text import Text

from coupling_design.parts.criterion import Criterion
from coupling_design.report.console.blocks import facts, table, titled
from coupling_design.report.words.names import verdict_of
from coupling_design.report.words.numbers import percent
from coupling_design.report.words.units import display_unit, value_and_limit


def render_criteria(title: str, criteria: Sequence[Criterion]) -> RenderableType | None:
    """Return the limits with their sources below, None if there are none."""
    if not criteria:
        return None
    sources = list(dict.fromkeys(criterion.source for criterion in criteria))
    limits = table(
        ["criterion"], ["value", "limit", "margin\n%"], ["unit", "verdict", "from"]
    )
    for criterion in criteria:
        value, limit = value_and_limit(criterion)
        limits.add_row(
            Text(criterion.name),
            value,
            limit,
            "-" if criterion.margin is None else percent(criterion.margin),
            display_unit(criterion.unit),
            verdict_of(criterion.verdict),
            Text(f"[{sources.index(criterion.source) + 1}]"),
        )
    numbered = facts((f"[{n}]", source) for n, source in enumerate(sources, start=1))
    return titled(title, Group(limits, Text(), numbered))

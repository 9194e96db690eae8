"""The assumed, fitted and invented values that a result rests on."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import groupby

from rich.console import Group, RenderableType
from rich.panel import Panel
from rich.table import Table
from rich.text import Text

from coupling_design.machine.machine import Case
from coupling_design.machine.sourced_value import SourcedValue
from coupling_design.report.console.blocks import panel

_INTRODUCTION = "By section of the case file: value as written there, source, note."


def render_assumptions(case: Case, assumptions: Sequence[SourcedValue]) -> Panel:
    """Return the values by section of the case file, as written there."""
    if not assumptions:
        return panel("Rests on", [Text("No value is assumed, fitted or invented.")])
    cells = [_cells(value) for value in assumptions]
    widths = [max(map(len, column)) for column in zip(*cells, strict=True)]
    parts: list[RenderableType] = []
    for section, values in groupby(assumptions, key=section_of):
        parts.append(Text(section_title(case, section), style="bold"))
        parts.append(_rows(values, widths[:-1]))
    plural = "" if len(assumptions) == 1 else "s"
    title = f"Rests on {len(assumptions)} assumed, fitted or invented value{plural}"
    return panel(title, [Text(_INTRODUCTION), Group(*parts)])


def _rows(values: Iterable[SourcedValue], widths: Sequence[int]) -> Table:
    """Return lines of one section; equal widths keep all sections in line."""
    rows = Table.grid(padding=(0, 2, 0, 0))
    for width in widths:
        rows.add_column(width=width, no_wrap=True)
    rows.add_column(overflow="fold")
    for value in values:
        rows.add_row(*map(Text, _cells(value)))
    return rows


def _cells(value: SourcedValue) -> tuple[str, str, str, str]:
    """Return key, value as written, source and note."""
    key = value.path.rpartition(".")[2]
    return f"  {key}", value.text, value.source or "not stated", value.note


def section_of(value: SourcedValue) -> str:
    """Return the path of the section that a value stands in."""
    return value.path.rpartition(".")[0]


def section_title(case: Case, section: str) -> str:
    """Return a section's path, with the name of the coupling type it belongs to."""
    if not section:
        return "top level"
    for index, coupling_type in enumerate(case.coupling_types):
        if section.startswith(f"coupling_types[{index}]"):
            return f"{section} ({coupling_type.name})"
    return section

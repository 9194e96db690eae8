"""The few shapes that every panel is made of."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from rich import box
from rich.console import Group, RenderableType
from rich.panel import Panel
from rich.table import Table
from rich.text import Text


def panel(
    title: str, parts: Iterable[RenderableType | None], style: str = "none"
) -> Panel:
    """Return parts under a title, a blank line between them; None is left out."""
    spaced: list[RenderableType] = []
    for part in parts:
        if part is not None:
            spaced += [Text(), part] if spaced else [part]
    heading = Text(title, style="bold")
    return Panel(Group(*spaced), title=heading, title_align="left", border_style=style)


def table(texts: Sequence[str], numbers: Sequence[str], ends: Sequence[str]) -> Table:
    """Return an empty table: columns of text, of numbers, and of short words."""
    empty = Table(box=box.SIMPLE_HEAD, show_edge=False, padding=(0, 1, 0, 0))
    for header in texts:
        empty.add_column(Text(header), overflow="fold", vertical="top")
    for header in numbers:
        empty.add_column(Text(header), justify="right", no_wrap=True)
    for header in ends:
        empty.add_column(Text(header), no_wrap=True)
    return empty


def facts(rows: Iterable[tuple[str, str]]) -> Table:
    """Return names with what is to be said of each; long texts wrap in their column."""
    grid = Table.grid(padding=(0, 2, 0, 0))
    grid.add_column(no_wrap=True)
    grid.add_column(overflow="fold")
    for name, text in rows:
        grid.add_row(Text(name), Text(text))
    return grid


def bullets(title: str, items: Sequence[str]) -> RenderableType | None:
    """Return a titled list, None if there is nothing to list."""
    if not items:
        return None
    grid = Table.grid(padding=(0, 1, 0, 0))
    grid.add_column(no_wrap=True)
    grid.add_column(overflow="fold")
    for item in items:
        grid.add_row(Text("-"), Text(item))
    return titled(title, grid)


def titled(title: str, content: RenderableType) -> Group:
    """Return content under a line of its own."""
    return Group(Text(title, style="bold"), content)

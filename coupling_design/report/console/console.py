"""Where a report is printed, and how wide."""

from __future__ import annotations

import io
import os
import sys
from typing import IO

from rich.console import Console, RenderableType
from rich.segment import Segments

FILE_WIDTH = 100
NARROWEST = 80  # below this tables would lose digits; the terminal wraps instead


class _PatientConsole(Console):
    """A console whose reader may leave early: the run goes on and writes its files."""

    def on_broken_pipe(self) -> None:
        self.quiet = True
        os.dup2(os.open(os.devnull, os.O_WRONLY), self.file.fileno())


def make_report_console() -> Console:
    """Return the console on standard output."""
    return _console(sys.stdout)


def make_error_console() -> Console:
    """Return the console on standard error, for progress and for what went wrong."""
    return _console(sys.stderr)


def print_report(console: Console, report: RenderableType) -> str:
    """Print a report; return it as `plain_text` does.

    A report takes a tenth of a second to lay out: if the console is laid out like a
    file, which a pipe's is, that is done once.
    """
    if _layout(console) != _layout(_file_console()):
        console.print(report)
        return plain_text(report)
    segments = list(console.render(report))
    console.print(Segments(segments))
    return _bare("".join(part.text for part in segments if not part.control))


def plain_text(report: RenderableType, width: int = FILE_WIDTH) -> str:
    """Return a report as plain text of a fixed width, whatever the terminal."""
    console = _file_console(width)
    with console.capture() as capture:
        console.print(report)
    return _bare(capture.get())


def _file_console(width: int = FILE_WIDTH) -> Console:
    return Console(
        file=io.StringIO(newline=""),
        width=width,
        color_system=None,
        force_terminal=False,
        legacy_windows=False,
        _environ={},
    )


def _layout(console: Console) -> tuple[int, bool, bool]:
    """Return all of a console that decides which character stands where."""
    options = console.options
    return options.max_width, options.ascii_only, options.legacy_windows


def _bare(text: str) -> str:
    """Return a text without blanks at the end of its lines."""
    return "".join(f"{line.rstrip()}\n" for line in text.splitlines())


def _console(stream: IO[str] | None) -> Console:
    if isinstance(stream, io.TextIOWrapper):  # a character unknown there is no error
        stream.reconfigure(errors="backslashreplace")
    console = _PatientConsole(
        file=stream, width=_width(stream), highlight=False, emoji=False, markup=False
    )
    console.width = max(console.width, NARROWEST)
    return console


def _width(stream: IO[str] | None) -> int | None:
    """Return the width to use; None leaves it to the terminal."""
    columns = os.environ.get("COLUMNS", "")
    if columns.isdecimal() and int(columns) > 0:
        return int(columns)
    on_screen = stream is not None and stream.isatty()
    return None if on_screen else FILE_WIDTH

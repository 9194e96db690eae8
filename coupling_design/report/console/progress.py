"""What is being worked on, for who waits at a terminal."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from coupling_design.report.console.console import make_error_console


@contextmanager
def show_progress() -> Iterator[Callable[[str], None]]:
    """Yield what takes the current step: shown on a terminal, else nowhere."""
    if sys.stderr is None or not sys.stderr.isatty():
        yield _nowhere
        return
    with make_error_console().status("starting", spinner="line") as status:
        yield status.update


def _nowhere(_: str) -> None:
    """Say nothing."""

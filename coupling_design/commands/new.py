"""`new FILE`: a commented case to start from."""

from __future__ import annotations

import sys
from importlib.resources import files
from pathlib import Path
from typing import Annotated

import typer

from coupling_design.errors import OutputError

EXAMPLES = (
    "new mine.yaml",
    "new mine.yaml --force",
)


def run(
    file: Annotated[
        Path, typer.Argument(metavar="FILE", help="the case file to write")
    ],
    *,
    force: Annotated[
        bool, typer.Option("--force", help="overwrite a file that is there")
    ] = False,
) -> int:
    """Write a commented case to start from; it asks nothing.

    The case is complete: it passes check and can be designed as it is. Put your
    machine's values in place of its invented ones, then run check.
    """
    from coupling_design.report.files.write import write_atomically

    if file.exists() and not force:
        raise OutputError(
            f"{file}: is there already; name another file, or overwrite it with --force"
        )
    template = files("coupling_design.case").joinpath("template.yaml")
    write_atomically(file, template.read_text(encoding="utf-8"))
    sys.stdout.write(f"Written: {file}\nNext: coupling-design check {file}\n")
    return 0

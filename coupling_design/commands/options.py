"""Arguments and options that several commands share."""

from __future__ import annotations

from typing import Annotated

import typer

CaseFile = Annotated[
    str, typer.Argument(metavar="CASE", help="case file, YAML", show_default=False)
]
Overrides = Annotated[
    list[str] | None,
    typer.Option(
        "--set",
        metavar="PATH=VALUE",
        show_default=False,
        help="use another value than the file's, such as connection.gap=0.1mm; "
        "as much of the path's end as tells it from others; may be repeated",
    ),
]

"""Arguments and options that several commands share."""

from __future__ import annotations

from typing import Annotated

import typer


def complete_place(ctx: typer.Context, incomplete: str) -> list[str]:
    """Return the places of the case named before that begin like a word."""
    from coupling_design.case.edit.places import list_places
    from coupling_design.case.load import read_document
    from coupling_design.case.text.fault import dotted
    from coupling_design.errors import CaseError

    # After an option that still lacks its value, the case is among the rest.
    named = (word for word in (ctx.params.get("case"), *ctx.args) if word)
    try:
        places = list_places(read_document(next(named, "")))
    except CaseError:
        return []
    names = dict.fromkeys(dotted(place[k:]) for place in places for k in (0, -2, -1))
    return [f"{name}=" for name in names if name.startswith(incomplete)]


CaseFile = Annotated[
    str, typer.Argument(metavar="CASE", help="case file, YAML", show_default=False)
]
Overrides = Annotated[
    list[str] | None,
    typer.Option(
        "--set",
        metavar="PATH=VALUE",
        show_default=False,
        autocompletion=complete_place,
        help="use another value than the file's, such as connection.gap=0.1mm; "
        "as much of the path's end as tells it from others; may be repeated",
    ),
]
Size = Annotated[
    str | None,
    typer.Option(
        "--size",
        metavar="NAME",
        show_default=False,
        help="a size of the case's catalogue, with all that its sheet states",
    ),
]

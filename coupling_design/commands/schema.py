"""`schema`: the shape of a case file, for editors."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Annotated

import typer

EXAMPLES = (
    "schema > case.schema.json",
    "schema --out case.schema.json",
)


def run(
    out: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE", show_default=False, help="write it there, not to the screen"
        ),
    ] = None,
) -> int:
    """Print the JSON Schema of a case file, so that editors complete and check it.

    Editors that speak the YAML language server find it by a first line in the case
    file: # yaml-language-server: $schema=case.schema.json
    """
    from coupling_design.case.schema.json_schema import case_schema
    from coupling_design.report.files.write import write_atomically

    text = json.dumps(case_schema(), indent=2, ensure_ascii=False) + "\n"
    if out is None:
        sys.stdout.write(text)
    else:
        write_atomically(out, text)
        sys.stdout.write(f"Written: {out}\n")
    return 0

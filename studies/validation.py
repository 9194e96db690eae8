"""Write VALIDATION.md: everything compared, everything contradictory, every figure."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path

from rich.console import Console

import coupling_design
from coupling_design.case import load_case
from coupling_design.errors import CouplingDesignError
from coupling_design.machine.machine import Case
from studies.collection import Part, collect
from studies.command import parser
from studies.page import agrees, write_page

PAGE = Path("VALIDATION.md")


def validate(file: Path, folder: Path, page: Path) -> tuple[Part, ...]:
    """Write figures and page of a case, and return what they show."""
    case = load_case(file)
    parts = collect(case, folder)
    page.write_text(write_page(parts, header(case, file), page), encoding="utf-8")
    return parts


def header(case: Case, file: Path) -> Sequence[str]:
    """Return what the numbers belong to."""
    return (
        f"Case: {case.name}, `{file.as_posix()}`, SHA-256 `{case.sha256}`. "
        f"Program: coupling-design {coupling_design.__version__}.",
    )


def main() -> int:
    """Write the page as the command line says and return the exit code."""
    words: argparse.ArgumentParser = parser("Write the validation and its figures.")
    words.add_argument("--page", type=Path, default=PAGE, help="file to write")
    arguments = words.parse_args()
    try:
        parts = validate(arguments.case, arguments.output, arguments.page)
    except CouplingDesignError as error:
        Console(stderr=True).print(str(error), style="red", markup=False)
        return 1
    rows = [row for part in parts for row in part.comparisons]
    failed = [row for row in rows if not agrees(row)]
    console = Console()
    console.print(f"{arguments.page}: {len(rows) - len(failed)} of {len(rows)} agree.")
    for row in failed:
        console.print(f"{row} {row.unit}", markup=False)
    for part in parts:
        if part.missing:
            console.print(f"{part.title}: {part.missing}", markup=False)
    return 0


if __name__ == "__main__":
    sys.exit(main())

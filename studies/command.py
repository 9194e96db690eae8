"""What every study is, and how it is run from the command line."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Generic, TypeVar

from matplotlib.figure import Figure
from rich.console import Console
from rich.table import Table

from coupling_design.case import load_case
from coupling_design.errors import CouplingDesignError
from coupling_design.machine.machine import Case
from studies.drawing import save

DEFAULT_CASE = Path("cases/16v280.yaml")
FIGURES = Path("studies/figures")

Found = TypeVar("Found")


@dataclass(frozen=True)
class Study(Generic[Found]):
    """A question put to a case, and how its answer is shown.

    Attributes
    ----------
    title : with the paper's figure
    examine : the rollouts; everything shown comes from what it returns
    tables, figures : of what was found; figures by their file names
    findings : sentences, their numbers filled in
    """

    title: str
    examine: Callable[[Case], Found]
    tables: Callable[[Found], Sequence[Table]]
    figures: Callable[[Found], Mapping[str, Figure]]
    findings: Callable[[Found], Sequence[str]]


def main(study: Study[Found]) -> int:
    """Run a study as the command line says and return the exit code."""
    arguments = parser(study.title).parse_args()
    console = Console()
    try:
        found = study.examine(load_case(arguments.case))
    except CouplingDesignError as error:
        Console(stderr=True).print(str(error), style="red", markup=False)
        return 1
    for table in study.tables(found):
        console.print(table)
    for sentence in study.findings(found):
        console.print(sentence, markup=False)
    for name, figure in study.figures(found).items():
        console.print(str(save(figure, arguments.output, name, arguments.format)))
    return 0


def parser(description: str) -> argparse.ArgumentParser:
    """Return the parser of the options that all studies share."""
    words = argparse.ArgumentParser(description=description)
    words.add_argument("--case", type=Path, default=DEFAULT_CASE, help="case file")
    words.add_argument("--output", type=Path, default=FIGURES, help="folder of figures")
    words.add_argument("--format", choices=("svg", "png"), default="svg")
    return words


def table(title: str, *columns: str) -> Table:
    """Return an empty table, its first column of words and the others of numbers."""
    made = Table(title=title, title_justify="left")
    for i, column in enumerate(columns):
        made.add_column(column, justify="left" if i == 0 else "right")
    return made


def leave(study: Study[Found]) -> None:
    """Run a study and end the program with its exit code."""
    sys.exit(main(study))

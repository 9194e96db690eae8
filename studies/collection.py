"""What VALIDATION.md is made of: every comparison, contrast and figure, by part."""

from __future__ import annotations

import importlib
import inspect
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from coupling_design.machine.machine import Case
from studies import (
    contact,
    gap,
    high_stiffness,
    honest_reading,
    iso281,
    lubrication,
    paper_results,
    resonance,
    skf,
    start,
    stiffness,
)
from studies.command import Found, Study
from studies.drawing import save
from studies.identification import report as identification
from studies.judgement import Contrast
from tests.verification.comparison import Comparison

VERIFICATION = Path(__file__).parents[1] / "tests" / "verification"


@dataclass(frozen=True)
class Illustration:
    """What a study found: its title, sentences and the files of its figures."""

    title: str
    findings: tuple[str, ...]
    files: tuple[Path, ...]


@dataclass(frozen=True)
class Part:
    """A part of the validation; `missing` says why nothing could be compared.

    `text` is Markdown of the part's own, with the paths of its `drawings` as they are.
    """

    title: str
    comparisons: tuple[Comparison, ...] = ()
    contrasts: tuple[Contrast, ...] = ()
    illustrations: tuple[Illustration, ...] = ()
    missing: str = ""
    text: str = ""
    drawings: tuple[Path, ...] = ()


def collect(case: Case, folder: Path) -> tuple[Part, ...]:
    """Return every part, its figures written to a folder."""
    honest = honest_reading.STUDY.examine(case)
    drawn = honest_reading.STUDY.figures(honest)
    return (
        Part(
            "The paper's results",
            paper_results.comparisons(case),
            illustrations=tuple(illustrations(case, folder)),
            text=start.moved(case),
        ),
        Part(start.TITLE, text=start.fragment(start.examine(case))),
        identification_part(case, folder),
        Part(
            "Where the paper contradicts itself",
            contrasts=honest.contrasts,
            illustrations=(
                Illustration(
                    "The key's contact by the unit of sigma",
                    (),
                    tuple(save(f, folder, name) for name, f in drawn.items()),
                ),
            ),
        ),
        Part("Bearing life after ISO 281:2007", tuple(iso281.comparisons())),
        Part(
            "Bearing life in SKF's examples",
            tuple(skf.comparisons()),
            tuple(skf.contrasts()),
        ),
        *verification_parts(),
    )


def identification_part(case: Case, folder: Path) -> Part:
    """Return which lost inputs reproduce the paper, and how well each is determined."""
    found = identification.STUDY.examine(case)
    drawn = identification.STUDY.figures(found)
    files = tuple(save(figure, folder, name) for name, figure in drawn.items())
    return Part(
        identification.STUDY.title,
        identification.comparisons(case),
        text=identification.fragment(case, files[0].as_posix()),
        drawings=files,
    )


def illustrations(case: Case, folder: Path) -> Sequence[Illustration]:
    """Return what the studies of the paper's figures found."""
    return [
        illustrate(resonance.STUDY, case, folder),
        illustrate(lubrication.STUDY, case, folder),
        illustrate(stiffness.STUDY, case, folder),
        illustrate(contact.STUDY, case, folder),
        illustrate(gap.STUDY, case, folder),
        illustrate(high_stiffness.STUDY, case, folder),
    ]


def illustrate(study: Study[Found], case: Case, folder: Path) -> Illustration:
    """Return what one study found, its figures written to a folder."""
    found = study.examine(case)
    files = tuple(save(f, folder, name) for name, f in study.figures(found).items())
    return Illustration(study.title, tuple(study.findings(found)), files)


def verification_parts() -> Sequence[Part]:
    """Return what each module of the verification tests compares, in their order."""
    return [
        verification_part(f"tests.verification.{path.stem}")
        for path in sorted(VERIFICATION.glob("test_*.py"))
        if "def comparisons(" in path.read_text(encoding="utf-8")
    ]


def verification_part(module_name: str) -> Part:
    """Return what one module compares, or why it could not be asked."""
    import pytest

    try:
        module = importlib.import_module(module_name)
        found = tuple(module.comparisons())
    except (ImportError, SyntaxError, pytest.skip.Exception) as error:
        return Part(module_name, missing=str(error))
    return Part(first_line(inspect.getdoc(module) or module_name), found)


def first_line(text: str) -> str:
    """Return the first line of a docstring without its full stop."""
    return text.partition("\n")[0].removesuffix(".")

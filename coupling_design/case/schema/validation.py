"""A document held against its model and its relations: all problems at once."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any, TypeVar

from pydantic import ValidationError

from coupling_design.case.schema.messages import problems_of
from coupling_design.case.text.document import Document
from coupling_design.case.text.fault import Path, Problem, dotted
from coupling_design.case.values.stated import Section

Model = TypeVar("Model", bound=Section)


def check_form(
    document: Document, model: type[Model], relations: Iterable[Problem]
) -> tuple[Model | None, list[str]]:
    """Return a document's content in the shape of a model, and what is wrong with it.

    The sentences are as the user reads them, in the order of the file; the content is
    None where its form is at fault. `relations` are the broken ones.
    """
    if not isinstance(document.data, dict):
        keys = ", ".join(model.model_fields)
        return None, [
            f"{document.file}:{document.line(())}: the file holds no mapping; "
            f"expected the keys {keys}"
        ]
    problems = [*document.problems]
    section: Model | None = None
    try:
        section = model.model_validate(document.data)
    except ValidationError as error:
        # What YAML misread is no number either: told once, by its cause.
        misread = {_found(problem) for problem in problems}
        found = problems_of(error, model, document)
        problems += [each for each in found if _found(each) not in misread]
    told = {problem.path for problem in problems}
    empty = _empty_values(document.data, ())
    problems += [problem for problem in empty if problem.path not in told]
    problems += relations
    return section, sentences(problems, document)


def sentences(problems: Iterable[Problem], document: Document) -> list[str]:
    """Return problems as the user reads them, in the order of the file.

    Those of values from the command line come first.
    """
    located = {(*_place(problem, document), problem.sentence) for problem in problems}
    return [f"{place}: {sentence}" for _, place, sentence in sorted(located)]


def _place(problem: Problem, document: Document) -> tuple[int, str]:
    name = dotted(problem.path)
    overriding = document.override(problem.path)
    if overriding is not None:
        place = f"--set {overriding}"
        return 0, place if overriding.startswith(f"{name}=") else f"{place}: {name}"
    line = problem.line or document.line(problem.path)
    place = f"{document.file}:{line}"
    return line, f"{place}: {name}" if name else place


def _found(problem: Problem) -> tuple[Path, str]:
    """Return where a problem is and what was found there."""
    path = problem.path
    return path[:-1] if path[-1:] == ("value",) else path, problem.sentence.split(",")[
        0
    ]


def _empty_values(data: Any, path: Path) -> Iterator[Problem]:
    if data is None:
        yield Problem(path, "found nothing; write a value or delete the key")
    elif isinstance(data, dict):
        for key, value in data.items():
            yield from _empty_values(value, (*path, key))
    elif isinstance(data, list):
        for index, value in enumerate(data):
            yield from _empty_values(value, (*path, index))

"""From pydantic's errors to sentences an engineer can act on."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from enum import StrEnum
from typing import Any, Literal, get_args, get_origin

from pydantic import BaseModel, Discriminator, Tag, ValidationError
from pydantic.fields import FieldInfo
from pydantic_core import ErrorDetails

from coupling_design.case.text.document import Document
from coupling_design.case.text.fault import Path, Problem, suggestion
from coupling_design.case.values.quantity import Kind
from coupling_design.case.values.stated import Stated


@dataclass(frozen=True)
class _Place:
    """Where an error is: path in the data, the section there, and what is expected."""

    path: Path
    section: type[BaseModel] | None
    expected: Any


def problems_of(
    error: ValidationError, model: type[BaseModel], document: Document
) -> Iterator[Problem]:
    """Yield one problem for each thing pydantic found."""
    details = error.errors(include_url=False)
    misspelt = set(_misspelt(details, model))
    for detail in details:
        place = _place(model, detail["loc"])
        if detail["type"] == "missing" and place.path in misspelt:
            continue
        if detail["type"] == "too_short" and _is_long_enough(detail):
            continue
        yield _problem(detail, place, document)


def _misspelt(details: list[ErrorDetails], model: type[BaseModel]) -> Iterator[Path]:
    """Yield the paths of keys that are missing because they are misspelt."""
    for detail in details:
        if detail["type"] == "extra_forbidden":
            place = _place(model, detail["loc"])
            near = suggestion(str(place.path[-1]), _keys(place.section))
            for key in _keys(place.section):
                if f"'{key}'" in near:
                    yield (*place.path[:-1], key)


def _is_long_enough(detail: ErrorDetails) -> bool:
    """Return whether a list is short only because pydantic left out faulty entries."""
    return bool(len(detail["input"]) >= detail["ctx"]["min_length"])


def _problem(detail: ErrorDetails, place: _Place, document: Document) -> Problem:
    path, key = place.path, str(detail["loc"][-1]) if detail["loc"] else ""
    match detail["type"]:
        case "missing":
            of_value = place.section and issubclass(place.section, Stated)
            return Problem(path if of_value else path[:-1], _missing(key, place))
        case "union_tag_not_found":
            return Problem(path, f"missing key 'law'; allowed: {_laws(place)}")
        case "union_tag_invalid":
            path = (*path, "law")
            sentence = _not_allowed(_found(path, document), _laws(place))
            return Problem(path, sentence)
        case "extra_forbidden":
            return Problem(path, _unknown(key, place))
        case "quantity":
            found = _found(path, document)
            return Problem(path, f"found {found}, {detail['ctx']['sentence']}")
    return Problem(path, _wrong_form(detail, place, _found(path, document)))


def _missing(key: str, place: _Place) -> str:
    return f"missing key '{key}'; write {_expectation(place.expected)}"


def _unknown(key: str, place: _Place) -> str:
    allowed = _keys(place.section)
    listed = ", ".join(allowed) if allowed else "nothing, write {}"
    # Inside {...} a comma ends a note that has no quotes; the rest becomes a key.
    hint = " (put a text that holds a comma in quotes)" if " " in key else ""
    return f"unknown key '{key}'{hint}; {suggestion(key, allowed)}allowed: {listed}"


def _not_allowed(found: str, allowed: str) -> str:
    near = suggestion(found.strip("'"), allowed.split(", "))
    return f"found {found}; {near}allowed: {allowed}"


def _wrong_form(detail: ErrorDetails, place: _Place, found: str) -> str:
    match detail["type"]:
        case "enum" | "literal_error":
            return _not_allowed(found, _words(place.expected))
        case "too_short":
            return "found an empty list; write at least one entry"
        case "string_too_short":
            return "found an empty text; write a name"
    return f"found {found}, expected {_expectation(place.expected)}"


def _place(model: type[BaseModel], location: Path) -> _Place:
    """Return where an error's location is, without what only pydantic knows."""
    path: Path = ()
    section: type[BaseModel] | None = None
    expected: Any = model
    for element in location:
        forms = _forms(expected)
        if element in forms:
            expected = forms[str(element)]
            continue
        choices = _models(expected)
        if len(choices) > 1:  # a damping law, chosen by its name
            expected = next((m for m in choices if element in _law(m)), None)
        elif choices:
            section = choices[0]
            inner = section.model_fields.get(str(element))
            if not (issubclass(section, Stated) and element == "value"):
                path = (*path, element)
            expected = _wanted(inner) if inner else None
        else:
            path = (*path, element)
            expected = next(iter(get_args(expected)), None)
    return _Place(path, section, expected)


def _wanted(field: FieldInfo) -> Any:
    """Return the kind of quantity a field wants, or else its type."""
    kinds = (item for item in field.metadata if isinstance(item, Kind))
    return next(kinds, field.annotation)


def _models(expected: Any) -> list[type[BaseModel]]:
    if isinstance(expected, type) and issubclass(expected, BaseModel):
        return [expected]
    if get_origin(expected) is tuple:
        return []
    return [
        argument
        for argument in get_args(expected)
        if isinstance(argument, type) and issubclass(argument, BaseModel)
    ]


def _forms(expected: Any) -> dict[str, Any]:
    """Return what a value may be by the tag of each: a list, or a mapping."""
    for choice in get_args(expected):  # one that may be left out
        if any(isinstance(item, Discriminator) for item in get_args(choice)):
            return _forms(get_args(choice)[0])
    return {
        item.tag: get_args(form)[0]
        for form in get_args(expected)
        for item in get_args(form)
        if isinstance(item, Tag)
    }


def _law(model: type[BaseModel]) -> tuple[str, ...]:
    field = model.model_fields.get("law")
    return get_args(field.annotation) if field else ()


def _laws(place: _Place) -> str:
    return ", ".join(law for m in _models(place.expected) for law in _law(m))


def _keys(section: type[BaseModel] | None) -> list[str]:
    return list(section.model_fields) if section else []


def _words(expected: Any) -> str:
    if get_origin(expected) is Literal:
        return ", ".join(get_args(expected))
    for choice in (expected, *get_args(expected)):
        if isinstance(choice, type) and issubclass(choice, StrEnum):
            return ", ".join(choice)
    return "another word"


def _expectation(expected: Any) -> str:
    """Return what a field wants, in words."""
    if isinstance(expected, Kind):
        return f"{expected.name}, such as {expected.example}"
    if forms := _forms(expected):
        return ", or ".join(map(_expectation, forms.values()))
    models = _models(expected)
    if len(models) == 1 and issubclass(models[0], Stated):
        return _expectation(_wanted(models[0].model_fields["value"]))
    if len(models) == 1:
        keys = ", ".join(_keys(models[0]))
        return f"a mapping with the keys {keys}" if keys else "an empty mapping, {}"
    if models:
        return "a mapping with the key law and those of that law"
    if get_origin(expected) is tuple:
        return "a list, each entry with a leading '- '"
    if expected is str:
        return "a text"
    return f"one of {_words(expected)}"


def _found(path: Path, document: Document) -> str:
    """Return what stands at a path, as written."""
    value = document.raw(path)
    if isinstance(value, dict) and "value" in value:
        value = value["value"]
    if value is None:
        return "nothing"
    if isinstance(value, dict):
        return "a mapping"
    return "a list" if isinstance(value, list) else f"'{document.text(path) or value}'"

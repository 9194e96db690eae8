"""A value as a case file states it: bare, or with its source and a note."""

from __future__ import annotations

from typing import Any, Generic, TypeVar

from pydantic import BaseModel, ConfigDict, model_serializer, model_validator

from coupling_design.case.case import Source

Value = TypeVar("Value")


class Section(BaseModel):
    """A mapping of the file: knows its keys and refuses others."""

    model_config = ConfigDict(extra="forbid", frozen=True, coerce_numbers_to_str=True)


class Stated(Section, Generic[Value]):
    """A value, `0.28 mm` or `{value: 0.28 mm, source: paper, note: ...}`.

    Dumping a section that holds it gives the bare SI value.
    """

    value: Value
    source: Source | None = None
    note: str = ""

    @model_validator(mode="before")
    @classmethod
    def _wrap_bare(cls, written: Any) -> Any:
        return written if isinstance(written, dict) else {"value": written}

    @model_serializer
    def _bare(self) -> Value:
        return self.value

"""A value as a case file states it: bare, or with its source and a note."""

from __future__ import annotations

from typing import Any, Generic, TypeVar

from pydantic import (
    BaseModel,
    ConfigDict,
    GetJsonSchemaHandler,
    model_serializer,
    model_validator,
)
from pydantic.json_schema import JsonSchemaValue
from pydantic_core import CoreSchema

from coupling_design.machine.words import Source

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

    @classmethod
    def __get_pydantic_json_schema__(
        cls, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> JsonSchemaValue:
        """Describe to an editor both ways to state a value."""
        mapping = handler.resolve_ref_schema(handler(schema))
        value = mapping["properties"]["value"]
        both = {"anyOf": [value, {**mapping, "title": "value with its source"}]}
        about = value.get("description")
        return {"description": about, **both} if about else both

    @model_serializer
    def _bare(self) -> Value:
        return self.value

"""The shape of a case file as JSON Schema, for editors.

It has the form only: which keys, and how values are written. Limits of quantities and
what holds between values is for `check` to say.
"""

from __future__ import annotations

import json
import re
from typing import Any

from pydantic.json_schema import GenerateJsonSchema, JsonSchemaValue
from pydantic_core import core_schema

from coupling_design.case.schema.machine import CaseSection

_DIALECT = "https://json-schema.org/draft/2020-12/schema"
# What pydantic calls a stated quantity, before its number.
_QUANTITY = re.compile(r"coupling_design\w*__Stated_Annotated_float__Kind_*(\d+)")


def case_schema() -> dict[str, Any]:
    """Return the JSON Schema of a case file."""
    schema = CaseSection.model_json_schema(schema_generator=_Writer)
    schema["properties"]["bearings"] |= {"minItems": 2, "maxItems": 2}
    described = {"$schema": _DIALECT, **schema, "title": "coupling_design case"}
    renamed: dict[str, Any] = json.loads(
        _QUANTITY.sub(r"Quantity\1", json.dumps(described))
    )
    return renamed


class _Writer(GenerateJsonSchema):
    """pydantic's writer, for files in which 6318 is as good a text as '6318'.

    A key without a value is an error in a case file, so null is never allowed.
    """

    def str_schema(self, schema: core_schema.StringSchema) -> JsonSchemaValue:
        written = super().str_schema(schema)
        return {**written, "type": ["string", "number"]}

    def nullable_schema(self, schema: core_schema.NullableSchema) -> JsonSchemaValue:
        return self.generate_inner(schema["schema"])

    def default_schema(self, schema: core_schema.WithDefaultSchema) -> JsonSchemaValue:
        written = super().default_schema(schema)
        if written.get("default", "") is None:
            del written["default"]
        return written

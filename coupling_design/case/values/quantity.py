"""Numbers with units as engineers write them, turned into SI floats once."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, replace
from typing import Any

from pydantic import GetCoreSchemaHandler, GetJsonSchemaHandler
from pydantic.json_schema import JsonSchemaValue
from pydantic_core import CoreSchema, PydanticCustomError, core_schema

from coupling_design.case.values.units import UnitError, describe, from_si, to_si

_WRITTEN = re.compile(
    r"\s*(?P<number>[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)(?P<unit>.*)", re.DOTALL
)
# 1,500 rpm and 0,28 mm: a comma before three digits each time, or another.
_THOUSANDS = re.compile(r"\s*[+-]?[1-9]\d{0,2}(,\d{3})+(\.\d*)?(?!\d).*", re.DOTALL)
_DECIMAL_COMMA = re.compile(r"\s*[+-]?\d+,\d+.*", re.DOTALL)
# The same for JSON Schema: a number, and with a unit.
_PATTERN = r"^\s*[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?"
_UNIT = r"\s*[A-Za-zµμ°%1]"


class QuantityError(ValueError):
    """What is wrong with a written quantity, as a sentence without its subject."""


@dataclass(frozen=True)
class Kind:
    """A physical kind: what a value must be, in which SI unit, within which limits.

    Used as pydantic metadata: `Annotated[float, LENGTH]` reads `0.28 mm`. `remark`
    is a sentence that helps who wrote a value out of range.
    """

    name: str
    unit: str
    example: str
    lower: float = -math.inf
    upper: float = math.inf
    excludes_lower: bool = False
    remark: str = ""
    other_unit: str = ""  # a second SI unit that says the same of another law

    def unit_of(self, written: str) -> str:
        """Return the SI unit of a text that `parse` takes: `unit`, or the other one."""
        match = _WRITTEN.fullmatch(written) if self.other_unit else None
        own = match and match["unit"].strip()
        if own and to_si(1.0, own, self.unit) is None:
            return self.other_unit
        return self.unit

    def positive(self) -> Kind:
        """Return this kind restricted to values above zero."""
        return replace(self, lower=0.0, excludes_lower=True)

    def non_negative(self) -> Kind:
        """Return this kind restricted to zero and above."""
        return replace(self, lower=0.0)

    def between(self, lower: float, upper: float) -> Kind:
        """Return this kind restricted to the closed range, in SI."""
        return replace(self, lower=lower, upper=upper)

    def parse(self, written: Any) -> float:
        """Return the SI value of what is written, or raise `QuantityError`."""
        number, unit = self._split(written)
        value = self._convert(number, unit)
        if not math.isfinite(value):
            raise QuantityError(f"allowed are finite numbers, such as {self.example}")
        self._check_range(value, unit)
        return value

    def _split(self, written: Any) -> tuple[float, str]:
        if isinstance(written, bool):
            raise QuantityError(
                f"expected {self.name}, such as {self.example}; "
                "YAML reads yes, no, on and off as true and false"
            )
        if isinstance(written, int | float):
            return _to_float(written), ""
        if not isinstance(written, str):
            raise QuantityError(f"expected {self.name}, such as {self.example}")
        match = _WRITTEN.fullmatch(written)
        if match is None:
            raise QuantityError(
                f"expected {self.name}: a number"
                f"{' and a unit' if self.unit else ''}, such as {self.example}"
            )
        self._refuse_commas(written)
        return float(match["number"]), match["unit"].strip()

    @staticmethod
    def _refuse_commas(written: str) -> None:
        """Raise where a comma stands in a number, with the spelling that is meant."""
        if _THOUSANDS.fullmatch(written):
            meant = written.replace(",", "").strip()
            raise QuantityError(f"thousands take no comma: write {meant}")
        if _DECIMAL_COMMA.fullmatch(written):
            meant = written.replace(",", ".").strip()
            raise QuantityError(f"write the decimal mark as a point: {meant}")

    def _convert(self, number: float, unit: str) -> float:
        if not unit:
            if not self.unit or not math.isfinite(number):
                return number
            raise QuantityError(
                f"a unit is needed: write {self.name} with its unit, "
                f"such as {self.example}"
            )
        if unit.startswith(","):
            raise QuantityError("write the decimal mark as a point, such as 1.5")
        try:
            converted = to_si(number, unit, self.unit)
        except UnitError as error:
            raise QuantityError(
                f"{error}; write {self.name} as a number and a unit, "
                f"such as {self.example}"
            ) from None
        if converted is None and self.other_unit:
            converted = to_si(number, unit, self.other_unit)
        if converted is None:
            raise QuantityError(self._wrong_dimension(unit))
        return converted

    def _wrong_dimension(self, unit: str) -> str:
        found = describe(unit)
        hint = ""
        if self.unit == "rad/s" and found == describe("1/s"):
            hint = "; write turns per minute as rpm, or multiply Hz by 2 pi for rad/s"
        if self.unit == "N*m/rad" and found == describe("N*m"):
            hint = "; write the angle too"
        return f"that is {found}, expected {self.name}, such as {self.example}{hint}"

    def _check_range(self, value: float, unit: str) -> None:
        too_low = exceeds(self.lower, value) or (
            self.excludes_lower and value == self.lower
        )
        if not too_low and not exceeds(value, self.upper):
            return
        lower, upper = (_in_unit(limit, unit) for limit in (self.lower, self.upper))
        if self.upper < math.inf:
            allowed = f"{lower} to {upper}"
        elif self.excludes_lower:
            allowed = f"more than {lower}"
        else:
            allowed = f"{lower} or more"
        remark = f". {self.remark}" if self.remark else ""
        raise QuantityError(f"allowed {allowed}{remark}")

    def __get_pydantic_core_schema__(
        self, source: Any, handler: GetCoreSchemaHandler
    ) -> CoreSchema:
        """Let pydantic read a field annotated with this kind by `parse`."""
        return core_schema.no_info_plain_validator_function(self._validate)

    def __get_pydantic_json_schema__(
        self, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> JsonSchemaValue:
        """Describe to an editor how this kind is written; limits stay with `parse`."""
        text = {"type": "string", "pattern": _PATTERN + (_UNIT if self.unit else "")}
        described = {
            "description": f"{self.name}, such as {self.example}",
            "examples": self.example.split(" or "),
        }
        if self.unit:
            return {**text, **described}
        return {"anyOf": [{"type": "number"}, text], **described}

    def _validate(self, written: Any) -> float:
        try:
            return self.parse(written)
        except QuantityError as error:
            raise PydanticCustomError(
                "quantity", "{sentence}", {"sentence": str(error)}
            ) from None


@dataclass(frozen=True)
class KindOrWord(Kind):
    """A kind that one word may stand for; the word stays a text."""

    word: str = ""

    def parse(self, written: Any) -> Any:
        """Return the word, or the SI value of what is written."""
        if isinstance(written, str) and " ".join(written.split()) == self.word:
            return self.word
        return super().parse(written)

    def __get_pydantic_json_schema__(
        self, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> JsonSchemaValue:
        """Describe to an editor the word beside how this kind is written."""
        plain = super().__get_pydantic_json_schema__(schema, handler)
        about = {key: plain.pop(key) for key in ("description", "examples")}
        return {"anyOf": [plain, {"const": self.word}], **about}


@dataclass(frozen=True)
class RelativeDampingKind(Kind):
    """DIN 740's psi: no more work is lost in a cycle than 2 pi times what is stored.

    Sheets print the magnifier M = 2 pi / psi beside it.
    """

    def _check_range(self, value: float, unit: str) -> None:
        if exceeds(value, self.upper):
            raise QuantityError(
                f"allowed up to 2 pi; it may be the magnifier M of a sheet: then psi = "
                f"2 pi / M, here {2 * math.pi / value:.3g}"
            )
        super()._check_range(value, unit)


def exceeds(value: float, limit: float) -> bool:
    """Return whether a value is above a limit by more than a unit's rounding."""
    return value > limit and not math.isclose(value, limit, rel_tol=1e-9)


def _to_float(written: float) -> float:
    try:
        return float(written)
    except OverflowError:
        return math.inf


def _in_unit(limit: float, unit: str) -> str:
    """Return an SI limit as the user would write it, in the unit he chose."""
    return f"{from_si(limit, unit):g} {unit}" if unit else f"{limit:g}"

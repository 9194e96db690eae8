"""A value held against its limit."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from enum import StrEnum


class Sense(StrEnum):
    """Which side of its limit a value must lie on."""

    AT_MOST = "<="
    AT_LEAST = ">="


class Verdict(StrEnum):
    """What became of a limit; one whose input is missing is never kept."""

    PASS = "pass"
    FAIL = "fail"
    NOT_CHECKED = "not checked"


@dataclass(frozen=True)
class Criterion:
    """A value held against its limit, or why it could not be.

    `margin` is the distance to the limit relative to it, positive on the good side;
    `unit` is SI; `source` says where the limit comes from, or what is missing. Value,
    limit and margin are None where they are not known.
    """

    name: str
    value: float | None
    limit: float | None
    sense: Sense
    unit: str
    verdict: Verdict
    margin: float | None
    source: str

    @property
    def passes(self) -> bool:
        """Whether it was checked and is kept."""
        return self.verdict is Verdict.PASS

    @property
    def fails(self) -> bool:
        """Whether it was checked and is not kept."""
        return self.verdict is Verdict.FAIL


def held(
    name: str,
    value: float,
    limit: float,
    excess: float,
    *,
    unit: str,
    source: str,
    sense: Sense = Sense.AT_MOST,
) -> Criterion:
    """Return a value held against its limit, `excess` beyond it relative to it."""
    return Criterion(
        name=name,
        value=value,
        limit=limit,
        sense=sense,
        unit=unit,
        verdict=Verdict.FAIL if excess > 0.0 else Verdict.PASS,
        margin=-excess + 0.0,
        source=source,
    )


def not_checked(
    name: str, *, unit: str, missing: str, value: float | None = None
) -> Criterion:
    """Return a limit that could not be checked; `missing` says what the case lacks."""
    return Criterion(
        name=name,
        value=value,
        limit=None,
        sense=Sense.AT_MOST,
        unit=unit,
        verdict=Verdict.NOT_CHECKED,
        margin=None,
        source=missing,
    )


def none_fails(criteria: Iterable[Criterion]) -> bool:
    """Return whether every limit that could be checked is kept."""
    return not any(criterion.fails for criterion in criteria)

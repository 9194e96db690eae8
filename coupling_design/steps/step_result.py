"""What one step of the flow asked and found: plain frozen values in SI."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

from coupling_design.parts.criterion import Criterion
from coupling_design.search.design_map import DesignMap
from coupling_design.search.optimum import Optimum
from coupling_design.wear.performance import Performance


class Decision(StrEnum):
    """How a step of the flow ended."""

    PASS = "pass"
    FAIL = "fail"
    SKIPPED = "skipped"


@dataclass(frozen=True)
class Alternative:
    """One line of what a step examined: a candidate, how it fared, and why."""

    name: str
    passes: bool
    performance: Performance | None
    remark: str


@dataclass(frozen=True)
class StepResult:
    """What one step of the flow asked and found.

    `findings` are sentences on what was examined, `caveats` on what to be wary of.
    """

    step: int
    title: str
    question: str
    decision: Decision
    criteria: tuple[Criterion, ...] = ()
    alternatives: tuple[Alternative, ...] = ()
    findings: tuple[str, ...] = ()
    caveats: tuple[str, ...] = ()
    optimum: Optimum | None = None
    maps: tuple[DesignMap, ...] = ()

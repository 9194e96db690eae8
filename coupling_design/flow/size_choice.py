"""What the sizes of a catalogue came to: plain frozen values in SI."""

from __future__ import annotations

from dataclasses import dataclass

from coupling_design.machine.coupling_size import CatalogueFile, CouplingSize
from coupling_design.parts.criterion import Criterion
from coupling_design.wear.performance import Performance


@dataclass(frozen=True)
class SizeTrial:
    """One size in the chosen connection: every limit, and how it fared.

    `performance` is None where a limit failed that needs no run-down.
    """

    size: CouplingSize
    performance: Performance | None
    criteria: tuple[Criterion, ...]
    passes: bool
    remark: str


@dataclass(frozen=True)
class CatalogueChoice:
    """The best real size beside the ideal stiffness.

    Attributes
    ----------
    files : the catalogues
    plan, connection : of the chosen design, in which the sizes were tried
    ideal_type, ideal : the continuous optimum
    trials : the sizes of that plan
    selected : the one that keeps every limit with the least damage, None if none does
    price : its damage over the ideal's, less 1 [-]; negative if it does less
    price_of_stiffness : what of that its stiffness alone makes, with the ideal's
        damping and inertias [-]
    is_chosen : whether it is the chosen design
    findings : sentences on how the sizes were tried
    """

    files: tuple[CatalogueFile, ...]
    plan: str
    connection: str
    ideal_type: str
    ideal: Performance
    trials: tuple[SizeTrial, ...]
    selected: SizeTrial | None
    price: float | None
    price_of_stiffness: float | None
    is_chosen: bool
    findings: tuple[str, ...]

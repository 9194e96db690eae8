"""From a checked section to a coupling's damping law."""

from __future__ import annotations

from coupling_design.case.schema.machine import LossFactor, Proportional, Relative
from coupling_design.line.parameters import (
    DampingLaw,
    LossFactorDamping,
    ProportionalDamping,
    RelativeDamping,
)


def build_damping_law(section: Proportional | LossFactor | Relative) -> DampingLaw:
    """Return the damping law that a file describes."""
    values = section.model_dump(exclude={"law"})
    match section:
        case Proportional():
            return ProportionalDamping(**values)
        case LossFactor():
            return LossFactorDamping(**values)
        case Relative():
            return RelativeDamping(**values)

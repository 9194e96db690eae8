"""The parts of the JSON document that appear in more than one place."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any

from coupling_design.flow.size_choice import CatalogueChoice, SizeTrial
from coupling_design.parts.criterion import Criterion, Verdict
from coupling_design.wear.performance import Performance
from coupling_design.wear.sensitivity import Sensitivity

_PASSES = {Verdict.PASS: True, Verdict.FAIL: False, Verdict.NOT_CHECKED: None}


def performance_part(performance: Performance) -> dict[str, Any]:
    """Return what a design does."""
    return {
        "torsional_stiffness": float(performance.torsional_stiffness),
        "key_gap": float(performance.key_gap),
        "natural_frequency": float(performance.natural_frequency),
        "damage": performance.damage,
        "damage_e6": performance.damage * 1e6,
        "damages": [float(damage) for damage in performance.damages],
        "peak_transmission_force": float(performance.peak_transmission_force),
        "peak_combined_load": [float(f) for f in performance.peak_combined_load],
        "spread": None
        if performance.spread is None
        else _listed(asdict(performance.spread)),
    }


def sensitivity_part(sensitivity: Sensitivity) -> dict[str, Any]:
    """Return what a design does when inputs move."""
    part = {**asdict(sensitivity), "damage_change": sensitivity.damage_change}
    return dict(_listed(part))


def _listed(part: Any) -> Any:
    """Return plain values with lists for tuples, as JSON gives them back."""
    if isinstance(part, dict):
        return {key: _listed(value) for key, value in part.items()}
    if isinstance(part, list | tuple):
        return [_listed(value) for value in part]
    return part


def criterion_part(criterion: Criterion) -> dict[str, Any]:
    """Return a value against its limit."""
    return {
        "name": criterion.name,
        "value": criterion.value,
        "limit": criterion.limit,
        "sense": criterion.sense.value,
        "unit": criterion.unit,
        "verdict": criterion.verdict.value,
        "passes": _PASSES[criterion.verdict],
        "margin": criterion.margin,
        "source": criterion.source,
    }


def catalogue_part(choice: CatalogueChoice) -> dict[str, Any]:
    """Return the sizes of the catalogues, the best of them and its price."""
    selected = choice.selected
    return {
        "files": [asdict(file) for file in choice.files],
        "plan": choice.plan,
        "connection": choice.connection,
        "ideal": {"coupling_type": choice.ideal_type, **performance_part(choice.ideal)},
        "selected": None if selected is None else selected.size.name,
        "price": choice.price,
        "price_of_stiffness": choice.price_of_stiffness,
        "is_chosen": choice.is_chosen,
        "sizes": [_size(trial) for trial in choice.trials],
        "findings": list(choice.findings),
    }


def _size(trial: SizeTrial) -> dict[str, Any]:
    performance = trial.performance
    return {
        "sheet": asdict(trial.size),
        "passes": bool(trial.passes),
        "performance": None if performance is None else performance_part(performance),
        "criteria": [criterion_part(criterion) for criterion in trial.criteria],
        "remark": trial.remark,
    }

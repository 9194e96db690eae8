"""The outcome as a JSON document: SI numbers under names that will not change."""

from __future__ import annotations

import json
import math
import operator
import platform
from dataclasses import asdict
from importlib.metadata import PackageNotFoundError, version
from typing import Any

from coupling_design import __version__
from coupling_design.flow.outcome import ChosenDesign, DesignOutcome, LoadReading
from coupling_design.report.files.json_parts import (
    catalogue_part,
    criterion_part,
    performance_part,
    sensitivity_part,
)
from coupling_design.search.design_map import DesignMap
from coupling_design.search.optimum import Optimum
from coupling_design.steps.baseline import Baseline
from coupling_design.steps.step_result import Alternative, StepResult

SCHEMA_VERSION = 1
UNITS = {
    "torsional_stiffness": "N*m/rad",
    "key_gap": "m",
    "natural_frequency": "Hz",
    "damage": "-, Miner sum of one run-down, the bearing that suffers more; mean over "
    "crank angles and directions of gravity",
    "damages": "-, of bearing 1 and bearing 2, means",
    "spread": "lowest and highest over crank angles and directions of gravity",
    "sensitivity": "damage and peak with one input at `factor` times its value",
    "reduction_range": "-, damage_reduction when inputs move, lowest and highest",
    "damage_e6": "1e-6, damage in the paper's unit",
    "damage_reduction": "-, 1 less chosen over present damage",
    "peak_transmission_force": "N",
    "peak_combined_load": "N, of bearing 1 and bearing 2",
    "permissible_transmission_force": "N",
    "resonance_speed_rpm": "rpm",
    "resonance_speed": "rad/s",
    "resonance_swing": "N",
    "rest_time": "s, null if the engine does not come to rest",
    "revolutions": "-",
    "final_speed": "rad/s",
    "out_of_range_time": "s",
    "time_step": "s",
    "largest_stable_step": "s",
    "margin": "-, distance to the limit over the limit, positive when it is kept",
    "run_time_s": "s",
    "price": "-, damage of the best catalogue size over the ideal's, less 1",
    "price_of_stiffness": "-, what of the price its stiffness alone makes",
    "nominal_torque": "N*m, T_KN",
    "maximum_torque": "N*m, T_Kmax",
    "rare_maximum_torque": "N*m, T_Kmax2",
    "vibratory_torque": "N*m, T_KW at 10 Hz",
    "power_loss": "W, P_KV",
    "maximum_speed": "rad/s, n_max",
    "driving_inertia": "kg*m^2",
    "driven_inertia": "kg*m^2",
}
_LIBRARIES = ("casadi", "numpy", "pydantic", "pint", "PyYAML", "rich")


def build_document(outcome: DesignOutcome) -> dict[str, Any]:
    """Return the outcome as plain values."""
    case, chosen, strict = outcome.case, outcome.chosen, outcome.strict_reading
    choice = outcome.catalogue_choice
    return {
        "schema_version": SCHEMA_VERSION,
        "units": UNITS,
        "case": {
            "name": case.name,
            "file": case.file,
            "sha256": case.sha256,
            "overrides": list(case.overrides),
        },
        "software": _software(),
        "inputs": {
            value.path: {"value": value.value, "unit": value.unit, "text": value.text}
            for value in case.provenance
        },
        "reading": case.reading.value,
        "baseline": _baseline(outcome.baseline),
        "steps": [_step(result) for result in outcome.steps],
        "chosen": None if chosen is None else _chosen(chosen),
        "nearest": None if outcome.nearest is None else _optimum(outcome.nearest),
        "nearest_criteria": [criterion_part(c) for c in outcome.nearest_criteria],
        "strict_reading": None if strict is None else _reading(strict),
        "fatigue_limits": [asdict(each) for each in outcome.fatigue_limits],
        "catalogue_choice": None if choice is None else catalogue_part(choice),
        "assumptions": [asdict(value) for value in outcome.assumptions],
        "warnings": list(outcome.warnings),
        "reasons": list(outcome.reasons),
        "remarks": list(outcome.remarks),
        "engine": outcome.engine,
        "rollouts": outcome.rollouts,
        "coarse_rollouts": outcome.coarse_rollouts,
        "run_time_s": outcome.run_time,
    }


def document_text(document: dict[str, Any]) -> str:
    """Return a document as strict JSON; a number that is not finite is our defect."""
    text = json.dumps(
        document,
        indent=2,
        ensure_ascii=False,
        allow_nan=False,
        default=operator.index,  # NumPy's integers, which are no int
    )
    return f"{text}\n"


def _software() -> dict[str, str | None]:
    return {
        "name": "coupling_design",
        "version": __version__,
        "python": platform.python_version(),
        **{library.lower(): _version(library) for library in _LIBRARIES},
        "platform": f"{platform.system()} {platform.machine()}",
    }


def _version(library: str) -> str | None:
    try:
        return version(library)
    except PackageNotFoundError:
        return None


def _baseline(baseline: Baseline) -> dict[str, Any]:
    return {
        "coupling_type": baseline.coupling_type,
        "connection": baseline.connection,
        **performance_part(baseline.performance),
        "resonance_speed_rpm": baseline.rundown.resonance_speed * 30 / math.pi,
        "rundown": asdict(baseline.rundown),
        "conditioning": asdict(baseline.conditioning),
        "time_step": baseline.time_step,
        "largest_stable_step": baseline.largest_stable_step,
        "sensitivity": sensitivity_part(baseline.sensitivity),
    }


def _chosen(chosen: ChosenDesign) -> dict[str, Any]:
    bound = chosen.fuel_cut_at_once
    return {
        "plan": chosen.plan.value,
        "coupling_type": chosen.coupling_type,
        "size": chosen.size,
        "connection": chosen.connection,
        **performance_part(chosen.performance),
        "damage_reduction": chosen.damage_reduction,
        "reduction_range": list(chosen.reduction_range),
        "rundown": asdict(chosen.rundown),
        "conditioning": asdict(chosen.conditioning),
        "sensitivity": sensitivity_part(chosen.sensitivity),
        "fuel_cut_at_once": None if bound is None else performance_part(bound),
    }


def _step(result: StepResult) -> dict[str, Any]:
    return {
        "step": result.step,
        "title": result.title,
        "question": result.question,
        "decision": result.decision.value,
        "criteria": [criterion_part(criterion) for criterion in result.criteria],
        "optimum": None if result.optimum is None else _optimum(result.optimum),
        "alternatives": [_alternative(each) for each in result.alternatives],
        "findings": list(result.findings),
        "caveats": list(result.caveats),
        "maps": [_map(map_) for map_ in result.maps],
    }


def _map(map_: DesignMap) -> dict[str, Any]:
    return {
        "name": map_.name,
        "torsional_stiffness": list(map_.torsional_stiffness),
        "key_gap": list(map_.key_gap),
        "damage": [list(row) for row in map_.damage],
        "peak_transmission_force": [list(row) for row in map_.peak_transmission_force],
        "coarse": None if map_.coarse is None else asdict(map_.coarse),
    }


def _optimum(optimum: Optimum) -> dict[str, Any]:
    conditioning = optimum.conditioning
    return {
        "objective": optimum.objective,
        "coupling_type": optimum.coupling_type,
        "connection": optimum.connection,
        **performance_part(optimum.performance),
        "method": optimum.method,
        "solver_status": optimum.solver_status,
        "starts": optimum.starts,
        "starts_agreeing": optimum.starts_agreeing,
        "scan_points": optimum.scan_points,
        "rollouts": optimum.rollouts,
        "kkt_residual": optimum.kkt_residual,
        "active_constraints": list(optimum.active_constraints),
        "held_by": optimum.held_by,
        "conditioning": None if conditioning is None else asdict(conditioning),
    }


def _alternative(alternative: Alternative) -> dict[str, Any]:
    performance = alternative.performance
    return {
        "name": alternative.name,
        "passes": bool(alternative.passes),
        "performance": None if performance is None else performance_part(performance),
        "remark": alternative.remark,
    }


def _reading(reading: LoadReading) -> dict[str, Any]:
    return {
        "reading": reading.reading,
        "passes": bool(reading.passes),
        "permissible_transmission_force": reading.permissible_transmission_force,
        "criteria": [criterion_part(criterion) for criterion in reading.criteria],
    }

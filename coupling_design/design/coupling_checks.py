"""A coupling against what its sheet permits, in the vocabulary of DIN 740-2.

Sources
-------
[1] DIN 740-2:1986, Flexible shaft couplings: T_KN, T_Kmax, T_KW, P_KV and the factors
    S_t (temperature), S_z (starts), S_f (frequency).
[2] FLENDER Standard Couplings, catalogue MD 10.1: T_Kmax for frequent, T_KOL (T_Kmax2)
    for rare peaks.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

from coupling_design.case.case import Case, CouplingType
from coupling_design.case.catalogue_sizes import CouplingSize
from coupling_design.design.candidate import Candidate, candidate_driveline
from coupling_design.design.performance import Criterion, Sense
from coupling_design.driveline.coupling_load import resonance_passage, working_load
from coupling_design.driveline.parameters import Driveline


def torque_criteria(case: Case, coupling_type: CouplingType) -> tuple[Criterion, ...]:
    """Return rated torque, peak torque and speed against what the type can take."""
    duty, name = case.duty, coupling_type.name
    return (
        _at_most(
            f"{name}: rated torque x service factor",
            duty.rated_torque * duty.service_factor,
            coupling_type.nominal_torque,
            "N*m",
            "nominal torque T_KN of the type",
        ),
        _at_most(
            f"{name}: peak torque",
            duty.peak_torque,
            coupling_type.maximum_torque,
            "N*m",
            "maximum torque T_Kmax of the type",
        ),
        _at_most(
            f"{name}: highest working speed",
            duty.working_speed[1],
            coupling_type.maximum_speed,
            "rad/s",
            "maximum speed of the type",
        ),
    )


def size_criteria(
    case: Case, candidate: Candidate, size: CouplingSize
) -> tuple[Criterion, ...]:
    """Return what the duty asks of a size against its sheet; [1].

    What the sheet does not give is not checked.
    """
    real = Candidate(candidate.coupling_type, candidate.connection, size)
    driveline = candidate_driveline(case, real, size.torsional_stiffness, 0.0)
    return (
        *_torques(case, size),
        *_vibration(case, size, driveline),
        _at_most(
            f"{size.name}: highest working speed",
            case.duty.working_speed[1],
            size.maximum_speed,
            "rad/s",
            "n_max of the size",
        ),
    )


def unchecked(size: CouplingSize) -> tuple[str, ...]:
    """Return what a size cannot be held against, as its sheet does not give it."""
    limits = {"T_KW": size.vibratory_torque, "P_KV": size.power_loss}
    return tuple(name for name, limit in limits.items() if limit is None)


def _torques(case: Case, size: CouplingSize) -> Iterator[Criterion]:
    duty = case.duty
    S_t = duty.temperature_factor if size.kind.is_elastomer else 1.0
    S_z = duty.start_factor
    yield _at_most(
        f"{size.name}: rated torque x service factor x S_t",
        duty.rated_torque * duty.service_factor * S_t,
        size.nominal_torque,
        "N*m",
        "nominal torque T_KN of the size (DIN 740-2)",
    )
    yield _at_most(
        f"{size.name}: peak torque x S_z x S_t",
        duty.peak_torque * S_z * S_t,
        size.maximum_torque,
        "N*m",
        "maximum torque T_Kmax of the size (DIN 740-2)",
    )
    if duty.rare_torque is not None and size.rare_maximum_torque is not None:
        yield _at_most(
            f"{size.name}: rare torque x S_t",
            duty.rare_torque * S_t,
            size.rare_maximum_torque,
            "N*m",
            "maximum torque T_Kmax2 of the size, a few times in its life",
        )


def _vibration(
    case: Case, size: CouplingSize, driveline: Driveline
) -> Iterator[Criterion]:
    duty = case.duty
    S_t = duty.temperature_factor if size.kind.is_elastomer else 1.0
    passage = resonance_passage(driveline, duty.working_speed[0])
    if passage is not None:
        yield _at_most(
            f"{size.name}: resonance with order {passage.order:g}, "
            f"{_rpm(passage.speed)} rpm, x S_z x S_t",
            passage.torque * duty.start_factor * S_t,
            size.maximum_torque,
            "N*m",
            "maximum torque T_Kmax of the size (DIN 740-2), no load, swung up in full",
        )
    load = working_load(driveline, duty.working_speed)
    if size.vibratory_torque is not None:
        yield _at_most(
            f"{size.name}: vibratory torque x S_f x S_t, "
            f"{_rpm(load.vibratory_speed)} rpm",
            load.vibratory_torque * S_t,
            size.vibratory_torque,
            "N*m",
            "vibratory torque T_KW of the size at 10 Hz (DIN 740-2)",
        )
    if size.power_loss is not None:
        yield _at_most(
            f"{size.name}: power loss, {_rpm(load.power_speed)} rpm",
            load.power_loss,
            size.power_loss,
            "W",
            "power loss P_KV of the size (DIN 740-2)",
        )


def _rpm(speed: float) -> str:
    return f"{speed * 30 / math.pi:.0f}"


def _at_most(
    name: str, value: float, limit: float, unit: str, source: str
) -> Criterion:
    return Criterion(
        name=name,
        value=value,
        limit=limit,
        sense=Sense.AT_MOST,
        unit=unit,
        passes=value <= limit,
        margin=1 - value / limit,
        source=source,
    )

"""A coupling against what its sheet permits, in the vocabulary of DIN 740-2.

A limit is checked where both sides of it are known; where one is missing it is listed
as not checked, with what is missing.

Sources
-------
[1] DIN 740-2:1986, Flexible shaft couplings: T_KN, T_Kmax, T_KW, P_KV and the factors
    S_t (temperature), S_z (starts), S_f (frequency), S_L (sudden load), mass factors.
[2] FLENDER Standard Couplings, catalogue MD 10.1: T_Kmax for frequent, T_KOL (T_Kmax2)
    for rare peaks.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

from coupling_design.line.parameters import Driveline
from coupling_design.machine.candidate import Candidate, candidate_driveline
from coupling_design.machine.coupling_size import CouplingSize
from coupling_design.machine.coupling_type import CouplingType
from coupling_design.machine.machine import Case
from coupling_design.parts.criterion import Criterion, held, not_checked
from coupling_design.speeds.coupling_load import resonance_passage, working_load

_MOTORED = "; motored orders, the fired are larger"


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
        *_without_sheet(name),
    )


def size_criteria(
    case: Case, candidate: Candidate, size: CouplingSize
) -> tuple[Criterion, ...]:
    """Return what the duty asks of a size against its sheet; [1]."""
    real = Candidate(candidate.coupling_type, candidate.connection, size)
    driveline = candidate_driveline(case, real, size.torsional_stiffness, 0.0)
    return (
        *_torques(case, size),
        _rare_torque(case, size, driveline),
        *_vibration(case, size, driveline),
        _at_most(
            f"{size.name}: highest working speed",
            case.duty.working_speed[1],
            size.maximum_speed,
            "rad/s",
            "n_max of the size",
        ),
    )


def short_circuit_torque(case: Case, driveline: Driveline) -> float | None:
    """Return what a short circuit puts into the coupling [N m], None if not stated.

    [1], load side: the air gap's torque acts on the generator, of which the engine's
    share of the inertia passes the coupling, J_e / (J_e + J_g), times S_L. It is the
    bound for a torque that steps up and stays; of one that alternates at grid frequency
    a soft coupling takes less.
    """
    event = case.duty.short_circuit
    if event is None:
        return None
    J_e = driveline.engine_inertia
    J_g = driveline.coupling_inertia + driveline.generator_inertia
    return float(event.air_gap_torque * J_e / (J_e + J_g) * event.sudden_load_factor)


def _without_sheet(name: str) -> Iterator[Criterion]:
    for what, limit, unit in (
        ("short circuit", "T_Kmax2", "N*m"),
        ("vibratory torque", "T_KW", "N*m"),
        ("power loss", "P_KV", "W"),
    ):
        missing = f"a coupling type has no {limit}; a catalogue's size may have one"
        yield not_checked(f"{name}: {what}", unit=unit, missing=missing)


def _torques(case: Case, size: CouplingSize) -> Iterator[Criterion]:
    duty = case.duty
    S_t, S_z = _temperature(case, size), duty.start_factor
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


def _rare_torque(case: Case, size: CouplingSize, driveline: Driveline) -> Criterion:
    """Return the short circuit against T_Kmax2, by its own data or as stated bare."""
    duty, S_t = case.duty, _temperature(case, size)
    torque = short_circuit_torque(case, driveline)
    name = f"{size.name}: short circuit, air gap x J_e/(J_e + J_g) x S_L x S_t"
    origin = "T_Kmax2 of the size, a few times in its life (DIN 740-2, load side)"
    if torque is None and duty.rare_torque is not None:
        torque = duty.rare_torque
        name = f"{size.name}: rare torque x S_t"
        origin = (
            "T_Kmax2 of the size; the torque as stated, taken to act in the coupling "
            "whatever the inertias"
        )
    if torque is None:
        missing = "the case states neither duty.short_circuit nor duty.rare_torque"
        return not_checked(f"{size.name}: short circuit", unit="N*m", missing=missing)
    if size.rare_maximum_torque is None:
        missing = "the sheet of the size gives no T_Kmax2"
        return not_checked(name, unit="N*m", missing=missing, value=torque * S_t)
    return _at_most(name, torque * S_t, size.rare_maximum_torque, "N*m", origin)


def _vibration(
    case: Case, size: CouplingSize, driveline: Driveline
) -> Iterator[Criterion]:
    duty, S_t = case.duty, _temperature(case, size)
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
    working = replace(driveline, excitation=case.working_excitation)
    load = working_load(working, duty.working_speed)
    orders = "" if case.works_fired else _MOTORED
    yield _or_not_checked(
        f"{size.name}: vibratory torque x S_f x S_t, "
        f"{_rpm(load.vibratory_speed)} rpm{orders}",
        load.vibratory_torque * S_t,
        size.vibratory_torque,
        "N*m",
        "T_KW",
        "vibratory torque T_KW of the size at 10 Hz (DIN 740-2)",
    )
    yield _or_not_checked(
        f"{size.name}: power loss, {_rpm(load.power_speed)} rpm{orders}",
        load.power_loss,
        size.power_loss,
        "W",
        "P_KV",
        "power loss P_KV of the size (DIN 740-2)",
    )


def _temperature(case: Case, size: CouplingSize) -> float:
    return case.duty.temperature_factor if size.kind.is_elastomer else 1.0


def _rpm(speed: float) -> str:
    return f"{speed * 30 / math.pi:.0f}"


def _or_not_checked(
    name: str, value: float, limit: float | None, unit: str, symbol: str, source: str
) -> Criterion:
    if limit is None:
        missing = f"the sheet of the size gives no {symbol}"
        return not_checked(name, unit=unit, missing=missing, value=value)
    return _at_most(name, value, limit, unit, source)


def _at_most(
    name: str, value: float, limit: float, unit: str, source: str
) -> Criterion:
    return held(name, value, limit, value / limit - 1, unit=unit, source=source)

"""From checked sections to what a set works at, and what drives it there."""

from __future__ import annotations

from coupling_design.case.build.engine import at_work, build_engine, excitation_of
from coupling_design.case.schema.duty import DutySection, ShortCircuitSection
from coupling_design.case.schema.engine import (
    EngineExcitation,
    EngineMode,
    WorkingEngineExcitation,
)
from coupling_design.case.schema.machine import CaseSection, DrivelineSection
from coupling_design.case.values.stated import Stated
from coupling_design.engine import first_crank_mode
from coupling_design.line.parameters import ExcitationOrder
from coupling_design.machine.duty import Duty, ShortCircuit
from coupling_design.machine.sourced_value import SourcedValue


def build_duty(section: DutySection) -> Duty:
    """Return what a set works at; factors that are not given are 1."""
    speeds = section.working_speed
    return Duty(
        working_speed=(speeds.lowest.value, speeds.highest.value),
        rated_torque=section.rated_torque.value,
        peak_torque=section.peak_torque.value,
        service_factor=section.service_factor.value,
        rare_torque=plain(section.rare_torque),
        temperature_factor=plain(section.temperature_factor) or 1.0,
        start_factor=plain(section.start_factor) or 1.0,
        short_circuit=_short_circuit(section.short_circuit),
    )


def working_excitation(
    section: CaseSection, file: str
) -> tuple[tuple[ExcitationOrder, ...], tuple[SourcedValue, ...]]:
    """Return the orders at working speed, none if not given, and what was derived."""
    working, engine = section.duty.excitation, section.driveline.excitation
    if working is None:
        return (), ()
    if isinstance(working, WorkingEngineExcitation):
        if not isinstance(engine, EngineExcitation):
            return (), ()  # refused by the relations
        changed = at_work(engine.engine, working.engine)
        return excitation_of(changed, file, "duty.excitation")
    return tuple(ExcitationOrder(**order.model_dump()) for order in working), ()


def works_fired(section: CaseSection) -> bool:
    """Return whether the orders at working speed are a fired engine's.

    Those written down for it are taken to be.
    """
    working, engine = section.duty.excitation, section.driveline.excitation
    if isinstance(working, WorkingEngineExcitation):
        return working.engine.mode.value is EngineMode.FIRED
    if working is not None:
        return True
    if isinstance(engine, EngineExcitation):
        return engine.engine.mode.value is EngineMode.FIRED
    return False


def crank_mode_of(section: DrivelineSection, file: str) -> float | None:
    """Return the estimated first mode of a described engine's crank [Hz]."""
    if not isinstance(section.excitation, EngineExcitation):
        return None
    described = section.excitation.engine
    is_v = described.bank_angle is not None
    return first_crank_mode(build_engine(described, file), is_v=is_v)


def _short_circuit(section: ShortCircuitSection | None) -> ShortCircuit | None:
    return None if section is None else ShortCircuit(**section.model_dump())


def plain(stated: Stated[float] | None) -> float | None:
    """Return a value without its source, None if it is not given."""
    return None if stated is None else stated.value

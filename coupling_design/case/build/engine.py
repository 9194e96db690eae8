"""From an engine in a case file to the orders of its torque."""

from __future__ import annotations

import math

from coupling_design.case.build.pressure_file import load_trace
from coupling_design.case.schema.engine import (
    EngineMode,
    EngineSection,
    WorkingEngine,
)
from coupling_design.engine import (
    Arrangement,
    Charge,
    Cylinder,
    Engine,
    IndicatedCombustion,
    PressureTrace,
    TorqueOrder,
    engine_figures,
    engine_orders,
    firing_angles,
)
from coupling_design.line.parameters import ExcitationOrder
from coupling_design.machine.sourced_value import SourcedValue
from coupling_design.machine.words import Source

CRANKCASE_PRESSURE = 1e5  # unless given: the atmosphere's [Pa]
THRESHOLD = 0.01  # unless given: share of the largest order


def build_arrangement(section: EngineSection) -> Arrangement:
    """Return which cylinder fires when; nothing of it is checked."""
    bank, throws = section.bank_angle, section.crank_angles
    intervals = section.firing_intervals
    return Arrangement(
        cylinders=round(section.cylinders.value),
        firing_order=section.firing_order.value,
        bank_angle=bank.value if bank else None,
        firing_intervals=intervals.value if intervals else None,
        crank_angles=throws.value if throws else None,
    )


def build_engine(section: EngineSection, case_file: str) -> Engine:
    """Return the engine; raise CaseError if its firing or its trace is at fault."""
    arrangement = build_arrangement(section)
    compression = section.polytropic_exponent
    crankcase = section.crankcase_pressure
    cylinder = section.model_dump(include=set(Cylinder.__dataclass_fields__))
    missing = section.misfiring_cylinders
    return Engine(
        cylinder=Cylinder(**cylinder),
        charge=Charge(
            intake_pressure=section.intake_pressure.value,
            crankcase_pressure=crankcase.value if crankcase else CRANKCASE_PRESSURE,
            compression_exponent=compression.value,
            expansion_exponent=(section.expansion_exponent or compression).value,
        ),
        cycle=section.cycle.value,
        firing_angles=firing_angles(arrangement, section.cycle.value),
        reference_speed=section.reference_speed.value,
        combustion=_combustion(section, case_file),
        misfiring=tuple(map(arrangement.names.index, missing.value if missing else ())),
    )


def _combustion(
    section: EngineSection, case_file: str
) -> IndicatedCombustion | PressureTrace | None:
    if section.mode.value is EngineMode.MOTORED:
        return None
    if section.pressure_trace:
        return load_trace(section.pressure_trace.value, case_file, section.cycle.value)
    if section.indicated_mean_pressure is None:
        return None
    burning = section.combustion.model_dump() if section.combustion else {}
    return IndicatedCombustion(section.indicated_mean_pressure.value, **burning)


def kept_orders(section: EngineSection, engine: Engine) -> tuple[TorqueOrder, ...]:
    """Return the orders that the section says to keep."""
    share = section.threshold.value if section.threshold else THRESHOLD
    return engine_orders(engine, section.highest_order.value, share)


def at_work(section: EngineSection, working: WorkingEngine) -> EngineSection:
    """Return an engine's section with what differs at working speed."""
    changed = {
        name: getattr(working, name)
        for name in type(working).model_fields
        if getattr(working, name) is not None
    }
    return section.model_copy(update=changed)


def excitation_of(
    section: EngineSection, case_file: str, path: str = "driveline.excitation"
) -> tuple[tuple[ExcitationOrder, ...], tuple[SourcedValue, ...]]:
    """Return an engine's excitation, and what was derived for the case's list."""
    engine = build_engine(section, case_file)
    orders = tuple(
        ExcitationOrder(order.order, order.amplitude, order.phase)
        for order in kept_orders(section, engine)
    )
    figures = engine_figures(engine)
    derived = [
        _derived(f"{path}.engine.peak_pressure", figures.peak_pressure, "Pa"),
        _derived(f"{path}.engine.mean_torque", figures.mean_torque, "N*m"),
    ]
    if isinstance(engine.combustion, PressureTrace):
        reached = figures.indicated_mean_pressure
        derived.append(
            _derived(f"{path}.engine.indicated_mean_pressure", reached, "Pa")
        )
    for index, order in enumerate(orders):
        entry = f"{path}[{index}]"
        derived += [
            _derived(f"{entry}.order", order.order, ""),
            _derived(f"{entry}.amplitude", order.amplitude, "N*m"),
            _derived(f"{entry}.phase", order.phase, "rad"),
        ]
    return orders, tuple(derived)


def _derived(path: str, value: float, unit: str) -> SourcedValue:
    shown = {"Pa": (value / 1e5, "bar"), "rad": (math.degrees(value), "deg")}
    number, written = shown.get(unit, (value, unit))
    return SourcedValue(
        path=path,
        text=f"{round(number, 9) + 0.0:.6g} {written}".strip(),
        value=value,
        unit=unit,
        source=Source.DERIVED,
        note=f"worked out from {path.partition('.excitation')[0]}.excitation.engine",
    )

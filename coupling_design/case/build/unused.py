"""Values of a case that nothing uses in this run, by path and with the reason."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from coupling_design.case.schema.engine import (
    EngineExcitation,
    EngineMode,
    EngineSection,
    WorkingEngine,
    WorkingEngineExcitation,
)
from coupling_design.case.schema.machine import CaseSection
from coupling_design.machine.coupling_type import CouplingType
from coupling_design.machine.words import ConnectionKind

_FUEL = ("indicated_mean_pressure", "combustion", "pressure_trace")
_MOTORED = "the engine is motored, its fuel is off"


def unused_values(
    section: CaseSection, coupling_types: Sequence[CouplingType]
) -> Iterator[tuple[str, str]]:
    """Yield each value that is given and used by nothing: its path, and why."""
    yield from _engine(section)
    yield from _catalogue(section, coupling_types)
    yield from _contact(section)


def _engine(section: CaseSection) -> Iterator[tuple[str, str]]:
    excitation, working = section.driveline.excitation, section.duty.excitation
    if isinstance(excitation, EngineExcitation):
        at_work = isinstance(working, WorkingEngineExcitation)
        fires_at_work = (
            isinstance(working, WorkingEngineExcitation)
            and working.engine.mode.value is EngineMode.FIRED
        )
        if not fires_at_work:
            yield from _idle(excitation.engine, "driveline.excitation.engine")
        elif not at_work:
            return
    if isinstance(working, WorkingEngineExcitation):
        yield from _idle(working.engine, "duty.excitation.engine")


def _idle(
    engine: EngineSection | WorkingEngine, path: str
) -> Iterator[tuple[str, str]]:
    """Yield what a motored engine has of fuel, and what a trace stands in for."""
    if engine.mode.value is EngineMode.MOTORED:
        for name in (*_FUEL, "misfiring_cylinders"):
            if getattr(engine, name) is not None:
                yield f"{path}.{name}", _MOTORED
    elif engine.pressure_trace is not None and engine.combustion is not None:
        yield f"{path}.combustion", "the pressure is that of the trace"


def _catalogue(
    section: CaseSection, coupling_types: Sequence[CouplingType]
) -> Iterator[tuple[str, str]]:
    sizes = [size for each in coupling_types for size in each.sizes]
    duty, coupling = section.duty, section.driveline.coupling
    if duty.temperature_factor and not any(size.kind.is_elastomer for size in sizes):
        yield "duty.temperature_factor", "no catalogue size is of rubber or the like"
    if duty.start_factor and not sizes:
        yield "duty.start_factor", "it weighs the peak torque of catalogue sizes alone"
    if coupling.driving_inertia and not any(size.driving_inertia for size in sizes):
        yield (
            "driveline.coupling.driving_inertia",
            "no catalogue size states a driving inertia to put in its place",
        )
    if duty.rare_torque and duty.short_circuit:
        yield "duty.rare_torque", "duty.short_circuit says what it follows from"
    elif (duty.rare_torque or duty.short_circuit) and not sizes:
        name = "rare_torque" if duty.rare_torque else "short_circuit"
        yield f"duty.{name}", "only a catalogue size has a T_Kmax2 to hold it against"


def _contact(section: CaseSection) -> Iterator[tuple[str, str]]:
    connection = section.driveline.connection
    offered = section.design_space.connections
    if connection.kind.value is not ConnectionKind.TIGHT_FIT:
        return
    if offered.key is None and offered.spline is None:
        for name in ("contact_stiffness", "oil_damping", "smoothing"):
            if getattr(connection, name) is not None:
                yield (
                    f"driveline.connection.{name}",
                    "the set has a tight fit, and nothing else is offered",
                )

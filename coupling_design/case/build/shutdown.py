"""From a checked section to the run-down it describes."""

from __future__ import annotations

from coupling_design.case.schema.engine import EngineExcitation
from coupling_design.case.schema.machine import DrivelineSection
from coupling_design.case.schema.shutdown import FuelCutSection, ShutdownSection
from coupling_design.engine import Cycle
from coupling_design.line.parameters import (
    FuelCutStart,
    QuasiSteadyStart,
    SettledStart,
    Shutdown,
    Start,
)
from coupling_design.machine.words import StartWord


def build_shutdown(section: ShutdownSection, driveline: DrivelineSection) -> Shutdown:
    """Return the run-down; what is not given is as `Shutdown` has it."""
    given = {
        name: stated.value
        for name in ("crank_angle", "gravity_angle")
        if (stated := getattr(section, name)) is not None
    }
    if section.crank_angles is not None:
        given["crank_angles"] = round(section.crank_angles.value)
    return Shutdown(
        initial_speed=section.initial_speed.value,
        duration=section.duration.value,
        time_step=section.time_step.value,
        start=_start(section, driveline),
        **given,
    )


def _start(section: ShutdownSection, driveline: DrivelineSection) -> Start:
    start = section.start
    if isinstance(start, FuelCutSection):
        over = start.fuel_cut.over.value
        if isinstance(over, str):
            over = cycle_time(section.initial_speed.value, driveline)
        return FuelCutStart(over)
    if start is not None and start.value is StartWord.QUASI_STEADY:
        return QuasiSteadyStart()
    return SettledStart()


def cycle_time(speed: float, driveline: DrivelineSection) -> float:
    """Return how long a working cycle takes at a mean speed [rad/s], in [s].

    Four strokes, unless the case describes an engine of two.
    """
    cycle, excitation = Cycle.FOUR_STROKE, driveline.excitation
    if isinstance(excitation, EngineExcitation):
        cycle = excitation.engine.cycle.value
    return cycle.angle / speed

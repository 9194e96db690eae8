"""What tells an engineer whether the engine he described is the one he has."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from coupling_design.engine.parameters import Engine
from coupling_design.engine.pressure import (
    cycle_angles,
    cylinder_pressure,
    mean_pressure,
)
from coupling_design.engine.torque import engine_torque


@dataclass(frozen=True)
class EngineFigures:
    """Pressures of a cylinder that fires [Pa], and of the engine the torque [N m].

    `mean_torque` is indicated, friction not taken off; the orders leave it out.
    """

    peak_pressure: float
    indicated_mean_pressure: float
    mean_torque: float


def engine_figures(engine: Engine) -> EngineFigures:
    """Return the figures of an engine; motored ones where no fuel is burnt."""
    angles = cycle_angles(engine.cycle)
    pressures = cylinder_pressure(angles, engine, fires=True)
    return EngineFigures(
        peak_pressure=float(pressures.max()),
        indicated_mean_pressure=mean_pressure(pressures, engine),
        mean_torque=float(np.mean(engine_torque(angles, engine))),
    )

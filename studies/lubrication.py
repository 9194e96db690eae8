"""Lubrication, loads and life of the bearings over the run-down: figures 6, 7 and 8.

Claims: lubrication is ideal at the highest speed and poor at low speeds; e_C follows
kappa; only bearing 1 ever carries F_min; a_ISO and L_p fall in stages I and II.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray
from rich.table import Table

from coupling_design.arithmetic import FloatArray
from coupling_design.machine.machine import Case
from coupling_design.parts.bearing.contact_stress import minimum_load
from coupling_design.parts.bearing.life import (
    basic_rating_life,
    life_modification_factor,
)
from coupling_design.parts.bearing.loads import combined_loads
from coupling_design.parts.bearing.lubrication import (
    contamination_factor,
    unclamped_viscosity_ratio,
    viscosity_ratio,
)
from coupling_design.parts.bearing.modified_life import modified_rating_life
from coupling_design.report.words.numbers import significant
from coupling_design.signals.detrending import resonance_fluctuation
from coupling_design.signals.history import History
from studies.command import Study, leave, table
from studies.lubrication_figures import draw_life, draw_loads, draw_lubrication
from studies.machine import present_history, present_performance

RPM = 30 / math.pi


@dataclass(frozen=True)
class Lives:
    """Bearing 1's life indices and both bearings' loads over a run-down.

    Arrays are (n_steps,); `speed` is in rpm, lives are in revolutions, loads and
    `load_limits` in N, `stages` in s: start of the resonance, its end, the end.
    `curve` is speed [rpm], kappa and e_C up to the highest working speed.
    """

    time: FloatArray
    speed: FloatArray
    unclamped_viscosity_ratio: FloatArray
    viscosity_ratio: FloatArray
    contamination_factor: FloatArray
    loads: tuple[FloatArray, FloatArray]
    load_limits: tuple[float, float]
    life_modification_factor: FloatArray
    basic_life: FloatArray
    modified_life: FloatArray
    stages: tuple[float, float, float]
    curve: tuple[FloatArray, FloatArray, FloatArray]


def examine(case: Case) -> Lives:
    """Return the life indices with the present coupling.

    Stage I is taken as the resonance, where the speed swings at least half as much as
    it ever does; stage II as what follows. The paper draws both without a definition.
    """
    history = present_history(case)
    bearing, speed = case.bearings[0], history.generator_speed
    viscosity = case.lubrication.viscosity
    kappa = viscosity_ratio(viscosity, speed, bearing)
    e_C = dirt(case, kappa)
    loads = bearing_loads(case, history)
    omega = 2 * math.pi * float(present_performance(case).natural_frequency)
    swings = resonance_fluctuation(history, omega)
    curve_speed = np.linspace(0.0, case.duty.working_speed[1], 500)
    curve = viscosity_ratio(viscosity, curve_speed, bearing)
    return Lives(
        time=history.time,
        speed=speed * RPM,
        unclamped_viscosity_ratio=unclamped_viscosity_ratio(viscosity, speed, bearing),
        viscosity_ratio=kappa,
        contamination_factor=e_C,
        loads=loads,
        load_limits=(minimum_load(bearing), minimum_load(case.bearings[1])),
        life_modification_factor=life_modification_factor(
            loads[0], kappa, e_C, bearing
        ),
        basic_life=basic_rating_life(loads[0], bearing),
        modified_life=modified_rating_life(
            loads[0], speed, bearing, case.lubrication, case.reliability
        ),
        stages=(swings.start, swings.end, float(history.time[-1])),
        curve=(curve_speed * RPM, curve, dirt(case, curve)),
    )


def dirt(case: Case, kappa: FloatArray) -> FloatArray:
    """Return e_C of bearing 1 at some kappa."""
    diameter = case.bearings[0].pitch_diameter
    e_C: FloatArray = contamination_factor(
        kappa, diameter, case.lubrication.cleanliness
    )
    return e_C


def bearing_loads(case: Case, history: History) -> tuple[FloatArray, FloatArray]:
    """Return the combined load of both bearings over a history [N]."""
    force, angle = history.transmission_force, history.generator_angle
    return combined_loads(force, angle, case.shaft)


def tables(found: Lives) -> Sequence[Table]:
    """Return the indices' medians before, in and after the resonance, and the loads."""
    start, end, _ = found.stages
    before, after = found.time < start, found.time > end
    indices = table(
        "Life indices of bearing 1, medians (fig. 8)",
        "part of the run-down",
        "kappa",
        "e_C",
        "a_ISO",
        "L10, 1e6 rev",
        "Lp, 1e6 rev",
    )
    for name, part in (
        ("before the resonance", before),
        ("stage I, resonance", ~before & ~after),
        ("stage II, after it", after),
    ):
        indices.add_row(name, *(significant(v) for v in medians(found, part)))
    loads = table(
        "Combined loads (fig. 7)", "bearing", "largest, N", "F_min, N", "time above, s"
    )
    step = float(found.time[1] - found.time[0])
    for i, (load, limit) in enumerate(
        zip(found.loads, found.load_limits, strict=True), start=1
    ):
        above = float(np.count_nonzero(load > limit)) * step
        loads.add_row(str(i), f"{load.max():.0f}", f"{limit:.2f}", significant(above))
    return [indices, loads]


def medians(found: Lives, part: NDArray[np.bool_]) -> tuple[float, ...]:
    """Return the medians of kappa, e_C, a_ISO, and of L10 and Lp in millions."""
    columns = (
        (found.viscosity_ratio, 1.0),
        (found.contamination_factor, 1.0),
        (found.life_modification_factor, 1.0),
        (found.basic_life, 1e6),
        (found.modified_life, 1e6),
    )
    return tuple(float(np.median(values[part])) / unit for values, unit in columns)


def figures(found: Lives) -> Mapping[str, Figure]:
    """Return the figures of lubrication, of loads and of life."""
    return {
        "lubrication": draw_lubrication(*found.curve, float(found.speed.max())),
        "bearing_loads": draw_loads(found.time, found.loads, found.load_limits),
        "life": draw_life(
            found.time,
            {
                "a_ISO": found.life_modification_factor,
                "L10, 1e6 rev": found.basic_life / 1e6,
                "Lp, 1e6 rev": found.modified_life / 1e6,
            },
            found.stages,
        ),
    }


def findings(found: Lives) -> Sequence[str]:
    """Return what the figures show."""
    step = float(found.time[1] - found.time[0])
    out_of_range = np.count_nonzero(found.unclamped_viscosity_ratio < 0.1) * step
    verdicts = (
        f"bearing {i} {'exceeds' if load.max() > limit else 'never reaches'} F_min "
        f"(largest {load.max():.0f} N, {load.max() / limit:.3f} of it)"
        for i, (load, limit) in enumerate(
            zip(found.loads, found.load_limits, strict=True), start=1
        )
    )
    return (
        f"kappa falls from {found.viscosity_ratio[0]:.3f} at "
        f"{found.speed[0]:.0f} rpm; at the highest working speed it would be "
        f"{found.curve[1][-1]:.3f}. It is below ISO 281's range for the last "
        f"{out_of_range:.2f} s, where kappa = 0.1 is taken.",
        f"Of the combined loads, {'; '.join(verdicts)}.",
    )


STUDY = Study(
    "Lubrication, loads and life over the run-down (figs. 6, 7, 8)",
    examine,
    tables,
    figures,
    findings,
)

if __name__ == "__main__":
    leave(STUDY)

"""One run-down in full, driveline and bearings, for figures and files."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from coupling_design.arithmetic import FloatArray
from coupling_design.machine.machine import Case
from coupling_design.parts.bearing.contact_stress import minimum_load
from coupling_design.parts.bearing.damage import share_of_life
from coupling_design.parts.bearing.loads import combined_loads
from coupling_design.parts.bearing.lubrication import unclamped_viscosity_ratio
from coupling_design.parts.bearing.modified_life import modified_life
from coupling_design.parts.bearing.parameters import Bearing
from coupling_design.signals.detrending import collision_force
from coupling_design.signals.history import History
from coupling_design.signals.resonance import largest_swing
from coupling_design.wear.performance import Performance


@dataclass(frozen=True)
class BearingHistory:
    """What a bearing goes through, each signal (n_steps,).

    Attributes
    ----------
    combined_load : F_l [N]
    minimum_load : F_min, below which fatigue is neglected [N]
    viscosity_ratio : kappa, not held within the range of ISO 281 [-]
    contamination_factor : e_C [-]
    life_modification_factor : a_ISO [-]
    basic_rating_life, modified_rating_life : L_10, L_p [revolutions]
    damage : Miner sum up to the end of each step [-]
    """

    combined_load: FloatArray
    minimum_load: float
    viscosity_ratio: FloatArray
    contamination_factor: FloatArray
    life_modification_factor: FloatArray
    basic_rating_life: FloatArray
    modified_rating_life: FloatArray
    damage: FloatArray


@dataclass(frozen=True)
class RundownHistory:
    """One coupling's run-down, sample by sample.

    Attributes
    ----------
    role : present, chosen or nearest
    label : coupling type and connection
    driveline : its signals, time among them
    force_trend, collision_force : slow and fast part of the transmission force [N]
    bearings : bearing 1 and bearing 2
    resonance : when the transmission force swings most [s]
    """

    role: str
    label: str
    driveline: History
    force_trend: FloatArray
    collision_force: FloatArray
    bearings: tuple[BearingHistory, BearingHistory]
    resonance: float


@dataclass(frozen=True)
class Rundown:
    """How a run-down went, read from its history.

    Attributes
    ----------
    resonance_speed : shaft speed at the largest swing of the force [rad/s]
    resonance_swing : half the peak-to-peak of the force at that swing [N]
    rest_time : when the engine came to rest [s], None if it did not
    revolutions : turns of the generator shaft, forward [-]
    final_speed : of the generator [rad/s]
    out_of_range_time : time with viscosity ratio below ISO 281's range [s]
    """

    resonance_speed: float
    resonance_swing: float
    rest_time: float | None
    revolutions: float
    final_speed: float
    out_of_range_time: float


def rundown_history(
    case: Case, label: str, history: History, performance: Performance, role: str
) -> RundownHistory:
    """Return a run-down with what the bearings bear in it.

    The run-down is the one whose peak decides. Its damage counts as in the flow: the
    last value is one of those whose mean `performance` has.
    """
    frequency = 2 * math.pi * float(performance.natural_frequency)
    force = collision_force(history, frequency)
    beta = history.generator_angle + history.gravity_angle
    loads = combined_loads(history.transmission_force, beta, case.shaft)
    first, second = (
        _bearing_history(case, bearing, history, load)
        for bearing, load in zip(case.bearings, loads, strict=True)
    )
    return RundownHistory(
        role=role,
        label=label,
        driveline=history,
        force_trend=force.trend,
        collision_force=force.fluctuation,
        bearings=(first, second),
        resonance=largest_swing(history, frequency).time,
    )


def _bearing_history(
    case: Case, bearing: Bearing, history: History, load: FloatArray
) -> BearingHistory:
    speed, lubrication = history.generator_speed, case.lubrication
    life = modified_life(load, speed, bearing, lubrication, case.reliability)
    L_p = life.modified_rating_life
    return BearingHistory(
        combined_load=load,
        minimum_load=float(minimum_load(bearing)),
        viscosity_ratio=unclamped_viscosity_ratio(
            lubrication.viscosity, speed, bearing
        ),
        contamination_factor=life.contamination_factor,
        life_modification_factor=life.life_modification_factor,
        basic_rating_life=life.basic_rating_life,
        modified_rating_life=L_p,
        damage=np.cumsum(share_of_life(speed, case.shutdown.time_step, L_p)),
    )

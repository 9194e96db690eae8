"""One run-down in full, driveline and bearings, for figures and files."""

from __future__ import annotations

from dataclasses import dataclass

from coupling_design.arithmetic import FloatArray
from coupling_design.signals.history import History


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

"""What the set works at."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class ShortCircuit:
    """A short circuit at the terminals: largest air-gap torque [N m], and S_L [-].

    DIN 740-2's factor of sudden load is 1.8 for a medium and at most 2 for a step.
    """

    air_gap_torque: float
    sudden_load_factor: float


@dataclass(frozen=True)
class Duty:
    """What the set works at.

    `working_speed` is the lowest and the highest [rad/s], torques are in N m.
    `rare_torque` comes a few times in a life, as its maker states it at the coupling;
    `short_circuit` what it follows from; None if not stated. Temperature and start
    factor are DIN 740-2's S_t (elastomers only) and S_z.
    """

    working_speed: tuple[float, float]
    rated_torque: float
    peak_torque: float
    service_factor: float
    rare_torque: float | None = None
    temperature_factor: float = 1.0
    start_factor: float = 1.0
    short_circuit: ShortCircuit | None = None

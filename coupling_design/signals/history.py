"""The signals of one event over time, as arrays."""

from __future__ import annotations

from dataclasses import dataclass

from coupling_design.arithmetic import FloatArray


@dataclass(frozen=True)
class History:
    """Signals at the start of every step, each (n_steps,).

    Attributes
    ----------
    time : [s]
    transmission_force : F_c [N]
    coupling_torque : in the elastic part [N m]
    engine_speed, generator_speed : [rad/s]
    generator_angle : turned since the start [rad]
    crank_angle, gravity_angle : at the start [rad]
    """

    time: FloatArray
    transmission_force: FloatArray
    coupling_torque: FloatArray
    engine_speed: FloatArray
    generator_speed: FloatArray
    generator_angle: FloatArray
    crank_angle: float = 0.0
    gravity_angle: float = 0.0

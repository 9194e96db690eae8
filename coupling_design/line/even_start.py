"""The state a run-down starts from: turning evenly, twisted by its own deceleration.

Sources
-------
[1] Advances in Mechanical Engineering 2023, doi 10.1177/16878132231190062, eq. (1),
    solved for equal accelerations with the excitation's mean, which is zero.
"""

from __future__ import annotations

import casadi as ca

from coupling_design.arithmetic import Scalar
from coupling_design.line.even_turning import even_angles
from coupling_design.line.motion import chain_of
from coupling_design.line.parameters import Driveline
from coupling_design.line.torques import resistance_torque


def all_resistances(driveline: Driveline, speed: Scalar) -> Scalar:
    """Return what brakes both shafts together at a speed [rad/s], in [N m].

    It is of the shape of `speed`.
    """
    return resistance_torque(speed, driveline.engine_resistance) + resistance_torque(
        speed, driveline.generator_resistance
    )


def quasi_steady_state(
    driveline: Driveline, initial_speed: Scalar, fuel_torque: Scalar = 0.0
) -> Scalar:
    """Return the initial state (n_states,), a CasADi expression or DM.

    All inertias turn at `initial_speed` [rad/s] and share the mean deceleration;
    coupling and key carry the torque that this takes. Starting untwisted instead
    would be a step of torque, whose ringing can exceed the resonance looked for.
    The generator's angle is zero. `fuel_torque` [N m] drives the engine besides: where
    it balances all resistances nothing slows down, and the line carries T_d alone.
    """
    R_1 = resistance_torque(initial_speed, driveline.engine_resistance)
    T_d = resistance_torque(initial_speed, driveline.generator_resistance)
    chain = chain_of(driveline)
    deceleration = -(R_1 + T_d - fuel_torque) / sum(chain.inertias)
    angles = even_angles(chain, deceleration, (fuel_torque - R_1, 0.0, -T_d))
    return ca.vertcat(*angles, *[initial_speed] * len(angles))

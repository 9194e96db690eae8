"""Torques on the shafts from outside: the unfired engine's orders, and resistance.

Sources
-------
[1] Advances in Mechanical Engineering 2023, doi 10.1177/16878132231190062, eq. (1).
"""

from __future__ import annotations

from collections.abc import Iterable

from coupling_design.arithmetic import Scalar, sin, tanh
from coupling_design.line.parameters import ExcitationOrder, Resistance


def excitation_torque(angle: Scalar, orders: Iterable[ExcitationOrder]) -> Scalar:
    """Return the fluctuating engine torque T_e [N m] at a crank angle [rad].

    [1] eq. (1): T_e = sum of T_i sin(i theta + phase_i); its mean is zero. It is of the
    shape of `angle`, or 0.0 where there are no orders.
    """
    theta = angle
    torque: Scalar = 0.0
    for order in orders:
        torque = torque + order.amplitude * sin(order.order * theta + order.phase)
    return torque


def resistance_torque(speed: Scalar, resistance: Resistance) -> Scalar:
    """Return the torque that brakes a shaft turning at `speed` [rad/s], in [N m].

    Viscous c_t omega after [1] eq. (1), and dry friction T_f smoothed by
    tanh(omega / omega_t): at standstill it vanishes, so it cannot drive the shaft
    backwards, and turned backwards it brakes again. It is of the shape of `speed`.
    """
    omega = speed
    c_t = resistance.viscous
    T_f = resistance.friction
    return c_t * omega + T_f * tanh(omega / resistance.transition_speed)

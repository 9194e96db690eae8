"""Steady vibration of the linearised driveline, gap closed, driven by its orders.

Sources
-------
[1] Advances in Mechanical Engineering 2023, doi 10.1177/16878132231190062, eq. (1).
[2] Friswell, Penny, Garvey, Lees (2010), Dynamics of Rotating Machines: the receptance
    of a linear system, q = (K + j w C - w^2 M)^-1 T.
[3] DIN 740-2:1986, Flexible shaft couplings: vibratory torque T_W, damping power P_W.

What is left out, and when it matters:

* The connection bears on one flank. It does while the mean torque is larger than the
  amplitude of `transmission_torque`; below that the key lifts off and rattles.
* Dry friction does not depend on speed far above its transition speed: to first order
  it shifts the mean torque and damps nothing. Of a `Resistance` only the viscous part
  acts here, where `modes.damping_matrix` has friction as steep as at standstill.
* Orders push at the mean crank angle. That the vibration itself shifts them is of
  second order in their amplitude.
* Damping is viscous, as in the rollout, unless asked for per cycle.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import casadi as ca
import numpy as np

from coupling_design.arithmetic import FloatArray, Scalar, cos, sin
from coupling_design.line.chain_response import ComplexArray, chain_response
from coupling_design.line.damping import coupling_damping
from coupling_design.line.modes import (
    damping_matrix,
    mass_matrix,
    stiffness_matrix,
)
from coupling_design.line.motion import chain_of, reduced_inertia
from coupling_design.line.parameters import (
    Driveline,
    ExcitationOrder,
    LossFactorDamping,
    RelativeDamping,
)


@dataclass(frozen=True)
class ForcedResponse:
    """Complex amplitudes q of each order i at each mean speed Omega.

    An angle or torque fluctuates as Im(q exp(j w t)) with w = i Omega; |q| is its
    amplitude, half its peak-to-peak. All but orders and speeds are
    (n_orders, n_speeds): a row per order, a column per speed.

    Attributes
    ----------
    orders : (n_orders,) [-]
    speeds : mean speed of the crankshaft (n_speeds,) [rad/s]
    twist : of the elastic coupling [rad]
    coupling_torque : through the coupling, spring and damper together [N m]
    transmission_torque : through the connection [N m]
    power_loss : heat in the coupling, its mean over a period [W]
    """

    orders: FloatArray
    speeds: FloatArray
    twist: ComplexArray
    coupling_torque: ComplexArray
    transmission_torque: ComplexArray
    power_loss: FloatArray


def forced_response(
    driveline: Driveline, speeds: FloatArray, *, per_cycle: bool = False
) -> ForcedResponse:
    """Return the steady vibration at mean speeds above zero [rad/s].

    `speeds` (n_speeds,) give amplitudes (n_orders, n_speeds), see `ForcedResponse`.
    Raises ValueError if a speed is not above zero.

    `per_cycle` gives each order the damping that does the law's work per cycle at its
    own frequency, as [3] means it; without it damping is viscous, as in a run-down.

    Notes
    -----
    Coupling [1] eq. (1): T_c = (k + j w c) x. Heat [3], damping work pi c w x^2 per
    cycle: P = c w^2 |x|^2 / 2. Connection: what turns the generator,
    r F_c = (j w c_t - w^2 J3) theta_3.
    """
    speeds = np.asarray(speeds, dtype=float)
    if not np.all(speeds > 0):
        raise ValueError("a steady response needs mean speeds above zero")
    orders = np.array([o.order for o in driveline.excitation], dtype=float)
    omega = np.outer(orders, speeds)
    c = _coupling_damping(driveline, omega, per_cycle=per_cycle)
    theta = _angles(driveline, omega, c)
    x, theta_3 = theta[..., 0] - theta[..., 1], theta[..., -1]
    k = driveline.coupling.torsional_stiffness
    c_t, J3 = driveline.generator_resistance.viscous, driveline.generator_inertia
    return ForcedResponse(
        orders=orders,
        speeds=speeds,
        twist=x,
        coupling_torque=(k + 1j * omega * c) * x,
        transmission_torque=(1j * omega * c_t - omega**2 * J3) * theta_3,
        power_loss=c * omega**2 * np.abs(x) ** 2 / 2,
    )


def vibratory_torque(driveline: Driveline, speeds: FloatArray) -> FloatArray:
    """Return T_W, the amplitude of the torque in the elastic coupling [N m].

    Mean speeds (n_speeds,) above zero [rad/s] give (n_orders, n_speeds), [3]. Raises
    ValueError if a speed is not above zero.
    """
    return np.abs(forced_response(driveline, speeds).coupling_torque)


def power_loss(driveline: Driveline, speeds: FloatArray) -> FloatArray:
    """Return the heat in the coupling at each mean speed [rad/s], all orders, in [W].

    Over a revolution different orders do no work on each other: their heats add up.
    `speeds` (n_speeds,) give (n_speeds,). Raises ValueError if one is not above zero.
    """
    loss: FloatArray = forced_response(driveline, speeds).power_loss.sum(axis=0)
    return loss


def _coupling_damping(
    driveline: Driveline, omega: FloatArray, *, per_cycle: bool
) -> FloatArray:
    """Return the coupling's viscous damping [N m s/rad] at each frequency [rad/s].

    Per cycle [3]: c = psi k / (2 pi w), and c = eta k / w. Damping that is viscous by
    its own law stays as it is.
    """
    law, k = driveline.coupling.damping_law, driveline.coupling.torsional_stiffness
    if per_cycle and isinstance(law, RelativeDamping):
        return np.asarray(law.relative_damping * k / (2 * np.pi * omega))
    if per_cycle and isinstance(law, LossFactorDamping):
        return np.asarray(law.loss_factor * k / omega)
    c = coupling_damping(driveline.coupling, reduced_inertia(driveline))
    return np.full(omega.shape, float(c))


def _angles(
    driveline: Driveline, omega: FloatArray, coupling: FloatArray
) -> ComplexArray:
    """Return the complex angles [rad] of the masses, along a last axis, by [2].

    `coupling` is the coupling's damping at each frequency [N m s/rad].
    """
    chain = chain_of(driveline)
    torques = np.zeros((*omega.shape, len(chain.inertias)), dtype=complex)
    for i, order in enumerate(driveline.excitation):
        torques[i, :, 0] = order.amplitude * np.exp(1j * order.phase)
    others = [np.asarray(joint.damping) for joint in chain.flexible[1:]]
    brakes = driveline.engine_resistance, driveline.generator_resistance
    outer = (brakes[0].viscous, 0.0, brakes[1].viscous)
    return chain_response(chain, omega, torques, [coupling, *others], outer)


def angle_phasor(
    driveline: Driveline,
    order: ExcitationOrder,
    speed: Scalar,
    contact_slope: Scalar = 1.0,
) -> tuple[Scalar, Scalar]:
    """Return the angles' answer to one order at a mean speed [rad/s], by [2].

    Real and imaginary part, CasADi vectors (n_masses,) [rad]; values or symbols, so
    that it can be differentiated. As in `ForcedResponse` an angle is Im(q exp(j w t)).
    `contact_slope` is that of the contact at the mean torque [-].
    """
    M, K = mass_matrix(driveline), stiffness_matrix(driveline, contact_slope)
    C = damping_matrix(_without_friction(driveline))
    w = order.order * speed
    dynamic, n = K - w**2 * M, M.shape[0]
    # (K - w^2 M + j w C) q = T, its real part above its imaginary one.
    system = ca.vertcat(ca.horzcat(dynamic, -w * C), ca.horzcat(w * C, dynamic))
    force: list[Scalar] = [0.0] * (2 * n)
    force[0] = order.amplitude * cos(order.phase)
    force[n] = order.amplitude * sin(order.phase)
    answer = ca.solve(system, ca.vertcat(*force))
    return answer[:n], answer[n:]


def _without_friction(driveline: Driveline) -> Driveline:
    return replace(
        driveline,
        engine_resistance=replace(driveline.engine_resistance, friction=0.0),
        generator_resistance=replace(driveline.generator_resistance, friction=0.0),
    )

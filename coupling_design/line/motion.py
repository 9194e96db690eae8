"""Equations of motion of the three-inertia driveline, keyed or tightly fitted.

Sources
-------
[1] Advances in Mechanical Engineering 2023, doi 10.1177/16878132231190062, eq. (1).
"""

from __future__ import annotations

from dataclasses import dataclass

from coupling_design.arithmetic import Scalar
from coupling_design.line.chain import (
    Chain,
    Contact,
    Elastic,
    Rigid,
    chain_motion,
    unfold,
)
from coupling_design.line.damping import coupling_damping
from coupling_design.line.parameters import Driveline, KeyedConnection
from coupling_design.line.torques import excitation_torque, resistance_torque

KEYED_STATE = (
    "engine_angle",
    "coupling_angle",
    "generator_angle",
    "engine_speed",
    "coupling_speed",
    "generator_speed",
)
TIGHT_STATE = ("engine_angle", "generator_angle", "engine_speed", "generator_speed")


@dataclass(frozen=True)
class Motion:
    """What the driveline does at one instant, or at each of n_columns.

    All but `state_rate` are one value each, or (n_columns,).

    Attributes
    ----------
    state_rate : time derivative of the state, in the order of `state_names`,
        (n_states,) or (n_states, n_columns) [rad/s], [rad/s^2]
    transmission_force : F_c, tangential at the connection's radius [N]
    coupling_torque : through the elastic part of the coupling [N m]
    engine_torque : from outside on the engine, excitation less resistance [N m]
    engine_speed, generator_speed : [rad/s]
    generator_angle : [rad]
    """

    state_rate: Scalar
    transmission_force: Scalar
    coupling_torque: Scalar
    engine_torque: Scalar
    engine_speed: Scalar
    generator_speed: Scalar
    generator_angle: Scalar


def state_names(driveline: Driveline) -> tuple[str, ...]:
    """Return the names of the state's entries, angles [rad] before speeds [rad/s].

    They are (n_states,): 6 keyed, 4 tight.
    """
    if isinstance(driveline.connection, KeyedConnection):
        return KEYED_STATE
    return TIGHT_STATE


def chain_of(driveline: Driveline) -> Chain:
    """Return engine side, coupling hub and generator with the joints between them.

    Inertias are (3,) [kg m^2], joints (2,).
    """
    coupling, connection = driveline.coupling, driveline.connection
    c_dyn = coupling_damping(coupling, reduced_inertia(driveline))
    seat = Contact(connection) if isinstance(connection, KeyedConnection) else Rigid()
    return Chain(
        (
            driveline.engine_inertia,
            driveline.coupling_inertia,
            driveline.generator_inertia,
        ),
        (Elastic(coupling.torsional_stiffness, c_dyn), seat),
    )


def inertias(driveline: Driveline) -> tuple[Scalar, ...]:
    """Return what turns on its own, from the engine on [kg m^2]: 3 keyed, 2 tight."""
    return chain_of(driveline).body_inertias


def reduced_inertia(driveline: Driveline) -> Scalar:
    """Return J1 (J2 + J3) / (J1 + J2 + J3) [kg m^2], of the two masses."""
    J1 = driveline.engine_inertia
    J23 = driveline.coupling_inertia + driveline.generator_inertia
    return J1 * J23 / (J1 + J23)


def motion(
    driveline: Driveline,
    state: Scalar,
    fuel_torque: Scalar = 0.0,
    crank_angle: Scalar | None = None,
) -> Motion:
    """Return the motion at a state, [1] eq. (1).

    Its `state_rate` is of the shape of `state`.

    Parameters
    ----------
    driveline : values or symbols
    state : CasADi vector (n_states,), or array (n_states, n_columns) with a column for
        each instant; its entries or rows as `state_names` says
    fuel_torque : that drives the engine besides the orders [N m]
    crank_angle : at which the orders push [rad]; the engine's own where not given
    """
    chain = chain_of(driveline)
    angles, speeds = unfold(chain, state)
    at = angles[0] if crank_angle is None else crank_angle
    T_e = excitation_torque(at, driveline.excitation) + fuel_torque
    T_1 = T_e - resistance_torque(speeds[0], driveline.engine_resistance)
    T_d = resistance_torque(speeds[-1], driveline.generator_resistance)
    moved = chain_motion(chain, state, (T_1, 0.0, -T_d))
    T_c, r_Fc = moved.joint_torques
    return Motion(
        state_rate=moved.state_rate,
        transmission_force=r_Fc / driveline.connection.radius,
        coupling_torque=T_c,
        engine_torque=T_1,
        engine_speed=speeds[0],
        generator_speed=speeds[-1],
        generator_angle=angles[-1],
    )

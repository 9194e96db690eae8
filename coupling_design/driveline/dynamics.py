"""Equations of motion of the three-inertia driveline, keyed or tightly fitted.

Sources
-------
[1] Advances in Mechanical Engineering 2023, doi 10.1177/16878132231190062, eq. (1).
"""

from __future__ import annotations

from dataclasses import dataclass

from coupling_design.arithmetic import Scalar, entries, stacked
from coupling_design.driveline.damping import coupling_damping
from coupling_design.driveline.excitation import excitation_torque, resistance_torque
from coupling_design.driveline.key_gap import transmission_torque
from coupling_design.driveline.parameters import Driveline, KeyedConnection

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
    """What the driveline does at one instant.

    Attributes
    ----------
    state_rate : time derivative of the state, in the order of `state_names`
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
    """Return the names of the state's entries, angles [rad] before speeds [rad/s]."""
    if isinstance(driveline.connection, KeyedConnection):
        return KEYED_STATE
    return TIGHT_STATE


def inertias(driveline: Driveline) -> tuple[Scalar, ...]:
    """Return what turns on its own, from the engine on [kg m^2]: 3 keyed, 2 tight."""
    J1, J2 = driveline.engine_inertia, driveline.coupling_inertia
    J3 = driveline.generator_inertia
    if isinstance(driveline.connection, KeyedConnection):
        return J1, J2, J3
    return J1, J2 + J3


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

    Parameters
    ----------
    driveline : values or symbols
    state : CasADi vector, or array with a column for each instant; its entries or rows
        as `state_names` says
    fuel_torque : that drives the engine besides the orders [N m]
    crank_angle : at which the orders push [rad]; the engine's own where not given
    """
    at = entries(state)[0] if crank_angle is None else crank_angle
    drive = excitation_torque(at, driveline.excitation) + fuel_torque
    if isinstance(driveline.connection, KeyedConnection):
        return _keyed_motion(driveline, driveline.connection, state, drive)
    return _tight_motion(driveline, state, drive)


def _keyed_motion(
    driveline: Driveline, connection: KeyedConnection, state: Scalar, drive: Scalar
) -> Motion:
    th1, th2, th3, w1, w2, w3 = entries(state)
    J1, J2 = driveline.engine_inertia, driveline.coupling_inertia
    J3 = driveline.generator_inertia
    T_1 = drive - resistance_torque(w1, driveline.engine_resistance)
    T_d = resistance_torque(w3, driveline.generator_resistance)
    T_c = _coupling_torque(driveline, th1 - th2, w1 - w2)
    r_Fc = transmission_torque(th2 - th3, w2 - w3, connection)
    return Motion(
        state_rate=stacked(
            w1, w2, w3, (T_1 - T_c) / J1, (T_c - r_Fc) / J2, (r_Fc - T_d) / J3
        ),
        transmission_force=r_Fc / connection.radius,
        coupling_torque=T_c,
        engine_torque=T_1,
        engine_speed=w1,
        generator_speed=w3,
        generator_angle=th3,
    )


def _tight_motion(driveline: Driveline, state: Scalar, drive: Scalar) -> Motion:
    th1, th3, w1, w3 = entries(state)
    J1, J2 = driveline.engine_inertia, driveline.coupling_inertia
    J3 = driveline.generator_inertia
    T_1 = drive - resistance_torque(w1, driveline.engine_resistance)
    T_d = resistance_torque(w3, driveline.generator_resistance)
    T_c = _coupling_torque(driveline, th1 - th3, w1 - w3)
    a_3 = (T_c - T_d) / (J2 + J3)
    # The hub carries what turns the generator: eq. (1), third line.
    r_Fc = J3 * a_3 + T_d
    return Motion(
        state_rate=stacked(w1, w3, (T_1 - T_c) / J1, a_3),
        transmission_force=r_Fc / driveline.connection.radius,
        coupling_torque=T_c,
        engine_torque=T_1,
        engine_speed=w1,
        generator_speed=w3,
        generator_angle=th3,
    )


def _coupling_torque(driveline: Driveline, twist: Scalar, twist_rate: Scalar) -> Scalar:
    k_dyn = driveline.coupling.torsional_stiffness
    c_dyn = coupling_damping(driveline.coupling, reduced_inertia(driveline))
    return k_dyn * twist + c_dyn * twist_rate

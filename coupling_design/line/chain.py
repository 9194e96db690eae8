"""A chain of inertias and the joints between neighbours: motion and matrices.

What a rigid joint connects turns as one body and has one angle and one speed in the
state; the torque that the joint carries is known all the same. Torques from outside
act on each inertia.

Sources
-------
[1] Nestorides (1958), A Handbook on Torsional Vibration: inertias in a row, each turned
    by the difference of its joints' torques; of three, it is eq. (1) of
    doi 10.1177/16878132231190062.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

from coupling_design.arithmetic import Scalar, entries, matrix, stacked
from coupling_design.line.contact import transmission_torque
from coupling_design.line.parameters import KeyedConnection


@dataclass(frozen=True)
class Elastic:
    """A spring [N m/rad] with viscous damping [N m s/rad] beside it."""

    stiffness: Scalar
    damping: Scalar

    def torque(self, twist: Scalar, twist_rate: Scalar) -> Scalar:
        """Return the torque carried [N m] at a twist [rad] and its rate [rad/s].

        It is of the shape of its arguments.
        """
        return self.stiffness * twist + self.damping * twist_rate

    def slope(self, _: Scalar) -> Scalar:
        """Return the stiffness [N m/rad]."""
        return self.stiffness


@dataclass(frozen=True)
class Contact:
    """A key or spline: its flanks touch beyond a gap."""

    connection: KeyedConnection

    @property
    def damping(self) -> Scalar:
        """The oil's drag in the gap [N m s/rad]."""
        return self.connection.oil_damping

    def torque(self, twist: Scalar, twist_rate: Scalar) -> Scalar:
        """Return the torque carried [N m] at a twist [rad] and its rate [rad/s].

        It is of the shape of its arguments.
        """
        return transmission_torque(twist, twist_rate, self.connection)

    def slope(self, contact_slope: Scalar) -> Scalar:
        """Return the stiffness [N m/rad], gap closed, so many times as steep.

        It is of the shape of `contact_slope`.
        """
        return contact_slope * self.connection.contact_stiffness


@dataclass(frozen=True)
class Rigid:
    """A tight fit: both sides turn as one."""


Joint = Elastic | Contact | Rigid


@dataclass(frozen=True)
class Chain:
    """Inertias [kg m^2] from the engine on, (n,), and the joints between, (n - 1,).

    Raises ValueError where they do not match.
    """

    inertias: tuple[Scalar, ...]
    joints: tuple[Joint, ...]

    def __post_init__(self) -> None:
        """Hold the numbers of inertias and joints against each other."""
        if len(self.joints) != len(self.inertias) - 1:
            raise ValueError(
                f"{len(self.inertias)} inertias have {len(self.inertias) - 1} joints "
                f"between them, not {len(self.joints)}"
            )

    @cached_property
    def bodies(self) -> tuple[tuple[int, ...], ...]:
        """The inertias that turn as one, by their places, from the engine on.

        There are n_bodies, together of all n inertias.
        """
        bodies = [[0]]
        for i, joint in enumerate(self.joints):
            if isinstance(joint, Rigid):
                bodies[-1].append(i + 1)
            else:
                bodies.append([i + 1])
        return tuple(tuple(body) for body in bodies)

    @property
    def body_inertias(self) -> tuple[Scalar, ...]:
        """The inertia of each body (n_bodies,) [kg m^2]."""
        return tuple(sum(self.inertias[i] for i in body) for body in self.bodies)

    @property
    def flexible(self) -> tuple[Elastic | Contact, ...]:
        """The joints between the bodies (n_bodies - 1,)."""
        return tuple(joint for joint in self.joints if not isinstance(joint, Rigid))


@dataclass(frozen=True)
class ChainMotion:
    """What a chain does at one instant, or at each of n_columns.

    Attributes
    ----------
    state_rate : of the bodies' angles and speeds, (2 n_bodies,) or
        (2 n_bodies, n_columns) [rad/s], [rad/s^2]
    joint_torques : carried by each joint, rigid ones too (n - 1,), each one value or
        (n_columns,) [N m]
    """

    state_rate: Scalar
    joint_torques: tuple[Scalar, ...]


def unfold(chain: Chain, state: Scalar) -> tuple[list[Scalar], list[Scalar]]:
    """Return angle [rad] and speed [rad/s] of each inertia, (n,) both.

    `state` is a CasADi vector (2 n_bodies,), or an array with a column for each
    instant: the bodies' angles before their speeds.
    """
    values, n = entries(state), len(chain.bodies)
    angles = [values[k] for k, body in enumerate(chain.bodies) for _ in body]
    speeds = [values[n + k] for k, body in enumerate(chain.bodies) for _ in body]
    return angles, speeds


def chain_motion(
    chain: Chain, state: Scalar, outer_torques: Sequence[Scalar]
) -> ChainMotion:
    """Return the motion at a state, [1]; see `unfold` for the state.

    A state (2 n_bodies,) or (2 n_bodies, n_columns) has a rate of the same shape.
    `outer_torques` (n,) act from outside on each inertia, in the direction of its
    speed [N m].
    """
    angles, speeds = unfold(chain, state)
    carried: list[Scalar] = [
        0.0
        if isinstance(joint, Rigid)
        else joint.torque(angles[i] - angles[i + 1], speeds[i] - speeds[i + 1])
        for i, joint in enumerate(chain.joints)
    ]
    rates = []
    for body, inertia in zip(chain.bodies, chain.body_inertias, strict=True):
        torque = _net(body, carried, outer_torques)
        rates.append(torque / inertia)
        # From the far end back: a rigid joint carries what turns all behind it.
        for i in reversed(body[:-1]):
            behind = _net((i + 1,), [0.0] * (i + 1) + carried[i + 1 :], outer_torques)
            carried[i] = chain.inertias[i + 1] * rates[-1] - behind
    turning = [speeds[body[0]] for body in chain.bodies]
    return ChainMotion(stacked(*turning, *rates), tuple(carried))


def _net(
    body: Sequence[int], carried: Sequence[Scalar], outer_torques: Sequence[Scalar]
) -> Scalar:
    """Return what turns a body: from outside, from before, less what goes on."""
    first, last = body[0], body[-1]
    torque: Scalar = sum(outer_torques[i] for i in body)
    if first > 0:
        torque = torque + carried[first - 1]
    if last < len(carried):
        torque = torque - carried[last]
    return torque


def chain_mass(chain: Chain) -> Scalar:
    """Return the bodies' inertias on a diagonal (n_bodies, n_bodies) [kg m^2]."""
    masses = chain.body_inertias
    n = len(masses)
    return matrix([[masses[i] if i == j else 0.0 for j in range(n)] for i in range(n)])


def chain_stiffness(chain: Chain, contact_slope: Scalar = 1.0) -> Scalar:
    """Return the stiffness matrix (n_bodies, n_bodies) with gaps closed [N m/rad].

    `contact_slope` multiplies the contacts' stiffness: 1 on the flank of a key.
    """
    return _in_a_row([joint.slope(contact_slope) for joint in chain.flexible])


def chain_damping(chain: Chain, outer_damping: Sequence[Scalar] = ()) -> Scalar:
    """Return the damping matrix (n_bodies, n_bodies) [N m s/rad].

    `outer_damping` (n,) brakes each inertia against what stands still.
    """
    grounds = (
        [sum(outer_damping[i] for i in body) for body in chain.bodies]
        if len(outer_damping)
        else []
    )
    return _in_a_row([joint.damping for joint in chain.flexible], grounds)


def _in_a_row(springs: Sequence[Scalar], grounds: Sequence[Scalar] = ()) -> Scalar:
    """Return the matrix of springs in a row between len(springs) + 1 masses.

    `grounds` tie each mass to what stands still.
    """
    n = len(springs) + 1
    rows: list[list[Scalar]] = [[0.0] * n for _ in range(n)]
    for i, k in enumerate(springs):
        rows[i][i] += k
        rows[i + 1][i + 1] += k
        rows[i][i + 1], rows[i + 1][i] = -k, -k
    for i, ground in enumerate(grounds):
        rows[i][i] += ground
    return matrix(rows)

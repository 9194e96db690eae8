"""What describes a driveline: inertias, coupling, connection, excitation, resistance.

All values are SI; angles are radians. Any value may be a CasADi symbol, so a design
variable replaces a number with `dataclasses.replace` and no equation notices.
"""

from __future__ import annotations

from dataclasses import dataclass

from coupling_design.arithmetic import Scalar


@dataclass(frozen=True)
class ProportionalDamping:
    """Damping proportional to stiffness, c = kappa0 k / omega0 (steel springs).

    `damping_factor` is kappa0 [-], `characteristic_frequency` omega0 [rad/s].
    """

    damping_factor: Scalar
    characteristic_frequency: Scalar


@dataclass(frozen=True)
class LossFactorDamping:
    """Damping from a loss factor eta [-] at the driveline's natural frequency."""

    loss_factor: Scalar


@dataclass(frozen=True)
class RelativeDamping:
    """Damping from DIN 740's relative damping psi [-] at the natural frequency."""

    relative_damping: Scalar


DampingLaw = ProportionalDamping | LossFactorDamping | RelativeDamping


@dataclass(frozen=True)
class Coupling:
    """The elastic part of a coupling: dynamic stiffness [N m/rad] and damping law."""

    torsional_stiffness: Scalar
    damping_law: DampingLaw


@dataclass(frozen=True)
class KeyedConnection:
    """A key or spline with clearance between coupling hub and generator shaft.

    Attributes
    ----------
    radius : key radius r [m]
    gap : total tangential clearance Phi at that radius [m]
    contact_stiffness : k_g [N m/rad]
    oil_damping : c, of the oil in the gap [N m s/rad]
    smoothing : sigma, sharpness of the tanh that smooths the gap, per length [1/m]
    """

    radius: Scalar
    gap: Scalar
    contact_stiffness: Scalar
    oil_damping: Scalar
    smoothing: Scalar


@dataclass(frozen=True)
class TightFit:
    """A hub shrunk on the shaft at radius r [m]: J2 and J3 turn together."""

    radius: Scalar


Connection = KeyedConnection | TightFit


@dataclass(frozen=True)
class ExcitationOrder:
    """One harmonic of the engine torque: order [-], amplitude [N m], phase [rad]."""

    order: float
    amplitude: Scalar
    phase: Scalar


@dataclass(frozen=True)
class Resistance:
    """What brakes a shaft: viscous [N m s/rad] and dry friction [N m].

    `transition_speed` [rad/s] is where the tanh that smooths dry friction through
    standstill has reached tanh(1) = 76 % of it.
    """

    viscous: Scalar
    friction: Scalar
    transition_speed: Scalar


@dataclass(frozen=True)
class Driveline:
    """Three inertias [kg m^2] and what joins, drives and brakes them.

    `excitation` is (n_orders,).
    """

    engine_inertia: Scalar
    coupling_inertia: Scalar
    generator_inertia: Scalar
    coupling: Coupling
    connection: Connection
    excitation: tuple[ExcitationOrder, ...]
    engine_resistance: Resistance
    generator_resistance: Resistance


@dataclass(frozen=True)
class SettledStart:
    """Start from the settled vibration of the engine turned without fuel."""


@dataclass(frozen=True)
class QuasiSteadyStart:
    """Start turning evenly, twisted by the mean deceleration; nothing vibrates yet."""


@dataclass(frozen=True)
class FuelCutStart:
    """Start settled at idle, the fuel's mean torque balancing all resistances.

    It is taken away evenly over `duration` [s]; 0 is at once, the bound.
    """

    duration: float


Start = SettledStart | QuasiSteadyStart | FuelCutStart


@dataclass(frozen=True)
class Shutdown:
    """A run-down, and where what is chance in it begins.

    Attributes
    ----------
    initial_speed : mean speed at t = 0 [rad/s]
    duration, time_step : [s]
    start : what the line does at t = 0
    crank_angle : mean position of the generator's end of the line at t = 0, from which
        the phases of the orders count [rad]
    gravity_angle : from the direction in which F_c pushes to gravity, at t = 0 [rad]
    crank_angles : over how many, evenly spread from `crank_angle`, results are judged
    """

    initial_speed: Scalar
    duration: float
    time_step: float
    start: Start = SettledStart()
    crank_angle: Scalar = 0.0
    gravity_angle: Scalar = 0.0
    crank_angles: int = 8

    @property
    def n_steps(self) -> int:
        """Number of steps that cover the duration [-]."""
        return round(self.duration / self.time_step)

    @property
    def fuel_cut_time(self) -> float:
        """How long the fuel's torque takes to go [s]; 0 where there is none."""
        return self.start.duration if isinstance(self.start, FuelCutStart) else 0.0

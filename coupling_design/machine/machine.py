"""A design case: what a case file says, as plain SI values."""

from __future__ import annotations

from dataclasses import dataclass, replace

from coupling_design.errors import CaseError
from coupling_design.line.parameters import (
    Connection,
    DampingLaw,
    Driveline,
    ExcitationOrder,
    KeyedConnection,
    Shutdown,
    TightFit,
)
from coupling_design.machine.coupling_size import CatalogueFile, CouplingSize
from coupling_design.machine.words import Choice as Choice
from coupling_design.machine.words import ConnectionKind as ConnectionKind
from coupling_design.machine.words import LoadLimitReading as LoadLimitReading
from coupling_design.machine.words import Plan as Plan
from coupling_design.machine.words import Source as Source
from coupling_design.machine.words import StartWord as StartWord
from coupling_design.parts.bearing.parameters import Bearing, Lubrication, ShaftGeometry


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


_SAME_STIFFNESS = 1e-6  # of a size and of what a case says the present one has


@dataclass(frozen=True)
class CouplingType:
    """A family of couplings to choose from.

    Attributes
    ----------
    name, description : as the report calls it
    plan : the plan of the design flow it belongs to
    nominal_torque, maximum_torque : T_KN, T_Kmax [N m]
    maximum_speed : [rad/s]
    stiffness_range : lowest and highest dynamic stiffness of the family [N m/rad]
    damping_law : how its damping follows its stiffness
    connections : kinds of hub it is made with
    sizes : the real ones, softest first, where it is a series of a catalogue
    """

    name: str
    description: str
    plan: Plan
    nominal_torque: float
    maximum_torque: float
    maximum_speed: float
    stiffness_range: tuple[float, float]
    damping_law: DampingLaw
    connections: tuple[ConnectionKind, ...]
    sizes: tuple[CouplingSize, ...] = ()

    def size_of(self, torsional_stiffness: float) -> CouplingSize | None:
        """Return the size of a stiffness [N m/rad], None if there is none."""
        same = (
            size
            for size in self.sizes
            if abs(size.torsional_stiffness / torsional_stiffness - 1)
            <= _SAME_STIFFNESS
        )
        return next(same, None)

    def with_sizes(self, sizes: tuple[CouplingSize, ...]) -> CouplingType:
        """Return the series of these sizes: their span, and what each of them takes."""
        ordered = tuple(sorted(sizes, key=lambda size: size.torsional_stiffness))
        return replace(
            self,
            nominal_torque=min(size.nominal_torque for size in ordered),
            maximum_torque=min(size.maximum_torque for size in ordered),
            maximum_speed=min(size.maximum_speed for size in ordered),
            stiffness_range=(
                ordered[0].torsional_stiffness,
                ordered[-1].torsional_stiffness,
            ),
            sizes=ordered,
        )


@dataclass(frozen=True)
class ConnectionOption:
    """A kind of connection the design may take, and its total gap [m]."""

    kind: ConnectionKind
    minimum_gap: float
    maximum_gap: float


@dataclass(frozen=True)
class Joint:
    """The seat of the hub on the generator shaft, whatever connection it gets.

    `radius` [m] holds for all; contact stiffness [N m/rad], oil damping [N m s/rad]
    and smoothing [1/m] are None where no key or spline is considered.
    """

    radius: float
    contact_stiffness: float | None
    oil_damping: float | None
    smoothing: float | None

    def connect(self, kind: ConnectionKind, gap: float) -> Connection:
        """Return the connection of that kind, with a gap [m] where it has one."""
        if kind is ConnectionKind.TIGHT_FIT:
            return TightFit(radius=self.radius)
        contact = (self.contact_stiffness, self.oil_damping, self.smoothing)
        if None in contact:
            raise CaseError(
                [
                    f"driveline.connection: a {kind} needs contact_stiffness, "
                    "oil_damping and smoothing, which this case does not give"
                ]
            )
        return KeyedConnection(
            radius=self.radius,
            gap=gap,
            contact_stiffness=self.contact_stiffness,
            oil_damping=self.oil_damping,
            smoothing=self.smoothing,
        )


@dataclass(frozen=True)
class SourcedValue:
    """One value of the file: its path, as written, in SI, and where it comes from.

    `value` is a float in `unit`, or the word chosen; `source` is None if not stated,
    `line` if it stands in no file of its own.
    """

    path: str
    text: str
    value: float | str
    unit: str
    source: Source | None
    note: str
    line: int | None = None


@dataclass(frozen=True)
class Case:
    """A machine, its run-down and what may be chosen for it.

    `driveline` holds the present coupling and connection; `present_coupling_type`
    and `present_connection` name what they are among the choices.
    `present_driving_inertia` [kg m^2] is what the present coupling's driving half has
    of the engine's inertia, None if not stated. `overrides` are the values, each
    `path=value`, that replaced those of the file `sha256` belongs to.
    `stated_working_excitation` are the orders at working speed, none where the case
    gives none of their own; `works_fired` says that they are a fired engine's.
    `crank_mode` is the estimated first mode of a described engine's crank [Hz].
    `unused` are the values that nothing uses: path, and why.
    """

    name: str
    description: str
    file: str
    sha256: str
    reading: LoadLimitReading
    driveline: Driveline
    joint: Joint
    present_coupling_type: str
    present_connection: ConnectionKind
    shutdown: Shutdown
    shaft: ShaftGeometry
    bearings: tuple[Bearing, Bearing]
    lubrication: Lubrication
    reliability: float
    duty: Duty
    coupling_types: tuple[CouplingType, ...]
    connections: tuple[ConnectionOption, ...]
    provenance: tuple[SourcedValue, ...]
    catalogues: tuple[CatalogueFile, ...] = ()
    choose: Choice = Choice.OPTIMUM
    present_driving_inertia: float | None = None
    overrides: tuple[str, ...] = ()
    stated_working_excitation: tuple[ExcitationOrder, ...] = ()
    works_fired: bool = False
    crank_mode: float | None = None
    unused: tuple[tuple[str, str], ...] = ()

    @property
    def working_excitation(self) -> tuple[ExcitationOrder, ...]:
        """The orders at working speed; those of the run-down where none are stated."""
        return self.stated_working_excitation or self.driveline.excitation

    def place(self, path: str) -> str:
        """Return a value's path as messages begin with it: file, line, path."""
        lines = (v.line for v in self.provenance if v.path == path and v.line)
        line = next(lines, None)
        return f"{self.file}:{line}: {path}" if line else f"{self.file}: {path}"

    @property
    def assumptions(self) -> tuple[SourcedValue, ...]:
        """The values that rest on nothing but judgement: assumed, fitted, invented."""
        judged = (Source.ASSUMED, Source.FITTED, Source.INVENTED)
        return tuple(value for value in self.provenance if value.source in judged)

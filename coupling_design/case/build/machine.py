"""From a validated case file to the `Case` that the physics is given."""

from __future__ import annotations

from coupling_design.case.build.catalogue import Catalogues, offered
from coupling_design.case.build.coupling import build_damping_law
from coupling_design.case.build.duty import (
    build_duty,
    crank_mode_of,
    plain,
    working_excitation,
    works_fired,
)
from coupling_design.case.build.engine import excitation_of
from coupling_design.case.build.shutdown import build_shutdown
from coupling_design.case.build.unused import unused_values
from coupling_design.case.schema.engine import (
    EngineExcitation,
)
from coupling_design.case.schema.machine import (
    BearingSection,
    CaseSection,
    ConnectionChoices,
    CouplingTypeSection,
    DrivelineSection,
    LubricationSection,
    PresentConnection,
)
from coupling_design.case.values.kinds import STRESS_COEFFICIENT
from coupling_design.line.parameters import (
    Connection,
    Coupling,
    Driveline,
    ExcitationOrder,
    Resistance,
)
from coupling_design.machine.coupling_type import CouplingType
from coupling_design.machine.hub_seat import ConnectionOption, HubSeat
from coupling_design.machine.machine import Case
from coupling_design.machine.sourced_value import SourcedValue
from coupling_design.machine.words import ConnectionKind
from coupling_design.parts.bearing.parameters import (
    Bearing,
    Contact,
    Lubrication,
    ShaftGeometry,
)


def build_case(
    section: CaseSection,
    file: str,
    sha256: str,
    provenance: tuple[SourcedValue, ...],
    catalogues: Catalogues,
) -> Case:
    """Return the case a file describes; its relations must have been checked."""
    connections = _connections(section.design_space.connections)
    coupling_types = _coupling_types(section, catalogues, connections)
    excitation, derived = _excitation(section.driveline, file)
    working, also_derived = working_excitation(section, file)
    seat = _hub_seat(section.driveline.connection)
    return Case(
        name=section.name,
        description=section.description,
        file=file,
        sha256=sha256,
        reading=section.reading.value,
        driveline=_driveline(section.driveline, coupling_types, seat, excitation),
        hub_seat=seat,
        present_coupling_type=section.driveline.coupling.type,
        present_connection=section.driveline.connection.kind.value,
        shutdown=build_shutdown(section.shutdown, section.driveline),
        shaft=ShaftGeometry(**section.shaft.model_dump()),
        bearings=_bearings(section, provenance),
        lubrication=_lubrication(section.lubrication),
        reliability=section.lubrication.reliability.value,
        duty=build_duty(section.duty),
        coupling_types=coupling_types,
        connections=connections,
        provenance=(*provenance, *derived, *also_derived),
        catalogues=catalogues.files,
        choose=section.design_space.choose,
        present_driving_inertia=plain(section.driveline.coupling.driving_inertia),
        stated_working_excitation=working,
        works_fired=works_fired(section),
        crank_mode=crank_mode_of(section.driveline, file),
        unused=tuple(unused_values(section, coupling_types)),
    )


def _bearings(
    section: CaseSection, provenance: tuple[SourcedValue, ...]
) -> tuple[Bearing, Bearing]:
    first, second = (
        _bearing(bearing, f"bearings[{k}]", provenance)
        for k, bearing in enumerate(section.bearings)
    )
    return first, second


def _bearing(
    section: BearingSection, path: str, provenance: tuple[SourcedValue, ...]
) -> Bearing:
    """Return a bearing; the unit of its stress coefficient says which law it has."""
    units = {value.path: value.unit for value in provenance}
    is_line = units[f"{path}.stress_coefficient"] == STRESS_COEFFICIENT.unit
    contact = Contact.LINE if is_line else Contact.POINT
    return Bearing(**section.model_dump(), contact=contact)


def _coupling_types(
    section: CaseSection,
    catalogues: Catalogues,
    connections: tuple[ConnectionOption, ...],
) -> tuple[CouplingType, ...]:
    kinds: set[str] = {option.kind for option in connections}
    return (
        *(_coupling_type(entry) for entry in section.coupling_types),
        *(offered(series, kinds) for series in catalogues.types),
    )


def _lubrication(section: LubricationSection) -> Lubrication:
    return Lubrication(
        viscosity=section.viscosity.value, cleanliness=section.cleanliness.value
    )


def _driveline(
    section: DrivelineSection,
    coupling_types: tuple[CouplingType, ...],
    seat: HubSeat,
    excitation: tuple[ExcitationOrder, ...],
) -> Driveline:
    present = section.coupling.type
    damping_law = next(t.damping_law for t in coupling_types if t.name == present)
    return Driveline(
        engine_inertia=section.engine_inertia.value,
        coupling_inertia=section.coupling_inertia.value,
        generator_inertia=section.generator_inertia.value,
        coupling=Coupling(
            torsional_stiffness=section.coupling.torsional_stiffness.value,
            damping_law=damping_law,
        ),
        connection=_present_connection(section.connection, seat),
        excitation=excitation,
        engine_resistance=Resistance(**section.engine_resistance.model_dump()),
        generator_resistance=Resistance(**section.generator_resistance.model_dump()),
    )


def _excitation(
    section: DrivelineSection, file: str
) -> tuple[tuple[ExcitationOrder, ...], tuple[SourcedValue, ...]]:
    """Return the orders as written or worked out, and what was derived for them."""
    if isinstance(section.excitation, EngineExcitation):
        return excitation_of(section.excitation.engine, file)
    return (
        tuple(ExcitationOrder(**order.model_dump()) for order in section.excitation),
        (),
    )


def _present_connection(section: PresentConnection, seat: HubSeat) -> Connection:
    gap = section.gap.value if section.gap else 0.0
    return seat.connect(section.kind.value, gap)


def _hub_seat(section: PresentConnection) -> HubSeat:
    return HubSeat(**section.model_dump(exclude={"kind", "gap"}))


def _coupling_type(section: CouplingTypeSection) -> CouplingType:
    stiffness = section.stiffness
    return CouplingType(
        name=section.name,
        description=section.description,
        plan=section.plan,
        nominal_torque=section.nominal_torque.value,
        maximum_torque=section.maximum_torque.value,
        maximum_speed=section.maximum_speed.value,
        stiffness_range=(stiffness.lowest.value, stiffness.highest.value),
        damping_law=build_damping_law(section.damping),
        connections=section.connections,
    )


def _connections(section: ConnectionChoices) -> tuple[ConnectionOption, ...]:
    options = [
        ConnectionOption(kind, gaps.minimum_gap.value, gaps.maximum_gap.value)
        for kind, gaps in (
            (ConnectionKind.KEY, section.key),
            (ConnectionKind.SPLINE, section.spline),
        )
        if gaps
    ]
    if section.tight_fit is not None:
        options.append(ConnectionOption(ConnectionKind.TIGHT_FIT, 0.0, 0.0))
    return tuple(options)

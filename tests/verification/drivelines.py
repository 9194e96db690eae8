"""Drivelines of other people's systems, and the shipped case, for the verification."""

import dataclasses
import functools
from pathlib import Path

from coupling_design.case import load_case
from coupling_design.line.parameters import (
    Coupling,
    Driveline,
    KeyedConnection,
    ProportionalDamping,
    Resistance,
    TightFit,
)
from coupling_design.machine.candidate import Candidate
from coupling_design.machine.words import ConnectionKind, Plan
from coupling_design.wear.evaluator import Evaluator

CASE_FILE = Path(__file__).parents[2] / "cases" / "16v280.yaml"
NONE = Resistance(viscous=0.0, friction=0.0, transition_speed=1.0)


def two_masses(engine_inertia, other_inertia, stiffness, damping=0.0):
    """Return two inertias on a shaft of a stiffness and a viscous damping.

    Our line has three; the second and third, fitted tightly, share the other inertia.
    """
    return Driveline(
        engine_inertia=engine_inertia,
        coupling_inertia=0.25 * other_inertia,
        generator_inertia=0.75 * other_inertia,
        coupling=_coupling(stiffness, damping),
        connection=TightFit(radius=0.1),
        excitation=(),
        engine_resistance=NONE,
        generator_resistance=NONE,
    )


def three_masses(inertias, stiffnesses, dampings=(0.0, 0.0)):
    """Return three inertias in a row: our keyed line with its gap closed."""
    J1, J2, J3 = inertias
    return Driveline(
        engine_inertia=J1,
        coupling_inertia=J2,
        generator_inertia=J3,
        coupling=_coupling(stiffnesses[0], dampings[0]),
        connection=KeyedConnection(
            radius=0.1,
            gap=0.0,
            contact_stiffness=stiffnesses[1],
            oil_damping=dampings[1],
            smoothing=1e6,
        ),
        excitation=(),
        engine_resistance=NONE,
        generator_resistance=NONE,
    )


def _coupling(stiffness, damping):
    return Coupling(stiffness, ProportionalDamping(damping / stiffness, 1.0))


@functools.cache
def shipped_case():
    """Return the case of the 16V280 set as it is shipped."""
    return load_case(CASE_FILE)


def with_gap(driveline, gap):
    """Return a keyed driveline with another gap [m]."""
    connection = dataclasses.replace(driveline.connection, gap=gap)
    return dataclasses.replace(driveline, connection=connection)


def present_candidate(case):
    """Return the present coupling and connection of a case."""
    return _candidate(case, case.present_coupling_type, case.present_connection)


def high_stiffness_candidate(case):
    """Return the first coupling of the case's high-stiffness plan, tightly fitted."""
    name = next(t.name for t in case.coupling_types if t.plan is Plan.HIGH_STIFFNESS)
    return _candidate(case, name, ConnectionKind.TIGHT_FIT)


def evaluator(candidate, case=None, **shutdown_changes):
    """Return the evaluator of a candidate, run down otherwise than the case has it.

    The case is the shipped one where none is given.
    """
    case = case or shipped_case()
    shutdown = dataclasses.replace(case.shutdown, **shutdown_changes)
    return Evaluator(dataclasses.replace(case, shutdown=shutdown), candidate)


def _candidate(case, type_name, kind):
    coupling_type = next(t for t in case.coupling_types if t.name == type_name)
    option = next(o for o in case.connections if o.kind is kind)
    return Candidate(coupling_type, option)

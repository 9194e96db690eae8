"""What may differ from one run-down of a candidate to the next, as one vector.

The two design variables come first; then what is chance, and what is not known well.
They are parameters of the step, so that all of them share one machine code and any of
them may differ within a batch.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import casadi as ca
import numpy as np

from coupling_design.arithmetic import FloatArray
from coupling_design.events.event import Event
from coupling_design.events.shutdown import RunDown
from coupling_design.line.parameters import Driveline, KeyedConnection, Shutdown
from coupling_design.machine.candidate import Candidate, candidate_driveline
from coupling_design.machine.machine import Case

N_DESIGN = 2  # stiffness and gap
CRANK_ANGLE, GRAVITY_ANGLE, INITIAL_SPEED, FIRST_AMPLITUDE = 2, 3, 4, 5


@dataclass(frozen=True)
class Variables:
    """The vector of a candidate, with the driveline and the shutdown it makes.

    Attributes
    ----------
    symbols : torsional stiffness [N m/rad], gap [m], crank angle [rad], gravity's
        angle [rad], initial speed [rad/s], amplitude of each order [N m], and of a key
        or spline the contact stiffness [N m/rad]; shape (m,)
    driveline, shutdown : of these symbols
    nominal : the case's own values of all but the first two, (m - 2,)
    """

    symbols: ca.SX
    driveline: Driveline
    shutdown: Shutdown
    nominal: tuple[float, ...]

    @property
    def event(self) -> Event:
        """What happens to the line, of these symbols."""
        return RunDown(self.driveline, self.shutdown)

    @property
    def contact_stiffness(self) -> int | None:
        """Place of the contact stiffness, None where there is no contact."""
        n = self.symbols.numel()
        is_keyed = isinstance(self.driveline.connection, KeyedConnection)
        return n - 1 if is_keyed else None

    def driveline_at(self, values: FloatArray) -> Driveline:
        """Return the driveline of numbers at values of the vector (m,)."""
        place = self.contact_stiffness
        line, connection = self.driveline, self.driveline.connection
        if place is not None and isinstance(connection, KeyedConnection):
            connection = replace(
                connection, gap=float(values[1]), contact_stiffness=float(values[place])
            )
        return replace(
            line,
            coupling=replace(line.coupling, torsional_stiffness=float(values[0])),
            connection=connection,
            excitation=tuple(
                replace(order, amplitude=float(values[FIRST_AMPLITUDE + i]))
                for i, order in enumerate(line.excitation)
            ),
        )

    def columns(
        self, points: Sequence[tuple[float, float]], chances: FloatArray
    ) -> FloatArray:
        """Return a column for each point and chance, points slowest, (m, b).

        `chances` are crank angles and gravity's [rad], shape (2, n).
        """
        n = chances.shape[1]
        columns = np.empty((self.symbols.numel(), len(points) * n))
        columns[:N_DESIGN] = np.repeat(np.asarray(points, float).T, n, axis=1)
        columns[N_DESIGN:] = np.array(self.nominal)[:, np.newaxis]
        columns[CRANK_ANGLE : GRAVITY_ANGLE + 1] = np.tile(chances, len(points))
        return columns


def make_variables(case: Case, candidate: Candidate) -> Variables:
    """Return the vector of a candidate of a case."""
    shutdown, orders = case.shutdown, case.driveline.excitation
    named = ca.SX.sym("design", N_DESIGN)
    driveline = candidate_driveline(case, candidate, named[0], named[1])
    crank, gravity = ca.SX.sym("crank_angle"), ca.SX.sym("gravity_angle")
    speed = ca.SX.sym("initial_speed")
    amplitudes = ca.SX.sym("amplitude", len(orders))
    symbols = [named, crank, gravity, speed, amplitudes]
    nominal = [shutdown.crank_angle, shutdown.gravity_angle, shutdown.initial_speed]
    nominal += [order.amplitude for order in orders]
    driveline = replace(
        driveline,
        excitation=tuple(
            replace(order, amplitude=amplitudes[i]) for i, order in enumerate(orders)
        ),
    )
    if isinstance(driveline.connection, KeyedConnection):
        symbols.append(ca.SX.sym("contact_stiffness"))
        nominal.append(driveline.connection.contact_stiffness)
        connection = replace(driveline.connection, contact_stiffness=symbols[-1])
        driveline = replace(driveline, connection=connection)
    return Variables(
        symbols=ca.vertcat(*symbols),
        driveline=driveline,
        shutdown=replace(
            shutdown, initial_speed=speed, crank_angle=crank, gravity_angle=gravity
        ),
        nominal=tuple(float(value) for value in nominal),
    )

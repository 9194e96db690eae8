"""Whether the gap of a key opens while the line vibrates before its run-down."""

from __future__ import annotations

import math
from functools import cached_property
from typing import cast

import casadi as ca
import numpy as np

from coupling_design.arithmetic import FloatArray
from coupling_design.events.settled_state import period_of
from coupling_design.events.shutdown import fuel_torque
from coupling_design.line.contact import half_gap_angle
from coupling_design.line.even_start import quasi_steady_state
from coupling_design.line.forced_response import angle_phasor
from coupling_design.line.parameters import Driveline, KeyedConnection, Shutdown

# Pressed this far, in widths of its smoothing, a contact is a spring to 1e-9.
_FIRMLY = 10.0
_SAMPLES_OF_THE_FASTEST = 32


class LiftOff:
    """Tells, by the linear response, whether a key lifts off its flank.

    Parameters
    ----------
    driveline, shutdown : of values and of the symbols in `parameters`
    parameters : symbols (m,)
    """

    def __init__(
        self, driveline: Driveline, shutdown: Shutdown, parameters: ca.SX
    ) -> None:
        self._line, self._shutdown, self._p = driveline, shutdown, parameters

    def happens(self, values: FloatArray) -> bool:
        """Return whether the contact opens, or is pressed too little to be a spring.

        `values` (m,) are those of the parameters. Without a gap it is one both ways.
        """
        if not isinstance(self._line.connection, KeyedConnection):
            return False
        gap, firm, pressed, real, imaginary = (
            np.asarray(part, dtype=float).ravel() for part in self._contact(values)
        )
        if gap[0] == 0.0:
            return False
        least = pressed[0] - np.hypot(real, imaginary).sum()
        if least < firm[0]:  # should all crests meet: look closer
            waves = np.outer(self._angles, self._orders)
            swing = np.sin(waves) @ real + np.cos(waves) @ imaginary
            least = pressed[0] + swing.min()
        return bool(least < firm[0])

    @cached_property
    def _orders(self) -> FloatArray:
        return np.array([o.order for o in self._line.excitation], dtype=float)

    @cached_property
    def _angles(self) -> FloatArray:
        finest = 2 * math.pi / float(self._orders.max()) / _SAMPLES_OF_THE_FASTEST
        return np.arange(0.0, period_of(self._line.excitation), finest)

    @cached_property
    def _contact(self) -> ca.Function:
        """Gap, what presses firmly, the mean pressing and its phasors, in radians."""
        line, speed = self._line, self._shutdown.initial_speed
        connection = cast("KeyedConnection", line.connection)
        mean = quasi_steady_state(line, speed, fuel_torque(line, self._shutdown))
        twist = mean[1] - mean[2]
        side = ca.sign(twist)
        phasors = [angle_phasor(line, order, speed) for order in line.excitation]
        return ca.Function(
            "contact",
            [self._p],
            [
                ca.SX(connection.gap),
                ca.SX(_FIRMLY / (connection.smoothing * connection.radius)),
                ca.SX(side * twist - half_gap_angle(connection)),
                ca.SX(side * ca.vertcat(*(real[1] - real[2] for real, _ in phasors))),
                ca.SX(side * ca.vertcat(*(part[1] - part[2] for _, part in phasors))),
            ],
        )

"""The run-downs of one candidate at one time step: symbols, starts and marches."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cached_property

import casadi as ca
import numpy as np

from coupling_design.arithmetic import FloatArray
from coupling_design.errors import SimulationError
from coupling_design.events.recording import history_of
from coupling_design.events.shutdown import RunDown
from coupling_design.events.start import StartingStates
from coupling_design.lanes.march import start_compiling
from coupling_design.line.motion import inertias
from coupling_design.line.parameters import Start
from coupling_design.machine.candidate import Candidate
from coupling_design.machine.machine import Case
from coupling_design.march.divergence import steps_to_divergence
from coupling_design.march.fastest import fastest_marcher
from coupling_design.march.marcher import Marcher
from coupling_design.march.sensitivities import with_sensitivities
from coupling_design.signals.history import History
from coupling_design.wear.quantities import TOTALS
from coupling_design.wear.step import joint_step
from coupling_design.wear.variables import (
    CRANK_ANGLE,
    GRAVITY_ANGLE,
    INITIAL_SPEED,
    N_DESIGN,
    Variables,
    make_variables,
)


class RunDowns:
    """What marches a candidate's run-downs from columns of its variables to their ends.

    `time_step` [s]; everything symbolic is built at first use.
    """

    def __init__(
        self, case: Case, candidate: Candidate, time_step: float, n_steps: int
    ) -> None:
        self.case, self.candidate = case, candidate
        self.time_step, self.n_steps = time_step, n_steps
        self._starting: dict[Start, StartingStates] = {}

    def starting(self, start: Start | None = None) -> StartingStates:
        """Return what finds the states at t = 0, by the case's start or another."""
        law = start or self.case.shutdown.start
        if law not in self._starting:
            mine = self.variables
            self._starting[law] = StartingStates(
                mine.driveline,
                replace(mine.shutdown, start=law),
                mine.symbols,
                N_DESIGN,
                float(self.case.shutdown.initial_speed),
            )
        return self._starting[law]

    def totals_with_slopes(
        self, point: tuple[float, float], chances: FloatArray
    ) -> FloatArray:
        """Return TOTALS at the end of a point's run-downs, above their slopes.

        To stiffness and gap: (3, n_totals, n), for chances (2, n).
        """
        columns = self.variables.columns([point], chances)
        n = columns.shape[1]
        starts = self.starting()(columns, n, with_slopes=True)
        joint = joint_states_with_slopes(starts.states, starts.slopes)
        ends = self.march_with_sensitivities(joint, columns)
        return ends.reshape(1 + N_DESIGN, -1, n)[:, -len(TOTALS) :]

    def to_rest(self, states: FloatArray, columns: FloatArray) -> FloatArray:
        """Return the ends of run-downs (n, b), the faster ones after more steps.

        A stop from a speed higher by some per cent takes at most so much longer: what
        resists it is no less at the higher speed.
        """
        ends = self.march(states, columns)
        faster = columns[INITIAL_SPEED] / self.case.shutdown.initial_speed - 1
        # What comes of rounding needs no step more.
        for excess in np.unique(faster[faster > 1e-9]).tolist():
            mine = faster == excess
            march = fastest_marcher(self.step, math.ceil(excess * self.n_steps))
            ends[:, mine] = march(ends[:, mine], columns[:, mine])
        return ends

    def history(self, start: FloatArray, column: FloatArray) -> History:
        """Return one run-down in full, from a state (n, 1) at variables (m, 1)."""
        states = self.march.record(joint_states(start), column)[: -len(TOTALS)]
        values = column.ravel()
        driveline = self.variables.driveline_at(values)
        shutdown = replace(
            self.case.shutdown,
            time_step=self.time_step,
            initial_speed=float(values[INITIAL_SPEED]),
            crank_angle=float(values[CRANK_ANGLE]),
            gravity_angle=float(values[GRAVITY_ANGLE]),
        )
        return history_of(RunDown(driveline, shutdown), states)

    def divergence(
        self, starts: FloatArray, columns: FloatArray, totals: FloatArray
    ) -> SimulationError:
        """Return that the first run-down whose totals (..., b) are lost, and when."""
        kept = np.isfinite(totals).reshape(-1, columns.shape[1]).all(axis=0)
        at = int(np.argmin(kept))
        start, column = starts[:, at], columns[:, at]
        state = ca.DM(joint_states(start[:, np.newaxis]))
        steps = steps_to_divergence(self.step, self.n_steps, state, ca.DM(column))
        k, gap = column[:N_DESIGN]
        return SimulationError(
            f"{self.case.file}: the run-down of {self.candidate.label} at "
            f"{k:.6g} N*m/rad and a gap of {gap * 1e3:.4g} mm "
            f"left finite numbers by {steps * self.time_step:.4g} s, with a step of "
            f"{self.time_step:.3g} s. Take a smaller shutdown.time_step, or a softer "
            "contact."
        )

    def start_compiling(self) -> None:
        """Have the machine code of values made while something else is done."""
        start_compiling(self.step)

    @cached_property
    def variables(self) -> Variables:
        """The vector whose values make a run-down."""
        return make_variables(self.case, self.candidate)

    @cached_property
    def speeds(self) -> slice:
        """Where the speeds stand in a joint state."""
        n = len(inertias(self.variables.driveline))
        return slice(n, 2 * n)

    @cached_property
    def step(self) -> ca.Function:
        """(joint state, variables) -> joint state one time step later."""
        mine = self.variables
        return joint_step(mine.event, self.case, mine.symbols, self.time_step)

    @cached_property
    def march(self) -> Marcher:
        """From joint states at t = 0 to those at the end."""
        return fastest_marcher(self.step, self.n_steps)

    @cached_property
    def march_with_sensitivities(self) -> Marcher:
        """The same, derivatives to stiffness and gap below the state."""
        step = with_sensitivities(self.step, range(N_DESIGN))
        return fastest_marcher(step, self.n_steps)


def joint_states(starts: FloatArray) -> FloatArray:
    """Return joint states at t = 0 (n + totals, b) of the line's states (n, b)."""
    return np.vstack([starts, np.zeros((len(TOTALS), starts.shape[1]))])


def joint_states_with_slopes(starts: FloatArray, slopes: FloatArray) -> FloatArray:
    """Return the same with slopes (b, n, v), column after column, below each state."""
    b, _, v = slopes.shape
    padded = np.concatenate([slopes, np.zeros((b, len(TOTALS), v))], axis=1)
    below = padded.transpose(2, 1, 0).reshape(-1, b)
    return np.vstack([joint_states(starts), below])

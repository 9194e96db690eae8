"""The line before its run-down: held at its mean speed, marched over a part of a turn.

Each inertia is driven by J_i dec, so that the joints carry what they carry in the
run-down; the orders push at the crank's mean position, which is one more state.
"""

from __future__ import annotations

import math

import casadi as ca

from coupling_design.arithmetic import Scalar
from coupling_design.events.settled_state import settled_state
from coupling_design.events.shutdown import fuel_torque
from coupling_design.line.even_start import (
    all_resistances,
    quasi_steady_state,
)
from coupling_design.line.motion import inertias, motion
from coupling_design.line.parameters import Driveline, Shutdown
from coupling_design.march.runge_kutta import rk4_step
from coupling_design.march.sensitivities import with_sensitivities
from coupling_design.march.tower import march


class HeldLine:
    """The held line's functions of the parameters (m,), and of its state (n,).

    Parameters
    ----------
    driveline, shutdown : of values and of the symbols in `parameters`
    parameters : symbols (m,), the first `n_varied` of which slopes are wanted to
    """

    def __init__(
        self, driveline: Driveline, shutdown: Shutdown, parameters: ca.SX, n_varied: int
    ) -> None:
        self._line, self._shutdown = driveline, shutdown
        self._p, self.n_varied = parameters, n_varied
        self._fuel = fuel_torque(driveline, shutdown)
        self.n_states = 2 * len(inertias(driveline))

    def guess(self) -> ca.Function:
        """Return parameters -> state if no gap opened, and its slopes (n, n_varied)."""
        shutdown = self._shutdown
        return self._with_slopes(
            settled_state(
                self._line, shutdown.initial_speed, shutdown.crank_angle, self._fuel
            )
        )

    def crank(self) -> ca.Function:
        """Return parameters -> the crank's mean position at t = 0 [rad], its slopes.

        The position is (1,), its slopes (1, n_varied).
        """
        speed = self._shutdown.initial_speed
        mean = quasi_steady_state(self._line, speed, self._fuel)
        return self._with_slopes(ca.SX(self._shutdown.crank_angle + mean[0]))

    def step(self, angle: float, speed: float) -> tuple[ca.Function, int]:
        """Return (state, parameters and n zeros) -> state a step later, and its number.

        The state (n + 1,) is the held line's and the crank's mean position [rad]; the
        parameters and zeros are (m + n,). So many steps make the crank angle; none is
        longer than the shutdown's at `speed` [rad/s].
        """
        steps = max(math.ceil(angle / speed / self._shutdown.time_step - 1e-9), 1)
        h = angle / self._shutdown.initial_speed / steps
        state = ca.SX.sym("state", self.n_states + 1)
        # Derivatives to the start are carried along as if to parameters of their own.
        joint = ca.vertcat(self._p, ca.SX.sym("start", self.n_states))
        step = ca.Function(
            "held",
            [state, joint],
            [rk4_step(self._rate, state, h)],
            ["state", "parameters"],
            ["state_next"],
        )
        return step, steps

    def march_over(
        self, angle: float, speed: float, *, with_slopes: bool
    ) -> ca.Function:
        """Return the march of these steps over a crank angle [rad].

        With slopes the derivatives to what is varied, then to the line's own start, lie
        below the state: (n + 1,) without, ((n + 1) (1 + n_varied + n),) with them.
        """
        step, steps = self.step(angle, speed)
        if not with_slopes:
            return march(step, steps)
        n, m = self.n_states, self._p.numel()
        varied = [*range(self.n_varied), *range(m, m + n)]
        return march(with_sensitivities(step, varied), steps)

    def _rate(self, state: Scalar) -> Scalar:
        line, n = self._line, self.n_states
        speed = self._shutdown.initial_speed
        rates = motion(line, state[:n], self._fuel, crank_angle=state[n]).state_rate
        held = (all_resistances(line, speed) - self._fuel) / sum(inertias(line))
        return ca.vertcat(rates[: n // 2], rates[n // 2 :] + held, speed)

    def _with_slopes(self, found: Scalar) -> ca.Function:
        slopes = ca.jacobian(found, self._p[: self.n_varied])
        return ca.Function("found", [self._p], [found, ca.densify(slopes)])

"""The driveline's equations in other hands: SciPy's DOP853, or our own march.

Sources
-------
[1] Hairer, Norsett, Wanner (1993), Solving Ordinary Differential Equations I, II.5:
    DOP853, order 8 with step control, as SciPy wraps the authors' own program.
"""

import casadi as ca
import numpy as np

from coupling_design.line.motion import motion, state_names
from coupling_design.march.runge_kutta import rk4_step
from coupling_design.march.tower import march

NO_PARAMETERS = ca.DM(0, 1)


def state_symbol(driveline):
    """Return a symbol for the state of a driveline."""
    return ca.SX.sym("state", len(state_names(driveline)))


def rate_function(driveline, extend=None):
    """Return the function state -> rate; `extend` adds rates of further entries.

    `extend(state, now)` is a column of rates that depend on the driveline's motion.
    """
    state = state_symbol(driveline)
    now = motion(driveline, state)
    more = extend(state, now) if extend else ca.SX(0, 1)
    n_more = more.size1()
    joint = ca.vertcat(state, ca.SX.sym("more", n_more))
    rate = ca.cse(ca.vertcat(now.state_rate, more))
    return ca.Function("rate", [joint], [rate])


def dop853(rate, start, times, tolerance=1e-12, absolute=1e-14):
    """Return the states (n_states, n_times) by [1]; `times` begin with the start."""
    from scipy.integrate import ode

    buffer, evaluate = rate.buffer()
    state, result = np.zeros(rate.size1_in(0)), np.zeros(rate.size1_out(0))
    buffer.set_arg(0, memoryview(state))
    buffer.set_res(0, memoryview(result))

    def right_hand_side(_, y):
        state[:] = y
        evaluate()
        return result.copy()

    solver = ode(right_hand_side)
    solver.set_integrator("dop853", rtol=tolerance, atol=absolute, nsteps=10**8)
    solver.set_initial_value(np.asarray(start, dtype=float).ravel(), times[0])
    states = [solver.y]
    for time in times[1:]:
        states.append(solver.integrate(time))
        assert solver.successful()
    return np.column_stack(states)


def rk4(rate, start, time_step, n_steps):
    """Return the state after n_steps by the code's own step and march."""
    state = ca.SX.sym("state", rate.size1_in(0))
    parameters = ca.SX.sym("parameters", 0)
    step = ca.Function(
        "step",
        [state, parameters],
        [ca.cse(rk4_step(rate, state, time_step))],
        ["state", "parameters"],
        ["state_next"],
    )
    end = march(step, n_steps)(ca.DM(start), NO_PARAMETERS)
    return np.asarray(end, dtype=float).ravel()

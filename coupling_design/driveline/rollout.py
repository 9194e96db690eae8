"""Marching a Runge-Kutta step over many steps, with exact sensitivities.

Nothing here knows of drivelines: a step is any CasADi function of a state and
parameters, so the march is tested on x' = A x.

Sources
-------
[1] Hairer, Norsett, Wanner (1993), Solving Ordinary Differential Equations I, II.1:
    the classical Runge-Kutta method, table 1.2.
"""

from __future__ import annotations

from collections.abc import Callable

import casadi as ca

from coupling_design.arithmetic import Scalar

# Ten calls a level keep the graph logarithmic in the number of steps. CasADi's own
# fold builds one level too many and keeps every state: 4 times the memory.
_BASE = 10


def rk4_step(
    rate: Callable[[Scalar], Scalar], state: Scalar, time_step: Scalar
) -> Scalar:
    """Return the state one step later by the classical Runge-Kutta method, [1]."""
    h, y = time_step, state
    k1 = rate(y)
    k2 = rate(y + h / 2 * k1)
    k3 = rate(y + h / 2 * k2)
    k4 = rate(y + h * k3)
    return y + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)


def march(step: ca.Function, n_steps: int) -> ca.Function:
    """Return the function that applies `step` n_steps times.

    Parameters
    ----------
    step : function (state, parameters) -> state
    n_steps : at least 1

    Returns
    -------
    function with the same ports; its memory does not grow with n_steps
    """
    block, total = step, None
    remaining = n_steps
    while True:
        remaining, digit = divmod(remaining, _BASE)
        if digit:
            part = _repeat(block, digit)
            total = part if total is None else _compose(total, part)
        if not remaining:
            break
        block = _repeat(block, _BASE)
    if total is None:
        message = f"a march needs at least one step, not {n_steps}"
        raise ValueError(message)
    return total


def with_sensitivities(step: ca.Function) -> ca.Function:
    """Return the step that carries d state / d parameters along with the state.

    The new state is the old one above its sensitivities, column after column:
    (1 + n_parameters) n_states entries; see `join_sensitivities`. Forward
    differentiation inside the step costs less than differentiating the march.
    """
    n, m = step.size1_in(0), step.size1_in(1)
    state, parameters = ca.SX.sym("state", n), ca.SX.sym("parameters", m)
    sensitivities = ca.SX.sym("sensitivities", n, m)
    state_next = step(state, parameters)
    moved = ca.jtimes(
        state_next,
        ca.vertcat(state, parameters),
        ca.vertcat(sensitivities, ca.SX.eye(m)),
    )
    joint_next = ca.cse(ca.vertcat(state_next, ca.vec(moved)))
    return ca.Function(
        f"{step.name()}_with_sensitivities",
        [ca.vertcat(state, ca.vec(sensitivities)), parameters],
        [joint_next],
        ["state", "parameters"],
        ["state_next"],
    )


def join_sensitivities(state: Scalar, sensitivities: Scalar) -> Scalar:
    """Return the state of a step made by `with_sensitivities`."""
    return ca.vertcat(state, ca.vec(sensitivities))


def record(step: ca.Function, output: ca.Function, n_steps: int) -> ca.Function:
    """Return (state, parameters) -> (state after n_steps, outputs at each start).

    `output` is a function (state, parameters) -> column; the second result has one
    column for each step, taken before the step is made.
    """
    state = ca.MX.sym("state", step.size1_in(0))
    parameters = ca.MX.sym("parameters", step.size1_in(1))
    one = ca.Function(
        "recorded_step",
        [state, parameters],
        [step(state, parameters), output(state, parameters)],
    )
    many = one.mapaccum("record", n_steps, {"base": n_steps + 1})
    states, outputs = many(state, ca.repmat(parameters, 1, n_steps))
    return ca.Function(
        "record",
        [state, parameters],
        [states[:, -1], outputs],
        ["state", "parameters"],
        ["state_next", "outputs"],
    )


def _repeat(function: ca.Function, times: int) -> ca.Function:
    state, parameters = function.mx_in()
    for_each = state
    for _ in range(times):
        for_each = function(for_each, parameters)
    return _named(f"{function.name()}_{times}", state, parameters, for_each)


def _compose(first: ca.Function, second: ca.Function) -> ca.Function:
    state, parameters = first.mx_in()
    state_next = second(first(state, parameters), parameters)
    return _named(f"{first.name()}_then", state, parameters, state_next)


def _named(name: str, state: ca.MX, parameters: ca.MX, next_: ca.MX) -> ca.Function:
    return ca.Function(
        name,
        [state, parameters],
        [next_],
        ["state", "parameters"],
        ["state_next"],
    )

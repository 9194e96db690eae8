"""Applying a step many times: the rollout as one CasADi function.

A step is any CasADi function (state, parameters) -> state, so the march is tested on
x' = A x.
"""

from __future__ import annotations

import casadi as ca

# Ten calls a level keep the graph logarithmic in the number of steps. CasADi's own
# fold builds one level too many and keeps every state: 4 times the memory.
_BASE = 10


def march(step: ca.Function, n_steps: int) -> ca.Function:
    """Return the function that applies `step` n_steps times.

    Parameters
    ----------
    step : function (state, parameters) -> state
    n_steps : at least 1

    Returns
    -------
    function with the same ports; its memory does not grow with n_steps

    Raises
    ------
    ValueError
        If n_steps is less than 1.
    """
    if n_steps < 1:
        raise ValueError(f"a march needs at least one step, not {n_steps}")
    total: ca.Function | None = None
    block, remaining = step, n_steps
    while True:
        remaining, digit = divmod(remaining, _BASE)
        if digit:
            part = _repeat(block, digit)
            total = part if total is None else _compose(total, part)
        if not remaining:
            return total or step  # at least one digit is not zero
        block = _repeat(block, _BASE)


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

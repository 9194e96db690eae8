"""A march that keeps what happened on the way."""

from __future__ import annotations

import casadi as ca


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

"""A step that carries its exact derivatives to the parameters along."""

from __future__ import annotations

from collections.abc import Sequence

import casadi as ca

from coupling_design.arithmetic import Scalar
from coupling_design.lanes.rewriting.symbols import with_shared_powers


def with_sensitivities(
    step: ca.Function, varied: Sequence[int] | None = None
) -> ca.Function:
    """Return the step that carries d state / d parameters along with the state.

    The new state is the old one above its sensitivities, column after column:
    (1 + n_varied) n_states entries; see `join_sensitivities`. Forward differentiation
    inside the step costs less than differentiating the march. `varied` are the places
    of the parameters to differentiate by, all if not given.
    """
    step = with_shared_powers(step)
    n, m = step.size1_in(0), step.size1_in(1)
    places = list(range(m)) if varied is None else list(varied)
    state, parameters = ca.SX.sym("state", n), ca.SX.sym("parameters", m)
    sensitivities = ca.SX.sym("sensitivities", n, len(places))
    state_next = step(state, parameters)
    moved = ca.jtimes(
        state_next,
        ca.vertcat(state, parameters),
        ca.vertcat(sensitivities, ca.SX.eye(m)[:, places]),
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
    """Return the state of a step made by `with_sensitivities`.

    A state (n,) and sensitivities (n, n_varied) make ((1 + n_varied) n,).
    """
    return ca.vertcat(state, ca.vec(sensitivities))

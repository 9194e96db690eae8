"""When a march leaves finite numbers."""

from __future__ import annotations

import casadi as ca
import numpy as np

from coupling_design.march.tower import march


def steps_to_divergence(
    step: ca.Function, n_steps: int, state: ca.DM, parameters: ca.DM
) -> int:
    """Return after how many steps a state is not finite, to a thousandth of n_steps.

    At least n_steps if it stays finite. `state` is (n, 1), `parameters` (m, 1).
    """
    steps, chunk = 0, max(n_steps // 1000, 1)
    advance = march(step, chunk)
    while steps < n_steps and np.isfinite(np.asarray(state)).all():
        state, steps = advance(state, parameters), steps + chunk
    return steps

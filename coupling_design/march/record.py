"""A march that keeps the states on the way."""

from __future__ import annotations

import casadi as ca
import numpy as np

from coupling_design.arithmetic import FloatArray

# In pieces, so that the graph stays small however long the march is.
_PIECE = 1000


def record(
    step: ca.Function, n_steps: int, states: FloatArray, parameters: FloatArray
) -> FloatArray:
    """Return the states at the start of every step, shape (n, n_steps).

    Parameters
    ----------
    step : function (state, parameters) -> state
    n_steps : at least 1
    states, parameters : one column, shapes (n, 1) and (m, 1)
    """
    full, rest = divmod(n_steps, _PIECE)
    lengths = [_PIECE] * full + ([rest] if rest else [])
    recorders = {
        # One level of calls: more would keep every state twice.
        length: step.mapaccum("record", length, {"base": length + 1})
        for length in set(lengths)
    }
    pieces: list[FloatArray] = [np.asarray(states, dtype=np.float64)]
    for length in lengths:
        repeated = np.repeat(parameters, length, axis=1)
        following = recorders[length](pieces[-1][:, -1], repeated)
        pieces.append(np.asarray(following, dtype=np.float64))
    return np.hstack(pieces)[:, :n_steps]

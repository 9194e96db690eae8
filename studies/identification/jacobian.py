"""Derivatives of what a batch of rollouts gives, by differences."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from coupling_design.arithmetic import FloatArray


def differences(
    function: Callable[[FloatArray], FloatArray],
    point: FloatArray,
    low: FloatArray,
    high: FloatArray,
    step: float,
) -> FloatArray:
    """Return the Jacobian (m, n) by differences, central where the bounds allow.

    `function` takes many points (k, n) at once and returns (k, m).
    """
    n = len(point)
    above = np.minimum(point + step * np.eye(n), high)
    below = np.maximum(point - step * np.eye(n), low)
    found = function(np.vstack([above, below]))
    width = np.diagonal(above) - np.diagonal(below)
    jacobian: FloatArray = ((found[:n] - found[n:]) / width[:, np.newaxis]).T
    return jacobian

"""Steady vibration of a chain, gaps closed, under torques that fluctuate.

Sources
-------
[1] Friswell, Penny, Garvey, Lees (2010), Dynamics of Rotating Machines: the receptance
    of a linear system, q = (K + j w C - w^2 M)^-1 T.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from coupling_design.arithmetic import FloatArray
from coupling_design.line.chain import Chain, chain_mass, chain_stiffness

ComplexArray = NDArray[np.complex128]


def chain_response(
    chain: Chain,
    omega: FloatArray,
    outer_torques: ComplexArray,
    joint_damping: Sequence[FloatArray],
    outer_damping: Sequence[float],
) -> ComplexArray:
    """Return the complex angles q of the bodies, (..., n_bodies) [rad], by [1].

    An angle or torque fluctuates as Im(q exp(j w t)).

    Parameters
    ----------
    chain : of values
    omega : angular frequencies (...) [rad/s]
    outer_torques : complex, on each inertia (..., n) [N m]
    joint_damping : of each joint that is not rigid, at each frequency (...)
        [N m s/rad]; a joint's own where it does not depend on frequency
    outer_damping : brakes each inertia against what stands still (n,) [N m s/rad]
    """
    M, K = chain_mass(chain), chain_stiffness(chain)
    C = _damping(chain, joint_damping, outer_damping)
    w = omega[..., np.newaxis, np.newaxis]
    members = _membership(chain)
    force = (outer_torques @ members)[..., np.newaxis]
    angles: NDArray[Any] = np.linalg.solve(K + 1j * w * C - w**2 * M, force)
    return angles[..., 0]


def _membership(chain: Chain) -> FloatArray:
    """Return 1 where an inertia is part of a body, (n, n_bodies)."""
    members = np.zeros((len(chain.inertias), len(chain.bodies)))
    for k, body in enumerate(chain.bodies):
        members[list(body), k] = 1.0
    return members


def _damping(
    chain: Chain, joint_damping: Sequence[FloatArray], outer_damping: Sequence[float]
) -> FloatArray:
    """Return the damping matrix at each frequency (..., n_bodies, n_bodies)."""
    n = len(chain.bodies)
    grounds = np.asarray(outer_damping, dtype=float) @ _membership(chain)
    matrix: FloatArray = np.diag(grounds)
    for i, c in enumerate(joint_damping):
        between = np.zeros((n, n))
        between[i : i + 2, i : i + 2] = [[1.0, -1.0], [-1.0, 1.0]]
        matrix = matrix + np.asarray(c)[..., np.newaxis, np.newaxis] * between
    return matrix

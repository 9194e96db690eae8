"""Linearised driveline with the gap closed: natural frequencies, modes, stable step.

Sources
-------
[1] Advances in Mechanical Engineering 2023, doi 10.1177/16878132231190062, eq. (1).
[2] Hairer, Wanner (1996), Solving Ordinary Differential Equations II, IV.2: the
    stability function of the classical Runge-Kutta method.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from coupling_design.arithmetic import FloatArray, Scalar, sqrt
from coupling_design.line.chain import chain_damping, chain_mass, chain_stiffness
from coupling_design.line.contact import LARGEST_RELATIVE_SLOPE
from coupling_design.line.motion import chain_of, reduced_inertia
from coupling_design.line.parameters import Driveline, KeyedConnection, Resistance

# |R(i y)| <= 1 for y <= 2 sqrt 2 on the imaginary axis, [2].
_SEARCH_STEPS = 60


@dataclass(frozen=True)
class Modes:
    """Natural frequencies (n,) [rad/s], ascending, and mode shapes (n, n) in columns.

    The first is the rigid-body mode; each shape's largest entry is 1.
    """

    angular_frequencies: FloatArray
    shapes: FloatArray


def natural_angular_frequency(driveline: Driveline) -> Scalar:
    """Return the lowest torsional natural frequency [rad/s]; value or symbol.

    Undamped, gap closed. Tight fit: two masses, omega^2 = k / J_red. Keyed: the
    smaller root of omega^4 - B omega^2 + C = 0 for the chain J1 -k- J2 -k_g- J3,
    written so that it loses no digits when the key is much the stiffer.
    """
    k = driveline.coupling.torsional_stiffness
    if not isinstance(driveline.connection, KeyedConnection):
        return sqrt(k / reduced_inertia(driveline))
    J1, J2 = driveline.engine_inertia, driveline.coupling_inertia
    J3 = driveline.generator_inertia
    k_g = driveline.connection.contact_stiffness
    B = k * (1 / J1 + 1 / J2) + k_g * (1 / J2 + 1 / J3)
    C = k * k_g * (J1 + J2 + J3) / (J1 * J2 * J3)
    return sqrt(2 * C / (B + sqrt(B**2 - 4 * C)))


def mass_matrix(driveline: Driveline) -> Scalar:
    """Return the inertias on a diagonal, (3, 3) keyed or (2, 2) tight [kg m^2]."""
    return chain_mass(chain_of(driveline))


def stiffness_matrix(driveline: Driveline, contact_slope: Scalar = 1.0) -> Scalar:
    """Return the stiffness matrix (n_bodies, n_bodies), gap closed [N m/rad].

    `contact_slope` multiplies the contact stiffness: 1 on the flank of the key.
    """
    return chain_stiffness(chain_of(driveline), contact_slope)


def damping_matrix(driveline: Driveline) -> Scalar:
    """Return the damping matrix (n_bodies, n_bodies) [N m s/rad].

    Resistances are as steep as at standstill.
    """
    first = _resistance_slope(driveline.engine_resistance)
    last = _resistance_slope(driveline.generator_resistance)
    return chain_damping(chain_of(driveline), (first, 0.0, last))


def modes(driveline: Driveline) -> Modes:
    """Return all natural frequencies and mode shapes, undamped, with the gap closed.

    Frequencies are (n_bodies,) [rad/s], shapes (n_bodies, n_bodies) [-].
    """
    # The masses are a diagonal: K v = omega^2 M v is symmetric in M^(1/2) v.
    roots = np.sqrt(mass_matrix(driveline).diagonal())
    scaled = stiffness_matrix(driveline) / np.outer(roots, roots)
    squares, vectors = np.linalg.eigh(scaled)
    shapes = vectors / roots[:, np.newaxis]
    largest = shapes[np.abs(shapes).argmax(axis=0), range(len(squares))]
    # The rigid-body root is zero; rounding may leave it slightly negative.
    return Modes(np.sqrt(np.maximum(squares, 0.0)), shapes / largest)


def largest_stable_step(driveline: Driveline) -> float:
    """Return the largest time step [s] at which classical RK4 stays bounded.

    The linearised model with the key pressed, its contact as steep as the smoothing
    makes it, must have |R(h lambda)| <= 1 for each eigenvalue lambda, [2].
    """
    inverse_mass = np.linalg.inv(mass_matrix(driveline))
    K = stiffness_matrix(driveline, LARGEST_RELATIVE_SLOPE)
    C = damping_matrix(driveline)
    n = len(K)
    A = np.block(
        [[np.zeros((n, n)), np.eye(n)], [-inverse_mass @ K, -inverse_mass @ C]]
    )
    eigenvalues = np.linalg.eigvals(A)
    fastest = float(np.abs(eigenvalues).max())
    # Slow ones never set the limit. Among them is the rigid body's double zero, which
    # rounding splits into a pair of about 1e-8 of the fastest, one of them growing.
    moving = eigenvalues[np.abs(eigenvalues) > 1e-6 * fastest]
    return min(_stable_step(complex(eigenvalue)) for eigenvalue in moving)


def _stable_step(eigenvalue: complex) -> float:
    """Return the largest h with |R(h lambda)| <= 1, by bisection along the ray."""
    inside, outside = 0.0, 3.0
    for _ in range(_SEARCH_STEPS):
        middle = (inside + outside) / 2
        if abs(_stability_function(middle * eigenvalue / abs(eigenvalue))) <= 1.0:
            inside = middle
        else:
            outside = middle
    return inside / abs(eigenvalue)


def _stability_function(z: complex) -> complex:
    return 1 + z + z**2 / 2 + z**3 / 6 + z**4 / 24


def _resistance_slope(resistance: Resistance) -> Scalar:
    return resistance.viscous + resistance.friction / resistance.transition_speed

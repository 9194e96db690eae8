"""Damping of a coupling as its type's own law makes it follow the stiffness.

Sources
-------
[1] Advances in Mechanical Engineering 2023, doi 10.1177/16878132231190062.
[2] DIN 740-2:1986, Flexible shaft couplings; relative damping psi = A_D / A_el.
"""

from __future__ import annotations

import math

from coupling_design.arithmetic import Scalar, sqrt
from coupling_design.line.parameters import (
    Coupling,
    DampingLaw,
    LossFactorDamping,
    ProportionalDamping,
)


def coupling_damping(coupling: Coupling, reduced_inertia: Scalar) -> Scalar:
    """Return the viscous damping of the coupling [N m s/rad].

    It is of the shape of its arguments.

    Parameters
    ----------
    coupling : stiffness [N m/rad] and damping law
    reduced_inertia : J1 (J2 + J3) / (J1 + J2 + J3) [kg m^2], of the two masses that
        the coupling lies between

    Notes
    -----
    Proportional, below [1] eq. (1): c = kappa0 k / omega0, at every frequency.
    Loss factor and relative damping [2] are damping work per cycle at a frequency;
    ours is the natural frequency of the two masses, omega_n = sqrt(k / J_red), where
    the work is done: c = eta k / omega_n and c = psi k / (2 pi omega_n).
    """
    k = coupling.torsional_stiffness
    law: DampingLaw = coupling.damping_law
    if isinstance(law, ProportionalDamping):
        return law.damping_factor * k / law.characteristic_frequency
    omega_n = sqrt(k / reduced_inertia)
    if isinstance(law, LossFactorDamping):
        return law.loss_factor * k / omega_n
    return law.relative_damping * k / (2 * math.pi * omega_n)

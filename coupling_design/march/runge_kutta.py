"""The classical Runge-Kutta method.

Sources
-------
[1] Hairer, Norsett, Wanner (1993), Solving Ordinary Differential Equations I, II.1:
    the classical Runge-Kutta method, table 1.2.
"""

from __future__ import annotations

from collections.abc import Callable

from coupling_design.arithmetic import Scalar


def rk4_step(
    rate: Callable[[Scalar], Scalar], state: Scalar, time_step: Scalar
) -> Scalar:
    """Return the state one step later by the classical Runge-Kutta method, [1].

    It is of the shape of `state`, and so is what `rate` returns.
    """
    h, y = time_step, state
    k1 = rate(y)
    k2 = rate(y + h / 2 * k1)
    k3 = rate(y + h / 2 * k2)
    k4 = rate(y + h * k3)
    return y + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)

"""The keyed run-down as a user of scipy would write it for solve_ivp.

The states are what the torques know: twists engine to coupling and coupling to
generator, the engine's angle, and the speeds of the three. A tolerance relative to
angles of hundreds of rad would say nothing about twists of a tenth of a millirad.
Written once for numbers (math), arrays (numpy) and numba.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from types import ModuleType
from typing import Any

import numpy as np

from coupling_design.arithmetic import FloatArray

Rates = Callable[[Any, Any, Any, Any, Any, Any], tuple[Any, ...]]


def rates_of(
    M: list[float], k: float, gap: float, functions: ModuleType = math
) -> Rates:
    """Return the states' rates as a function of the states; M after machine.h."""
    sin, tanh = functions.sin, functions.tanh
    J1, J2, J3, kappa0, omega0, radius, k_g, c_oil, smoothing = M[:9]
    T4, p4, T8, p8, c_t1, T_f1, w_t1, c_t3, T_f3, w_t3 = M[9:19]
    c, b, s = kappa0 * k / omega0, gap / (2 * radius), smoothing * radius

    def rates(x: Any, z: Any, q1: Any, u: Any, v: Any, w1: Any) -> tuple[Any, ...]:
        w3 = w1 - u - v
        Tc = k * x + c * u
        f = z + 0.5 * ((z - b) * tanh(s * (z - b)) - (z + b) * tanh(s * (z + b)))
        F = k_g * f + c_oil * v
        T1 = T4 * sin(4 * q1 + p4) + T8 * sin(8 * q1 + p8)
        a1 = (T1 - c_t1 * w1 - T_f1 * tanh(w1 / w_t1) - Tc) / J1
        a2 = (Tc - F) / J2
        a3 = (F - c_t3 * w3 - T_f3 * tanh(w3 / w_t3)) / J3
        return u, v, w1, a1 - a2, a2 - a3, a1

    return rates


def jacobian_of(M: list[float], k: float, gap: float) -> Rates:
    """Return the derivatives of the rates by the states, of numbers, a row each."""
    cos, tanh = math.cos, math.tanh
    J1, J2, J3, kappa0, omega0, radius, k_g, c_oil, smoothing = M[:9]
    T4, p4, T8, p8, c_t1, T_f1, w_t1, c_t3, T_f3, w_t3 = M[9:19]
    c, b, s = kappa0 * k / omega0, gap / (2 * radius), smoothing * radius
    c_1, c_2, k_1, k_2, d_2, d_3 = (
        c / J1,
        c / J2,
        k / J1,
        k / J2,
        c_oil / J2,
        c_oil / J3,
    )

    def jacobian(
        x: float, z: float, q1: float, u: float, v: float, w1: float
    ) -> tuple[Any, ...]:
        m, r, w3 = s * (z - b), s * (z + b), w1 - u - v
        t, t_ = tanh(m), tanh(r)
        f = 1 + 0.5 * (t - t_ + m * (1 - t * t) - r * (1 - t_ * t_))
        g = (4 * T4 * cos(4 * q1 + p4) + 8 * T8 * cos(8 * q1 + p8)) / J1
        e_1 = (c_t1 + T_f1 / w_t1 * (1 - tanh(w1 / w_t1) ** 2)) / J1
        e_3 = (c_t3 + T_f3 / w_t3 * (1 - tanh(w3 / w_t3) ** 2)) / J3
        p, p_ = k_g * f / J2, k_g * f / J3
        return (
            (0, 0, 0, 1, 0, 0),
            (0, 0, 0, 0, 1, 0),
            (0, 0, 0, 0, 0, 1),
            (-k_1 - k_2, p, g, -c_1 - c_2, d_2, -e_1),
            (k_2, -p - p_, 0, c_2 - e_3, -d_2 - d_3 - e_3, e_3),
            (-k_1, 0, g, -c_1, 0, -e_1),
        )

    return jacobian


def twists(y: FloatArray) -> FloatArray:
    """Return these states of a joint state (three angles, three speeds, ...)."""
    return np.array(
        [y[0] - y[1], y[1] - y[2], y[0], y[3] - y[4], y[4] - y[5], y[3]], dtype=float
    )


def between_steps(
    rates: Rates, t: FloatArray, y: FloatArray, wanted: FloatArray
) -> FloatArray:
    """Return the states at the wanted times, from those at a solver's own steps.

    Between two steps an angle is the polynomial of degree 5 that has both ends' angles,
    speeds and accelerations; a speed is its derivative. For all times at once, this
    costs a tenth of what the solver takes for the same one step after another.
    """
    i = np.clip(np.searchsorted(t, wanted, side="right") - 1, 0, len(t) - 2)
    h, a = np.diff(t), np.array(rates(*y)[3:])
    v_0, a_0 = h * y[3:, :-1], h * h * a[:, :-1]
    d, d_v = np.diff(y[:3]) - v_0 - a_0 / 2, h * np.diff(y[3:]) - a_0
    d_a = h * h * np.diff(a)
    powers = (
        *(y[:3, :-1], v_0, a_0 / 2),
        *(
            10 * d - 4 * d_v + d_a / 2,
            -15 * d + 7 * d_v - d_a,
            6 * d - 3 * d_v + d_a / 2,
        ),
    )
    c_0, c_1, c_2, c_3, c_4, c_5 = (power[:, i] for power in powers)
    s = (wanted - t[i]) / h[i]
    angles = c_0 + s * (c_1 + s * (c_2 + s * (c_3 + s * (c_4 + s * c_5))))
    speeds = c_1 + s * (2 * c_2 + s * (3 * c_3 + s * (4 * c_4 + s * 5 * c_5)))
    return np.concatenate([angles, speeds / h[i]])


def totals(M: list[float], gap: float, y: FloatArray) -> FloatArray:
    """Return two damages and three peaks of the states at each time step.

    More accurate than eq. (14)'s sum and the largest sample, at no cost: the first and
    the last sample count half, and a peak is that of the parabola through the largest
    sample and its neighbours.
    """
    x, z, q1, u, v, w1 = y
    b, s, speed = gap / (2 * M[5]), M[8] * M[5], np.abs(w1 - u - v)
    f = z + 0.5 * ((z - b) * np.tanh(s * (z - b)) - (z + b) * np.tanh(s * (z + b)))
    force, cosine = (M[6] * f + M[7] * v) / M[5], np.cos(q1 - x - z)
    factor = _bracket_factor(M, speed)
    damages, peaks = [], [_peak(np.abs(force))]
    for lever, G, C, C_u in zip(M[19:21], M[21:23], M[23:25], M[25:27], strict=True):
        Fr = lever * force
        P = np.sqrt(np.maximum(Fr * (Fr + 2 * G * cosine) + G * G, 1e-6))
        bracket = np.maximum(1 - factor * (C_u / P) ** 0.4, 0.5083403685049885)
        rate = speed * bracket**9.185 * (P / C) ** (10 / 3)
        sum_ = rate.sum() - (rate[0] + rate[-1]) / 2
        damages.append(sum_ * M[32] / (2 * math.pi * M[27] * 1e5))
        peaks.append(_peak(P))
    return np.array([*damages, *peaks])


def _bracket_factor(M: list[float], speed: FloatArray) -> FloatArray:
    """Return the factor of (C_u / P)^0.4 in the bracket of a_ISO, ISO 281."""
    n = np.maximum(speed * 30 / math.pi, 1e-3)
    nu_1 = np.where(n < 1000 - 1e-6, 45000 * n**-0.83, 4500 * n**-0.5)
    kappa = np.clip(M[28] / (nu_1 * M[29] ** -0.5), 0.1, 4.0)
    a = np.minimum(M[30] * kappa**0.68 * M[29] ** 0.55, 1.0)
    e_C = np.maximum(a * (1 - M[31] / M[29] ** (1 / 3)), 0.0)
    factor = np.where(kappa < 0.4, 1.3993, 1.2348)
    exponent = np.where(kappa < 0.4, 0.054381, np.where(kappa < 1, 0.19087, 0.071739))
    return np.asarray((1.5859 - factor / kappa**exponent) * e_C**0.4)


def _peak(samples: FloatArray) -> float:
    i = int(samples.argmax())
    middle = float(samples[i])
    if i in {0, len(samples) - 1}:
        return middle
    before, after = float(samples[i - 1]), float(samples[i + 1])
    curvature = 2 * middle - before - after
    return middle + (after - before) ** 2 / (8 * curvature) if curvature > 0 else middle

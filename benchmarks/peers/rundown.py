"""The keyed run-down in plain Python numbers, for numba and for solve_ivp."""

from __future__ import annotations

import math
from collections.abc import Callable

from coupling_design.arithmetic import FloatArray

Four = tuple[float, float, float, float]
Rates = Callable[..., Four]
Damage = Callable[..., tuple[float, float]]
March = Callable[[FloatArray, int, float, float, FloatArray], FloatArray]


def rates(
    M: FloatArray | list[float],
    k: float,
    gap: float,
    q1: float,
    q2: float,
    q3: float,
    w1: float,
    w2: float,
    w3: float,
) -> Four:
    """Return the accelerations and the force on the key [N]; M after machine.h."""
    T1 = M[9] * math.sin(4 * q1 + M[10]) + M[11] * math.sin(8 * q1 + M[12])
    T1 -= M[13] * w1 + M[14] * math.tanh(w1 / M[15])
    Td = M[16] * w3 + M[17] * math.tanh(w3 / M[18])
    Tc = k * (q1 - q2) + M[3] * k / M[4] * (w1 - w2)
    x, b, s = q2 - q3, gap / (2 * M[5]), M[8] * M[5]
    f = x + 0.5 * ((x - b) * math.tanh(s * (x - b)) - (x + b) * math.tanh(s * (x + b)))
    F = M[6] * f + M[7] * (w2 - w3)
    return (T1 - Tc) / M[0], (Tc - F) / M[1], (F - Td) / M[2], F / M[5]


def damage(
    M: FloatArray | list[float],
    force: float,
    lever: float,
    G: float,
    C: float,
    C_u: float,
    w3: float,
    q3: float,
) -> tuple[float, float]:
    """Return the rate of one bearing's damage [1/s], and its load [N], ISO 281."""
    n = max(abs(w3) * 30 / math.pi, 1e-3)
    nu_1 = 45000 * n**-0.83 if n < 1000 - 1e-6 else 4500 * n**-0.5
    kappa = min(max(M[28] / (nu_1 * M[29] ** -0.5), 0.1), 4.0)
    Fr = lever * force
    P = math.sqrt(max(Fr**2 + G**2 + 2 * Fr * G * math.cos(q3), 1e-6))
    a = min(M[30] * kappa**0.68 * M[29] ** 0.55, 1.0)
    e_C = max(a * (1 - M[31] / M[29] ** (1 / 3)), 0.0)
    if kappa < 0.4:
        bracket = 1.5859 - 1.3993 / kappa**0.054381
    elif kappa < 1:
        bracket = 1.5859 - 1.2348 / kappa**0.19087
    else:
        bracket = 1.5859 - 1.2348 / kappa**0.071739
    bracket = max(1 - bracket * (e_C * C_u / P) ** 0.4, 0.5083403685049885)
    life = M[27] * 0.1 * bracket**-9.185 * 1e6 * (C / P) ** (10 / 3)
    return abs(w3) / (2 * math.pi) / life, P


def march_with(rates: Rates, damage: Damage) -> March:
    """Return Runge-Kutta 4 with damages and peaks, of compiled or plain functions."""

    def march(
        M: FloatArray, n_steps: int, k: float, gap: float, y: FloatArray
    ) -> FloatArray:
        h = M[32]
        for _ in range(n_steps):
            q1, q2, q3, w1, w2, w3 = y[0], y[1], y[2], y[3], y[4], y[5]
            a1, a2, a3, force = rates(M, k, gap, q1, q2, q3, w1, w2, w3)
            d1, P1 = damage(M, force, M[19], M[21], M[23], M[25], w3, q3)
            d2, P2 = damage(M, force, M[20], M[22], M[24], M[26], w3, q3)
            y[6] += d1 * h
            y[7] += d2 * h
            y[8] = max(y[8], abs(force))
            y[9] = max(y[9], P1)
            y[10] = max(y[10], P2)
            u1, u2, u3 = w1 + h / 2 * a1, w2 + h / 2 * a2, w3 + h / 2 * a3
            b1, b2, b3, _ = rates(
                M, k, gap, q1 + h / 2 * w1, q2 + h / 2 * w2, q3 + h / 2 * w3, u1, u2, u3
            )
            v1, v2, v3 = w1 + h / 2 * b1, w2 + h / 2 * b2, w3 + h / 2 * b3
            c1, c2, c3, _ = rates(
                M, k, gap, q1 + h / 2 * u1, q2 + h / 2 * u2, q3 + h / 2 * u3, v1, v2, v3
            )
            x1, x2, x3 = w1 + h * c1, w2 + h * c2, w3 + h * c3
            e1, e2, e3, _ = rates(
                M, k, gap, q1 + h * v1, q2 + h * v2, q3 + h * v3, x1, x2, x3
            )
            y[0] = q1 + h / 6 * (w1 + 2 * (u1 + v1) + x1)
            y[1] = q2 + h / 6 * (w2 + 2 * (u2 + v2) + x2)
            y[2] = q3 + h / 6 * (w3 + 2 * (u3 + v3) + x3)
            y[3] = w1 + h / 6 * (a1 + 2 * (b1 + c1) + e1)
            y[4] = w2 + h / 6 * (a2 + 2 * (b2 + c2) + e2)
            y[5] = w3 + h / 6 * (a3 + 2 * (b3 + c3) + e3)
        return y

    return march

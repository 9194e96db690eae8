"""The same run-down by scipy's solve_ivp, as accurate as our own step."""

from __future__ import annotations

import time

import numpy as np
from scipy.integrate import solve_ivp

from benchmarks.peers import rundown
from benchmarks.subject import Subject
from coupling_design.arithmetic import FloatArray
from coupling_design.rollout.fastest import fastest_marcher

METHODS = ("RK45", "DOP853", "LSODA")
TOLERANCES = (1e-5, 1e-6, 1e-7, 1e-8, 1e-9)

# Half the present stiffness, and a worn key: it rattles.
POINT = (2.5e5, 2.8e-4)


def fastest_of_equal_accuracy(subject: Subject) -> tuple[str, float]:
    """Return the quickest method and tolerance that is as accurate, and its time [s].

    Accuracy is that of the damage of bearing 1 at the end, against a step 16 times
    finer.
    """
    machine, n_steps = subject.machine(), subject.case.shutdown.n_steps
    batch, fine = subject.at([POINT]), subject.refined(16)
    exact = fastest_marcher(fine.step, 16 * n_steps)(batch.starts, batch.points)[6, 0]
    ours = fastest_marcher(subject.step, n_steps)(batch.starts, batch.points)[6, 0]
    allowed = abs(ours / exact - 1)
    best = ("none as accurate", np.inf)
    for method in METHODS:
        for tolerance in TOLERANCES:
            began = time.perf_counter()
            end = _solve(machine, n_steps, batch.starts[:, 0], method, tolerance)
            taken = time.perf_counter() - began
            if abs(end / exact - 1) <= allowed:
                if taken < best[1]:
                    best = (f"{method}, rtol {tolerance:g}", taken)
                break
    return best


def _solve(
    machine: FloatArray, n_steps: int, start: FloatArray, method: str, rtol: float
) -> float:
    M, k, gap = machine.tolist(), *POINT

    def rate(_: float, y: FloatArray) -> list[float]:
        q1, q2, q3, w1, w2, w3, _D = y.tolist()
        a1, a2, a3, force = rundown.rates(M, k, gap, q1, q2, q3, w1, w2, w3)
        d, _P = rundown.damage(M, force, M[19], M[21], M[23], M[25], w3, q3)
        return [w1, w2, w3, a1, a2, a3, d]

    scales = [1e-3 * rtol] * 3 + [rtol] * 3 + [1e-9 * rtol]
    solution = solve_ivp(
        rate, (0, n_steps * M[32]), start[:7], method=method, rtol=rtol, atol=scales
    )
    return float(solution.y[6, -1])

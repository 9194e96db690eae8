"""Measure everything and print the table: python -m benchmarks."""

from __future__ import annotations

import os
import platform
import sys
from collections.abc import Callable
from pathlib import Path

import casadi as ca
import numpy as np

from benchmarks import hand_written
from benchmarks.integrator import fastest_of_equal_accuracy
from benchmarks.measure import Timings, time_in_turns
from benchmarks.subject import Batch, Subject
from coupling_design.rollout.compiled.march import (
    CompiledMarch,
    NotCompiled,
    compile_march,
)
from coupling_design.rollout.march import march

BATCH = 256
ROUNDS = 7
CHECKED = 2_000  # steps

Row = tuple[str, str, str]


def main() -> None:
    """Print the table as Markdown."""
    subject = Subject()
    n_steps = subject.case.shutdown.n_steps
    rows = [*one_rollout(subject, n_steps), *many_rollouts(subject, n_steps)]
    rows += [*interpreted(subject, n_steps), *integrated(subject)]
    out = sys.stdout.write
    out(f"{_processor()}, {os.cpu_count()} cores, Python {platform.python_version()}, ")
    out(f"CasADi {ca.__version__}; {n_steps} steps, medians of at least {ROUNDS} ")
    out("rounds.\n\n")
    out("| what | measured | bound |\n|---|---|---|\n")
    for row in rows:
        out("| " + " | ".join(row) + " |\n")


def one_rollout(subject: Subject, n_steps: int) -> list[Row]:
    """Return value and gradient of one rollout beside scalar C and numba."""
    batch = subject.batch(1)
    value, gradient = (
        _compiled(subject.step, n_steps),
        _compiled(subject.joint_step, n_steps),
    )
    # The same run-down in finer steps: at standstill a step would cost more.
    longer = _compiled(Subject(refinement=10).step, 10 * n_steps)
    scalar = hand_written.scalar_c(subject.machine(), n_steps)
    numba = hand_written.numba(subject.machine(), n_steps)
    _check(subject, batch, hand_written.scalar_c)
    _check(subject, batch, hand_written.numba)
    times = time_in_turns(
        {
            "scalar C": lambda: scalar(batch.starts, batch.points),
            "numba": lambda: numba(batch.starts, batch.points),
            "value": lambda: value(batch.starts, batch.points),
            "gradient": lambda: gradient(batch.joint_starts, batch.points),
        },
        5 * ROUNDS,
    )
    long_times = time_in_turns(
        {
            "value": lambda: value(batch.starts, batch.points),
            "ten times": lambda: longer(batch.starts, batch.points),
        },
        ROUNDS,
    )
    growth = long_times.best_ratio("ten times", "value")
    return [
        _row(times, "value", "scalar C", "1.25"),
        _row(times, "gradient", "scalar C", "2", "value and gradient"),
        _row(times, "numba", "value", "-"),
        ("ten times the steps", f"{growth:.2f} x the time", "10 +- 10 %"),
    ]


def many_rollouts(subject: Subject, n_steps: int) -> list[Row]:
    """Return a batch beside SIMD C, and what a second core adds."""
    if not hand_written.has_avx512():
        return [("batch against SIMD C", "the peer needs AVX-512", "1.5")]
    batch = subject.batch(BATCH)
    value, gradient = (
        _compiled(subject.step, n_steps),
        _compiled(subject.joint_step, n_steps),
    )
    simd = hand_written.simd_c(subject.machine(), n_steps)
    _check(subject, batch, hand_written.simd_c)
    times = time_in_turns(
        {
            "SIMD C": lambda: simd(batch.starts, batch.points),
            "batch": lambda: value(batch.starts, batch.points, 1),
            "batch gradient": lambda: gradient(batch.joint_starts, batch.points, 1),
        },
        ROUNDS,
    )
    speedup = two_cores(subject, batch)
    return [
        _row(times, "batch", "SIMD C", "1.5", f"batch of {BATCH}, value", BATCH),
        _row(times, "batch gradient", "SIMD C", "4", "the same with gradient", BATCH),
        ("two cores against one, batch", f"{speedup:.2f} x faster", "1.85 x faster"),
    ]


def two_cores(subject: Subject, batch: Batch) -> float:
    """Return what a second core adds, by the best of many short rounds.

    Both cores must be free at once for that: rare on a busy computer.
    """
    short = _compiled(subject.step, n_steps=6_000)
    times = time_in_turns(
        {
            "one": lambda: short(batch.starts, batch.points, 1),
            "two": lambda: short(batch.starts, batch.points, 2),
        },
        20 * ROUNDS,
    )
    return times.best_ratio("one", "two")


def interpreted(subject: Subject, n_steps: int) -> list[Row]:
    """Return CasADi's virtual machine beside the machine code."""
    batch = subject.batch(1)
    value, gradient = (
        _compiled(subject.step, n_steps),
        _compiled(subject.joint_step, n_steps),
    )
    machine, joint = march(subject.step, n_steps), march(subject.joint_step, n_steps)
    times = time_in_turns(
        {
            "value": lambda: value(batch.starts, batch.points),
            "VM value": lambda: machine(batch.starts, batch.points),
            "gradient": lambda: gradient(batch.joint_starts, batch.points),
            "VM gradient": lambda: joint(batch.joint_starts, batch.points),
        },
        ROUNDS,
    )
    return [
        _row(times, "VM value", "value", "-", "CasADi's virtual machine, value"),
        _row(times, "VM gradient", "gradient", "-", "the same, sensitivities in step"),
        *differentiated(subject, batch, n_steps // 10),
    ]


def differentiated(subject: Subject, batch: Batch, n_steps: int) -> list[Row]:
    """Return CasADi's own derivatives of a march beside sensitivities in its step.

    All on the virtual machine; fewer steps, to bear the memory.
    """
    start, point = ca.DM(batch.starts), ca.DM(batch.points)
    value, joint = march(subject.step, n_steps), march(subject.joint_step, n_steps)
    forward, reverse = value.forward(2), value.reverse(1)
    end = value(start, point)
    directions = ca.reshape(ca.DM(batch.joint_starts)[start.numel() :], -1, 2)
    times = time_in_turns(
        {
            "in step": lambda: joint(batch.joint_starts, point),
            "forward": lambda: forward(start, point, end, directions, ca.DM.eye(2)),
            "reverse": lambda: reverse(start, point, end, ca.DM.ones(end.shape)),
        },
        ROUNDS,
    )
    there = f"sensitivities in step (virtual machine, {n_steps} steps)"
    return [
        _row(
            times, "forward", "in step", "-", "CasADi forward, 2 directions", to=there
        ),
        _row(times, "reverse", "in step", "-", "CasADi reverse, 1 direction", to=there),
    ]


def integrated(subject: Subject) -> list[Row]:
    """Return solve_ivp beside one design of a batch, on one core."""
    n_steps = subject.case.shutdown.n_steps
    batch, value = subject.batch(BATCH), _compiled(subject.step, n_steps)
    march_all = {"all": lambda: value(batch.starts, batch.points, 1)}
    each = time_in_turns(march_all, 3).seconds("all") / BATCH
    method, taken = fastest_of_equal_accuracy(subject)
    return [
        (
            f"solve_ivp ({method}) against one design of a batch on one core",
            f"{taken / each:.0f} x ({taken:.2f} s)",
            "1000 x",
        )
    ]


def _compiled(step: ca.Function, n_steps: int) -> CompiledMarch:
    compiled = compile_march(step, n_steps)
    if isinstance(compiled, NotCompiled):
        sys.exit(f"Nothing to measure: {compiled.reason}")
    return compiled


def _check(
    subject: Subject, batch: Batch, make: Callable[..., hand_written.March]
) -> None:
    """Refuse a peer that computes something else, as far as rounding stays small."""
    computed = make(subject.machine(), CHECKED)(batch.starts, batch.points)
    expected = _compiled(subject.step, CHECKED)(batch.starts, batch.points)
    error = np.abs(computed / expected - 1).max()
    if not error < 1e-6:
        sys.exit(f"A peer computes something else: {make.__name__}, {error:.1e}")


def _row(
    times: Timings,
    name: str,
    peer: str,
    bound: str,
    text: str = "",
    of: int = 1,
    to: str = "",
) -> Row:
    milliseconds = f"{times.seconds(name) / of * 1e3:.2f} ms"
    measured = f"{times.ratio(name, peer):.2f} x ({milliseconds})"
    return f"{text or name} against {to or peer}", measured, bound


def _processor() -> str:
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
        names = [line for line in lines if line.startswith("model name")]
        return names[0].partition(":")[2].strip()
    except (OSError, IndexError):
        return platform.processor() or platform.machine()


if __name__ == "__main__":
    main()

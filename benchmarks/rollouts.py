"""Rollouts beside the same by hand in C and numba."""

from __future__ import annotations

import sys
from collections.abc import Callable
from dataclasses import replace

import casadi as ca
import numpy as np

from benchmarks import hand_written
from benchmarks.machine import cores
from benchmarks.measure import Timings, time_in_turns
from benchmarks.scale import Scale
from benchmarks.subject import Batch, Subject
from benchmarks.table import Row, at_least, at_most, missing
from coupling_design.lanes.march import (
    CompiledMarch,
    NotCompiled,
    compile_march,
)

CHECKED = 2_000  # steps
_SLOW = 1.0  # rad/s, where the tanh of friction is not saturated
_GROWTH = 0.1  # of ten times the time
_NO_SIMD = "the peer needs AVX-512 or AVX2 with FMA"


def one_rollout(subject: Subject, scale: Scale) -> list[Row]:
    """Return value and gradient of one rollout beside scalar C and numba."""
    n_steps = subject.case.shutdown.n_steps
    batch = subject.batch(1)
    value, gradient = both_marches(subject, n_steps)
    scalar = hand_written.scalar_c(subject.machine(), n_steps)
    _check(subject, batch, hand_written.scalar_c)
    things = {
        "scalar C": lambda: scalar(batch.starts, batch.points),
        "value": lambda: value(batch.starts, batch.points),
        "gradient": lambda: gradient(batch.joint_starts, batch.points),
    }
    if hand_written.has_numba():
        numba = hand_written.numba(subject.machine(), n_steps)
        _check(subject, batch, hand_written.numba)
        things["numba"] = lambda: numba(batch.starts, batch.points)
    times = time_in_turns(things, 5 * scale.rounds)
    what = "value and gradient against scalar C"
    rows = [
        bounded("value", "value against scalar C", times, "scalar C", 1.25),
        bounded("gradient", what, times, "scalar C", 2),
    ]
    if "numba" not in things:
        return [*rows, missing("numba", "numba against value", "numba is not there")]
    return [*rows, compared("numba", "numba against value", times, "value")]


def ten_times(subject: Subject, scale: Scale) -> Row:
    """Return the time of ten times the steps against one.

    The same run-down in finer steps: at standstill a step would cost more.
    """
    n_steps, batch = subject.case.shutdown.n_steps, subject.batch(1)
    value = compiled(subject.step, n_steps)
    longer = compiled(subject.refined(10).step, 10 * n_steps)
    times = time_in_turns(
        {
            "value": lambda: value(batch.starts, batch.points),
            "ten times": lambda: longer(batch.starts, batch.points),
        },
        2 * scale.rounds,
    )
    growth = times.best_ratio("ten times", "value")
    shown, bound = f"{growth:.2f} x", "10 within 10 %"
    met = abs(growth / 10 - 1) <= _GROWTH
    return Row("steps", "ten times the steps, time", shown, bound, met)


def many_rollouts(subject: Subject, scale: Scale) -> list[Row]:
    """Return a batch beside SIMD C, per design and core, and what two cores add."""
    n_steps, batch = subject.case.shutdown.n_steps, subject.batch(scale.batch)
    value, gradient = both_marches(subject, n_steps)
    things = {
        "batch": lambda: value(batch.starts, batch.points, 1),
        "batch_gradient": lambda: gradient(batch.joint_starts, batch.points, 1),
    }
    if hand_written.has_simd():
        simd = hand_written.simd_c(subject.machine(), n_steps)
        _check(subject, batch, hand_written.simd_c)
        things["SIMD C"] = lambda: simd(batch.starts, batch.points)
    times = time_in_turns(things, scale.rounds)
    names = {
        "batch": (f"batch of {scale.batch}, value against SIMD C", 1.5),
        "batch_gradient": ("the same with gradient against SIMD C", 4.0),
    }
    if "SIMD C" in things:
        rows = [
            bounded(key, what, times, "SIMD C", bound, scale.batch)
            for key, (what, bound) in names.items()
        ]
    else:
        rows = [missing(key, what, _NO_SIMD) for key, (what, _) in names.items()]
    rows[0] = replace(rows[0], numbers=_peer_numbers(times, scale))
    return [*rows, *_two_cores(subject, scale)]


def _peer_numbers(times: Timings, scale: Scale) -> dict[str, str]:
    """Return what the page says of one design by SIMD C, ours where there is none."""
    name = "SIMD C" if "SIMD C" in times.rounds else "batch"
    each = times.seconds(name) / scale.batch
    return {"simd_milliseconds": f"{each * 1e3:.2f}"}


def _two_cores(subject: Subject, scale: Scale) -> list[Row]:
    """Return what a second core adds, by the best of many short rounds.

    Both cores must be free at once for that: rare on a busy computer. What SIMD C gains
    in the same rounds is all that this machine gives.
    """
    what, also = "two cores against one, batch", "the same of SIMD C, two threads"
    if cores() < 2:
        reason = "there is one core"
        return [missing("two_cores", what, reason), missing("ceiling", also, reason)]
    n_steps = min(6_000, subject.case.shutdown.n_steps)
    batch, short = subject.batch(max(scale.batch, 64)), compiled(subject.step, n_steps)
    things: dict[str, Callable[[], object]] = {
        "one": lambda: short(batch.starts, batch.points, 1),
        "two": lambda: short(batch.starts, batch.points, 2),
    }
    if hand_written.has_simd():
        simd = hand_written.by_threads(hand_written.simd_c(subject.machine(), n_steps))
        things["SIMD one"] = lambda: simd(batch.starts, batch.points, 1)
        things["SIMD two"] = lambda: simd(batch.starts, batch.points, 2)
    times = time_in_turns(things, 20 * scale.rounds)
    speedup = times.best_ratio("one", "two")
    shown = f"{speedup:.2f} x faster"
    row = at_least("two_cores", what, shown, speedup, 1.85)
    if "SIMD one" not in things:
        return [row, missing("ceiling", also, _NO_SIMD)]
    ceiling = times.best_ratio("SIMD one", "SIMD two")
    return [row, Row("ceiling", also, f"{ceiling:.2f} x faster")]


def both_marches(subject: Subject, n_steps: int) -> tuple[CompiledMarch, CompiledMarch]:
    """Return the marches of values, and of values with sensitivities."""
    return compiled(subject.step, n_steps), compiled(subject.joint_step, n_steps)


def compiled(step: ca.Function, n_steps: int) -> CompiledMarch:
    """Return a march as machine code, or leave: without it all here says nothing."""
    found = compile_march(step, n_steps)
    if isinstance(found, NotCompiled):
        sys.exit(f"Nothing to measure: {found.reason}")
    return found


def _check(
    subject: Subject, batch: Batch, make: Callable[..., hand_written.March]
) -> None:
    """Refuse a peer that computes something else, as far as rounding stays small.

    From the shutdown's own speed, and from where it is nearly at a standstill.
    """
    peer, march = make(subject.machine(), CHECKED), compiled(subject.step, CHECKED)
    slow = subject.at(batch.points.T, _SLOW)
    for where, starts in (("fast", batch.starts), ("slow", slow.starts)):
        expected = march(starts, batch.points)
        error = np.abs(peer(starts, batch.points) / expected - 1).max()
        if not error < 1e-6:
            what = f"{make.__name__}, {where}, {error:.1e}"
            sys.exit(f"A peer computes something else: {what}")


def _shown(times: Timings, key: str, peer: str, of: int) -> str:
    milliseconds = times.seconds(key) / of * 1e3
    return f"{times.ratio(key, peer):.2f} x ({milliseconds:.2f} ms)"


def bounded(
    key: str, what: str, times: Timings, peer: str, bound: float, of: int = 1
) -> Row:
    """Return the row of a ratio with a bound; `of` designs were timed at once."""
    ratio = times.ratio(key, peer)
    return at_most(key, what, _shown(times, key, peer, of), ratio, bound)


def compared(key: str, what: str, times: Timings, peer: str) -> Row:
    """Return the row of a ratio without a bound."""
    return Row(key, what, _shown(times, key, peer, of=1))

"""The same run-downs by scipy, each result as accurate as our own step's.

A rollout gives two damages and three peaks, so its peer has to. Of a handful of points
over the plane each total's largest error, against a step 16 times finer, may not be
larger than ours; a peer's time is the mean over these points at the loosest tolerance
that keeps to this.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np
from scipy.integrate import odeint, solve_ivp

from benchmarks import hand_written
from benchmarks.measure import Timings, time_in_turns
from benchmarks.peers import twists
from benchmarks.rollouts import compiled
from benchmarks.scale import Scale
from benchmarks.subject import Subject
from benchmarks.table import Row, at_least, missing
from benchmarks.task import Task
from coupling_design.arithmetic import FloatArray
from coupling_design.wear.quantities import TOTALS

# LSODA first: a method that takes longer than the best is given up midway. Radau and
# BDF are not among them: some 18 s a run-down.
METHODS = ("LSODA", "DOP853", "RK45")
TOLERANCES = (1e-6, 3e-7, 1e-7, 3e-8, 1e-8, 1e-9)

_ROUNDS = 2
_NUMBA = "the same, right-hand side in numba"

Rate = Callable[[float, FloatArray], object]
Solve = Callable[[int, float], FloatArray]  # (point, rtol) -> states of each step


@dataclass(frozen=True)
class Peer:
    """A way to solve a task, accurate enough with `tolerance`.

    Attributes
    ----------
    name, solve, tolerance : method, function, relative tolerance
    decides : the total that is nearest to its allowed error
    """

    name: str
    solve: Solve
    tolerance: float
    decides: str

    def run(self, task: Task) -> None:
        """Do all points."""
        for i in range(len(task.points)):
            task.totals(i, self.solve(i, self.tolerance))


def solve_ivp_rows(subject: Subject, scale: Scale) -> list[Row]:
    """Return solve_ivp and its like beside one design of a batch."""
    task = Task(subject)
    quickest = _quickest(task)
    method, first = quickest.name.partition(",")[0], quickest.tolerance
    others: dict[str, tuple[str, Solve]] = {
        "samples": ("the same, t_eval at each step", partial(_at_samples, task, method))
    }
    if hand_written.has_numba():
        rates = [_numba_rate(task, i) for i in range(len(task.points))]
        others["solve_ivp_numba"] = (
            _NUMBA,
            partial(_between_steps, task, method, rates),
        )
    others["odeint"] = "odeint (LSODA in one call)", partial(_by_odeint, task)
    peers = {"solve_ivp": quickest}
    for key, (name, solve) in others.items():
        own = key == "odeint"  # of its own kind: it starts with the loosest
        peers[key] = _accurate(task, name, solve, TOLERANCES[0] if own else first)
    times = _in_turns(subject, scale, task, peers)
    rows = [_row(key, peer, times, task, scale) for key, peer in peers.items()]
    if "solve_ivp_numba" not in peers:
        without = missing("solve_ivp_numba", _NUMBA, "numba is not there")
        rows.insert(-1, without)  # where it would be, before odeint
    return rows


def _quickest(task: Task) -> Peer:
    """Return the quickest method of solve_ivp, its steps read between by numpy."""
    rates = [_rate(task, i) for i in range(len(task.points))]
    best, least = None, np.inf
    for method in METHODS:
        solve = partial(_between_steps, task, method, rates)
        peer, taken = _accurate_within(task, method, solve, least)
        if taken < least:
            best, least = peer, taken
    return best or peer


def _accurate(task: Task, name: str, solve: Solve, first: float) -> Peer:
    """Return the peer of a method whose looser tolerances than `first` failed."""
    return _accurate_within(task, name, solve, np.inf, first)[0]


def _accurate_within(
    task: Task, name: str, solve: Solve, seconds: float, first: float = TOLERANCES[0]
) -> tuple[Peer, float]:
    """Return the peer with the loosest tolerance that will do, and its time.

    The time is infinite if no tolerance will do within the time given.
    """
    for tolerance in TOLERANCES[TOLERANCES.index(first) :]:
        excess, taken = _tried(task, solve, tolerance, seconds)
        if excess.max() <= 1 or taken >= seconds:
            break
    decides = TOTALS[int(excess.argmax())].replace("_", " ")
    if excess.max() > 1:
        name, taken = f"{name}, less accurate", np.inf
    return Peer(name, solve, tolerance, decides), taken


def _tried(
    task: Task, solve: Solve, tolerance: float, seconds: float
) -> tuple[FloatArray, float]:
    """Return the largest excesses and the time, given up where more says no more."""
    excess, taken = np.zeros(len(TOTALS)), 0.0
    for i in range(len(task.points)):
        began = time.perf_counter()
        totals = task.totals(i, solve(i, tolerance))
        taken += time.perf_counter() - began
        excess = np.fmax(excess, task.excess(i, totals))
        if excess.max() > 1 or taken >= seconds:
            break
    return excess, taken


def _rate(task: Task, i: int) -> Rate:
    rates = twists.rates_of(task.machine, *task.points[i])
    return lambda _, y: rates(*y.tolist())


def _jacobian(task: Task, i: int) -> Rate:
    jacobian = twists.jacobian_of(task.machine, *task.points[i])
    return lambda _, y: jacobian(*y.tolist())


def _numba_rate(task: Task, i: int) -> Rate:
    """Return the rates in numba, compiled; scipy still calls them from Python."""
    from numba import njit

    compile_ = njit(fastmath=True)
    rates = compile_(twists.rates_of(task.machine, *task.points[i]))

    def rate(_: float, y: FloatArray) -> FloatArray:
        return np.array(rates(y[0], y[1], y[2], y[3], y[4], y[5]))

    compiled_rate: Rate = compile_(rate)
    compiled_rate(0.0, task.starts[i])
    return compiled_rate


def _between_steps(
    task: Task, method: str, rates: list[Rate], i: int, rtol: float
) -> FloatArray:
    """Solve, and read the states at each time step off the solver's own."""
    found = _solved(task, method, rates[i], i, rtol, None)
    k, gap = task.points[i]
    vectorised = twists.rates_of(task.machine, k, gap, np)
    return twists.between_steps(vectorised, found.t, found.y, task.times)


def _at_samples(task: Task, method: str, i: int, rtol: float) -> FloatArray:
    """Leave it to solve_ivp to give the states at each time step."""
    rate = _rate(task, i)
    return np.asarray(_solved(task, method, rate, i, rtol, task.times).y)


def _solved(
    task: Task, method: str, rate: Rate, i: int, rtol: float, t_eval: FloatArray | None
) -> Any:
    options: dict[str, object] = {"rtol": rtol, "atol": _absolute(rtol)}
    if method == "LSODA":  # an eighth less time than by differences
        options["jac"] = _jacobian(task, i)
    span = (0, task.times[-1])
    return solve_ivp(rate, span, task.starts[i], method, t_eval, **options)


def _by_odeint(task: Task, i: int, rtol: float) -> FloatArray:
    found = odeint(
        *(_rate(task, i), task.starts[i], task.times),
        Dfun=_jacobian(task, i),
        tfirst=True,
        rtol=rtol,
        atol=_absolute(rtol),
    )
    return np.asarray(found).T


def _absolute(rtol: float) -> list[float]:
    """Return the tolerances of small values: of others, more steps or less accuracy."""
    return [1e-3 * rtol] * 3 + [rtol] * 3


def _in_turns(
    subject: Subject, scale: Scale, task: Task, peers: dict[str, Peer]
) -> Timings:
    batch = subject.batch(scale.batch)
    march = compiled(subject.step, subject.case.shutdown.n_steps)
    things: dict[str, Callable[[], object]] = {
        "batch": lambda: march(batch.starts, batch.points),
        "one core": lambda: march(batch.starts, batch.points, 1),
    }
    for key, peer in peers.items():
        things[key] = partial(peer.run, task)
    return time_in_turns(things, min(scale.rounds, _ROUNDS), warm_up=False)


def _row(key: str, peer: Peer, times: Timings, task: Task, scale: Scale) -> Row:
    """Return a peer's row; best times, since a batch needs all the cores."""
    designs = scale.batch / len(task.points)
    ratio, per_core = (
        times.best_ratio(key, ours) * designs for ours in ("batch", "one core")
    )
    seconds = min(times.rounds[key]) / len(task.points)
    shown = f"{ratio:.0f} x, per core {per_core:.0f} x ({seconds:.2f} s)"
    name = f"{peer.name}, rtol {peer.tolerance:g}"
    if key != "solve_ivp":
        return Row(key, name, shown)
    what = f"solve_ivp ({name}) against one design of a batch on all cores"
    each = min(times.rounds["batch"]) / scale.batch
    numbers = {
        "solve_ivp_decides": peer.decides,
        "solve_ivp_needed": f"{seconds:.2f}",
        "solve_ivp_each": f"{each * 1e3:.2f}",
        "solve_ivp_allowed": f"{seconds:.2f}",
    }
    return replace(at_least(key, what, shown, ratio, 1000), numbers=numbers)

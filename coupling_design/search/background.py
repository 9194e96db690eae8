"""Rollouts that no decision waits for, on the cores that the flow leaves idle.

Only marches as machine code go there: they let go of Python's lock, and share nothing
with what the flow meanwhile builds and counts.
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from concurrent.futures import Future, ThreadPoolExecutor

from coupling_design.arithmetic import FloatArray
from coupling_design.wear.evaluator import Evaluator
from coupling_design.wear.performance import Performance


class Deferred:
    """Performances at many points, rolled out at the latest when they are asked for."""

    def __init__(
        self,
        evaluator: Evaluator,
        points: Sequence[tuple[float, float]],
        pool: ThreadPoolExecutor | None = None,
        threads: int | None = None,
    ) -> None:
        self.points = points
        self._evaluator = evaluator
        self._threads = threads
        self._march = evaluator.prepare(points)
        self._ends: Future[FloatArray] | None = None
        if pool is not None:
            self._ends = pool.submit(self._march, threads)

    def performances(self) -> tuple[Performance, ...]:
        """Return the performances in the points' order, waiting for them if need be.

        Raises SimulationError where a rollout leaves finite numbers.
        """
        if self._ends is None or self._ends.cancel():
            # Not begun, or not to be: rolled out here, so that no core waits.
            ends = self._march(self._threads)
        else:
            ends = self._ends.result()
        return self._evaluator.performances_of(self.points, ends)


class Background:
    """A thread that rolls out one batch after another, until it is closed."""

    def __init__(self) -> None:
        self._pool: ThreadPoolExecutor | None = None

    def defer(
        self, evaluator: Evaluator, points: Sequence[tuple[float, float]]
    ) -> Deferred:
        """Return the performances at many points, to be asked for later."""
        if not evaluator.is_compiled:
            return Deferred(evaluator, points)
        if self._pool is None:
            self._pool = ThreadPoolExecutor(1, "background")
        # One core is the flow's own.
        threads = max(1, (os.cpu_count() or 1) - 1)
        return Deferred(evaluator, points, self._pool, threads)

    def close(self) -> None:
        """Give up what has not begun; what has goes on to its end, nobody waits."""
        if self._pool is not None:
            self._pool.shutdown(wait=False, cancel_futures=True)
            self._pool = None

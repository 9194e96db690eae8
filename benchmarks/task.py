"""What a peer from scipy has to do, and how accurately."""

from __future__ import annotations

import numpy as np

from benchmarks.peers import twists
from benchmarks.rollouts import compiled
from benchmarks.subject import Subject
from coupling_design.arithmetic import FloatArray

# Half the present stiffness, and a worn key: it rattles.
POINT = (2.5e5, 2.8e-4)
_MORE_POINTS = 4


class Task:
    """What a peer has to do: the points, and how accurate each total must be."""

    def __init__(self, subject: Subject) -> None:
        self.machine: list[float] = subject.machine().tolist()
        n_steps = subject.case.shutdown.n_steps
        batch = subject.at([POINT, *subject.batch(_MORE_POINTS).points.T])
        self.points = batch.points.T.tolist()
        self.starts = [twists.twists(start) for start in batch.starts.T]
        self.times = np.linspace(0, n_steps * subject.time_step, n_steps + 1)
        fine = compiled(subject.refined(16).step, 16 * n_steps)
        self._exact = fine(batch.starts, batch.points)[6:].T
        ours = compiled(subject.step, n_steps)(batch.starts, batch.points)[6:].T
        self._allowed = np.abs(ours / self._exact - 1).max(axis=0)

    def totals(self, i: int, states: FloatArray) -> FloatArray:
        """Return what the states at each time step add up to."""
        return twists.totals(self.machine, self.points[i][1], states)

    def excess(self, i: int, totals: FloatArray) -> FloatArray:
        """Return each total's error by the one allowed."""
        return np.asarray(np.abs(totals / self._exact[i] - 1) / self._allowed)

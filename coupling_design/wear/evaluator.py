"""What one design point does, and how that changes with stiffness and gap.

A point is (torsional stiffness [N m/rad], key gap [m]). Where the crank stands when
the fuel goes off, and where gravity then is, are chance: a point's damage is the mean
over evenly spread ones, its peaks are the largest.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cached_property, partial

import numpy as np

from coupling_design.arithmetic import FloatArray
from coupling_design.line.parameters import Start
from coupling_design.machine.candidate import Candidate
from coupling_design.machine.machine import Case
from coupling_design.signals.history import History
from coupling_design.wear.chance import chances
from coupling_design.wear.performance import Performance, performance_of
from coupling_design.wear.point_reader import PointReader
from coupling_design.wear.quantities import TOTALS
from coupling_design.wear.run_downs import RunDowns, joint_states
from coupling_design.wear.totals import over_chance, spread_of

_REMEMBERED = 64  # gradients: a solver asks at most a few times in a row
_HISTORIES = 2

Point = tuple[float, float]


class Evaluator(PointReader):
    """Rollouts of one candidate of a case, with exact gradients.

    `refinement` divides the time step, `coarsening` multiplies it: the latter must
    divide the number of steps. The `scan` of another takes its first crank angle alone,
    gap closed at the start: good enough to look around, not to judge.
    """

    def __init__(
        self,
        case: Case,
        candidate: Candidate,
        refinement: int = 1,
        coarsening: int = 1,
        *,
        scan_of: Evaluator | None = None,
    ) -> None:
        super().__init__(case, candidate)
        self.refinement, self.coarsening = refinement, coarsening
        self.is_scan, self._judging = scan_of is not None, scan_of or self
        self.rollouts = 0
        shutdown = case.shutdown
        self.run_downs: RunDowns = (
            scan_of.run_downs
            if scan_of
            else RunDowns(
                case,
                candidate,
                shutdown.time_step * coarsening / refinement,
                shutdown.n_steps * refinement // coarsening,
            )
        )
        self.chances = chances(case, 1 if self.is_scan else shutdown.crank_angles)
        self._coarser: dict[int, Evaluator] = {}
        self._performances: dict[float, dict[Point, Performance]] = {}
        self._histories: dict[Point, History] = {}
        self._unsettled: set[Point] = set()
        self._known: dict[Point, tuple[FloatArray, FloatArray]] = {}

    def performance(
        self, torsional_stiffness: float, key_gap: float, start_offset: float = 0.0
    ) -> Performance:
        """Return what a run-down does at a point.

        `start_offset` [rad] turns the crank before the start. Raises SimulationError
        where a rollout leaves finite numbers.
        """
        return self.performances([(torsional_stiffness, key_gap)], start_offset)[0]

    def performances(
        self, points: Sequence[Point], start_offset: float = 0.0
    ) -> tuple[Performance, ...]:
        """Return the performances at many points, in their order.

        Each is rolled out once and kept: again it would be the same to the last bit.
        """
        known = self._performances.setdefault(start_offset, {})
        new = [point for point in dict.fromkeys(points) if point not in known]
        if new:
            ends = self.prepare(new, start_offset)(None)
            known.update(zip(new, self.performances_of(new, ends), strict=True))
        return tuple(known[point] for point in points)

    def prepare(
        self, points: Sequence[Point], start_offset: float = 0.0
    ) -> Callable[[int | None], FloatArray]:
        """Return what rolls out many points with so many threads, to their ends.

        All else is done and counted here: what is returned is the march alone, which
        touches nothing that another thread may be building.
        """
        columns = self.run_downs.variables.columns(points, self.chances)
        starts = self._starts(columns)
        starts[0] += start_offset
        self.rollouts += columns.shape[1]
        return partial(self.run_downs.march, joint_states(starts), columns)

    def performances_of(
        self, points: Sequence[Point], ends: FloatArray
    ) -> tuple[Performance, ...]:
        """Return the performances at points whose rollouts ended so."""
        frequencies = self.natural_frequency(np.array([k for k, _ in points])).tolist()
        n, found = self.chances.shape[1], []
        for i, (point, f) in enumerate(zip(points, frequencies, strict=True)):
            totals = ends[-len(TOTALS) :, i * n : (i + 1) * n]
            self._check(totals, point)
            repeats = point not in self._unsettled
            speeds = ends[self.run_downs.speeds, i * n : (i + 1) * n]
            spread = (
                None if self.is_scan else spread_of(totals, speeds, repeats=repeats)
            )
            judged = over_chance(totals).tolist()
            found.append(performance_of(*point, f, judged, spread))
        return tuple(found)

    def performances_from(
        self, columns: FloatArray, start: Start | None = None
    ) -> tuple[Performance, ...]:
        """Return the performances of variables' columns, in groups of crank angles.

        As `variables.columns` makes them, with what one likes changed; from another
        start if given. What starts faster than the case runs longer in proportion, so
        that its stop is not cut off. They are not kept.
        """
        starts = self.run_downs.starting(start)(columns, self.chances.shape[1])
        self.rollouts += columns.shape[1]
        ends = self.run_downs.to_rest(joint_states(starts.states), columns)
        points = [(k, gap) for k, gap in columns[:2, :: self.chances.shape[1]].T]
        return self.performances_of(points, ends)

    def history(self, torsional_stiffness: float, key_gap: float) -> History:
        """Return the run-down at a point in full, from the crank angle of its peak.

        The last two asked for are kept. Raises SimulationError where it leaves finite
        numbers.
        """
        point = (torsional_stiffness, key_gap)
        if point not in self._histories:
            if len(self._histories) >= _HISTORIES:
                self._histories.clear()
            spread = self.performance(*point).spread
            worst = spread.worst if spread else 0
            columns = self.run_downs.variables.columns([point], self.chances)
            starts, mine = self._starts(columns), slice(worst, worst + 1)
            self._histories[point] = self.run_downs.history(
                starts[:, mine], columns[:, mine]
            )
        return self._histories[point]

    def totals_and_jacobian(
        self, torsional_stiffness: float, key_gap: float
    ) -> tuple[FloatArray, FloatArray]:
        """Return TOTALS (5,) and their exact derivatives (5, 2) to the two variables.

        The last ones are kept: a solver's separate questions cost one rollout.
        """
        point = (torsional_stiffness, key_gap)
        if point not in self._known:
            if len(self._known) >= _REMEMBERED:
                self._known.clear()
            self.rollouts += self.chances.shape[1]
            totals, *slopes = self.run_downs.totals_with_slopes(point, self.chances)
            self._check(np.stack([totals, *slopes]), point)
            judged = over_chance(totals, *slopes)
            self._known[point] = judged[:, 0], judged[:, 1:]
        return self._known[point]

    @cached_property
    def refined(self) -> Evaluator:
        """The same rollouts with half the time step."""
        return Evaluator(self.case, self.candidate, 2 * self.refinement)

    @cached_property
    def scan(self) -> Evaluator:
        """The same run-downs from one crank angle, to look around with."""
        return Evaluator(
            self.case,
            self.candidate,
            self.refinement,
            self.coarsening,
            scan_of=self,
        )

    def coarser(self, coarsening: int) -> Evaluator:
        """Return the same rollouts with a time step this many times longer."""
        if self.is_scan:
            return self._judging.coarser(coarsening).scan
        if coarsening not in self._coarser:
            self._coarser[coarsening] = Evaluator(
                self.case, self.candidate, coarsening=coarsening
            )
        return self._coarser[coarsening]

    @property
    def all_rollouts(self) -> int:
        """How many rollouts it and its scan have made, at its own step."""
        return self.rollouts + self.scan.rollouts

    @property
    def coarse_rollouts(self) -> int:
        """How many rollouts the coarser ones have made."""
        return sum(evaluator.all_rollouts for evaluator in self._coarser.values())

    @property
    def is_compiled(self) -> bool:
        """Whether the rollouts run as machine code."""
        return self.run_downs.march.is_compiled

    @property
    def engine(self) -> str:
        """What does the rollouts, in words."""
        return self.run_downs.march.engine

    @property
    def time_step(self) -> float:
        """The time step [s]."""
        return self.run_downs.time_step

    def _starts(self, columns: FloatArray) -> FloatArray:
        starting = self.run_downs.starting()
        if self.is_scan:
            return starting.closed(columns)
        n = self.chances.shape[1]
        starts = starting(columns, n)
        firsts = zip(columns[:2, ::n].T.tolist(), starts.repeats, strict=True)
        self._unsettled.update((k, gap) for (k, gap), repeats in firsts if not repeats)
        return starts.states

    def _check(self, totals: FloatArray, point: Point) -> None:
        """Raise SimulationError, saying when, if totals (..., n) are not finite."""
        if not np.isfinite(totals).all():
            columns = self.run_downs.variables.columns([point], self.chances)
            raise self.run_downs.divergence(self._starts(columns), columns, totals)

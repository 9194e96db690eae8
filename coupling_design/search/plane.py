"""The whole stiffness x gap plane of a candidate, rolled out before any optimiser.

All of it from one crank angle: a map to look around with. The rows at the smallest and
the largest gap, from which a step goes on, have the case's own time step. Those between
may have a longer one, whose error is measured; no decision rests on them, so they are
rolled out in the background until somebody asks for them.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from coupling_design.checks.time_step import stable_step
from coupling_design.errors import SimulationError
from coupling_design.search.background import Deferred
from coupling_design.search.design_map import CoarseStep, DesignMap
from coupling_design.search.program import DesignProblem
from coupling_design.search.reach import reachable_stiffness
from coupling_design.search.scan import grid
from coupling_design.search.workbench import Workbench
from coupling_design.wear.evaluator import Evaluator
from coupling_design.wear.performance import Performance

# Steps this many times longer are tried, the longest first; and how far damage and
# peak may be off, relative: no more than one in the third digit, the last a map shows.
_COARSENINGS = (5, 3, 2)
_GOOD_ENOUGH = 1e-3
# Of each checked row, every fourth stiffness is rolled out both ways.
_CHECKED_EVERY = 4

Row = tuple[Performance, ...]


@dataclass(frozen=True)
class Survey:
    """Performances over stiffness, row by row from the smallest gap to the largest.

    `outer` are the first and the last row, or the only one. `coarse` says which step
    the rows between have, None where it is the case's own. Only `rows` and the map
    wait for the rows between.
    """

    evaluator: Evaluator
    outer: tuple[Row, ...]
    between: tuple[Deferred, ...] = ()
    coarse: CoarseStep | None = None

    @property
    def name(self) -> str:
        """The candidate's label."""
        return self.evaluator.candidate.label

    @property
    def smallest_gap(self) -> Row:
        """The scan over stiffness at the smallest gap."""
        return self.outer[0]

    @property
    def largest_gap(self) -> Row:
        """The scan over stiffness at the largest gap."""
        return self.outer[-1]

    @property
    def n_gaps(self) -> int:
        """How many rows there are."""
        return len(self.outer) + len(self.between)

    @property
    def longest_step(self) -> int:
        """How many times longer a time step is known to do."""
        return self.coarse.times if self.coarse else 1

    @cached_property
    def rows(self) -> tuple[Row, ...]:
        """All rows.

        Raises SimulationError where a row leaves finite numbers at the case's own step.
        """
        # From the last to the first, to meet the background, which goes the other way.
        between = [self._row(deferred) for deferred in reversed(self.between)]
        return (*self.outer[:1], *reversed(between), *self.outer[1:])

    def design_map(self) -> DesignMap:
        """Return damage and peak over the plane, as plain numbers."""
        return DesignMap(
            name=self.name,
            torsional_stiffness=tuple(p.torsional_stiffness for p in self.rows[0]),
            key_gap=tuple(row[0].key_gap for row in self.rows),
            damage=tuple(tuple(p.damage for p in row) for row in self.rows),
            peak_transmission_force=tuple(
                tuple(float(p.peak_transmission_force) for p in row)
                for row in self.rows
            ),
            coarse=self.coarse,
        )

    def _row(self, deferred: Deferred) -> Row:
        """Return a row between; at the case's own step where a longer one diverges."""
        try:
            return deferred.performances()
        except SimulationError:
            if self.coarse is None:
                raise
        return self.evaluator.performances(deferred.points)


def survey(bench: Workbench, program: DesignProblem) -> Survey:
    """Return the survey of a program's plane, as far as natural frequency allows.

    Its rows between the first and the last are still being rolled out.
    """
    evaluator, space = program.evaluator.scan, program.space
    left = reachable_stiffness(evaluator, program.constraints, space.stiffness)
    narrowed = replace(space, stiffness=left or space.stiffness)
    effort = bench.effort
    points = grid(narrowed, effort.stiffnesses, effort.survey_gaps)
    bench.progress(
        f"mapping {evaluator.candidate.label}, {len(points)} stiffnesses and gaps"
    )
    n = effort.stiffnesses if narrowed.stiffness[1] > narrowed.stiffness[0] else 1
    rows = [points[i : i + n] for i in range(0, len(points), n)]
    return _rolled_out(bench, evaluator, rows)


def _rolled_out(
    bench: Workbench,
    evaluator: Evaluator,
    rows: list[tuple[tuple[float, float], ...]],
) -> Survey:
    """Return the survey of a grid, its outer rows at the case's own step."""
    n, between = len(rows[0]), rows[1:-1]
    outer = [*rows[0], *rows[-1]] if len(rows) > 1 else [*rows[0]]
    sample = rows[len(rows) // 2][::_CHECKED_EVERY] if between else ()
    exact = evaluator.performances([*outer, *sample])
    scans = tuple(exact[i : i + n] for i in range(0, len(outer), n))
    if not between:
        return Survey(evaluator, scans)
    checked = [*exact[: len(outer) : _CHECKED_EVERY], *exact[len(outer) :]]
    coarse = _longest_good_step(evaluator, checked)
    chosen = evaluator.coarser(coarse.times) if coarse else evaluator
    deferred = tuple(bench.background.defer(chosen, row) for row in between)
    return Survey(evaluator, scans, deferred, coarse)


def _longest_good_step(
    evaluator: Evaluator, exact: Sequence[Performance]
) -> CoarseStep | None:
    """Return the longest step that does for a map, None if only the case's own does."""
    case, candidate = evaluator.case, evaluator.candidate
    largest = stable_step(case, candidate)
    for times in _COARSENINGS:
        is_whole = case.shutdown.n_steps % times == 0
        if not is_whole or times * case.shutdown.time_step > largest:
            continue
        tried = _tried(evaluator.coarser(times), exact)
        if tried and max(tried.damage_error, tried.peak_error) <= _GOOD_ENOUGH:
            return tried
    return None


def _tried(coarser: Evaluator, exact: Sequence[Performance]) -> CoarseStep | None:
    """Return how far a longer step is off, None if a run-down diverges."""
    points = [(p.torsional_stiffness, p.key_gap) for p in exact]
    try:
        found = coarser.performances(points)
    except SimulationError:
        return None
    pairs = list(zip(found, exact, strict=True))
    return CoarseStep(
        times=coarser.coarsening,
        time_step=coarser.time_step,
        checked=len(exact),
        damage_error=max(abs(a.damage / b.damage - 1) for a, b in pairs),
        peak_error=max(
            abs(a.peak_transmission_force / b.peak_transmission_force - 1)
            for a, b in pairs
        ),
    )

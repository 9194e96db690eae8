"""Scan, then Ipopt: how every stage looks for a point of one candidate.

The scan looks around from one crank angle; Ipopt, and whatever is compared with its
end, judges over all of them.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace

from coupling_design.machine.candidate import Candidate
from coupling_design.machine.machine import Case
from coupling_design.machine.words import ConnectionKind
from coupling_design.search.background import Background
from coupling_design.search.ipopt import optimise
from coupling_design.search.optimum import Optimum
from coupling_design.search.program import (
    Constraint,
    DesignProblem,
    DesignSpace,
    Objective,
)
from coupling_design.search.reach import reachable_stiffness
from coupling_design.search.scan import grid, local_minima
from coupling_design.wear.evaluator import Evaluator
from coupling_design.wear.performance import Performance

Progress = Callable[[str], None]


@dataclass(frozen=True)
class Effort:
    """How closely a search looks: scan points, and starts for Ipopt.

    `stiffnesses` is the number of points along stiffness when the gap is fixed, by
    `survey_gaps` in a survey of the plane; `stiffnesses_with_gap` x `gaps` is the
    scan before an optimisation over both.
    """

    stiffnesses: int
    survey_gaps: int
    stiffnesses_with_gap: int
    gaps: int
    starts: int


# What a minute affords without machine code, and what a few seconds afford with it.
COARSE = Effort(32, 2, 11, 4, 3)
CLOSE = Effort(48, 16, 16, 8, 3)


@dataclass
class Workbench:
    """The evaluators of a case, each built once, and what the search may cost.

    `background` takes the rollouts that can wait; `close` gives up those left.
    """

    case: Case
    progress: Progress
    effort: Effort = COARSE
    background: Background = field(default_factory=Background)
    _evaluators: dict[Candidate, Evaluator] = field(default_factory=dict)

    def evaluator(self, candidate: Candidate) -> Evaluator:
        """Return the evaluator of a candidate."""
        if candidate not in self._evaluators:
            self._evaluators[candidate] = Evaluator(self.case, candidate)
        return self._evaluators[candidate]

    def close(self) -> None:
        """Give up the rollouts in the background that have not begun."""
        self.background.close()

    @property
    def rollouts(self) -> int:
        """How many run-downs have been rolled out, at the case's own step."""
        return sum(evaluator.all_rollouts for evaluator in self._evaluators.values())

    @property
    def coarse_rollouts(self) -> int:
        """How many more were at a longer step, for maps only."""
        return sum(evaluator.coarse_rollouts for evaluator in self._evaluators.values())

    @property
    def is_compiled(self) -> bool:
        """Whether the rollouts run as machine code."""
        return all(e.is_compiled for e in self._evaluators.values() if e.all_rollouts)

    @property
    def engine(self) -> str:
        """What did them, in words."""
        used = {e.engine for e in self._evaluators.values() if e.all_rollouts}
        return ", ".join(sorted(used))


def problem(
    bench: Workbench,
    candidate: Candidate,
    space: DesignSpace,
    objective: Objective,
    constraints: tuple[Constraint, ...],
) -> DesignProblem:
    """Return the program of one candidate."""
    return DesignProblem(bench.evaluator(candidate), space, objective, constraints)


def search(
    bench: Workbench,
    program: DesignProblem,
    scanned: tuple[Performance, ...] | None = None,
    starts: int | None = None,
) -> Optimum:
    """Return the best verified point of a program; `scanned` saves its scan."""
    if scanned is None:
        scanned = look(bench, program)
    return optimise(program, scanned, starts or bench.effort.starts)


def look(bench: Workbench, program: DesignProblem) -> tuple[Performance, ...]:
    """Return the scan of what the natural frequency leaves of a design space."""
    bench.progress(f"scanning {program.evaluator.candidate.label}")
    left = reachable_stiffness(
        program.evaluator, program.constraints, program.space.stiffness
    )
    space = replace(program.space, stiffness=left or program.space.stiffness)
    effort = bench.effort
    if space.gap_is_free:
        points = grid(space, effort.stiffnesses_with_gap, effort.gaps)
    else:
        points = grid(space, effort.stiffnesses, 1)
    return program.evaluator.scan.performances(points)


def count_valleys(program: DesignProblem, scanned: tuple[Performance, ...]) -> int:
    """Return how many local minima of damage a scan over stiffness shows."""
    damage = DesignProblem(
        program.evaluator, program.space, Objective.DAMAGE, constraints=()
    )
    return len(local_minima(damage, scanned))


def out_of_reach(program: DesignProblem) -> tuple[float, str] | None:
    """Return why no stiffness of the space can meet the limits on natural frequency.

    The smallest relative excess, and a sentence; None if some stiffness can.
    """
    evaluator, span = program.evaluator, program.space.stiffness
    if reachable_stiffness(evaluator, program.constraints, span) is not None:
        return None
    ends = [evaluator.outline(stiffness) for stiffness in span]
    excess = min(program.violation_without_rollout(end) for end in ends)
    low, high = (float(end.natural_frequency) for end in ends)
    remark = f"natural frequency only {low:.4g} to {high:.4g} Hz"
    if evaluator.candidate.connection.kind is not ConnectionKind.TIGHT_FIT:
        remark += ": the contact is a spring in series with the coupling"
    return excess, remark


def verdict_remark(program: DesignProblem, performance: Performance) -> str:
    """Return in words whether a performance meets every limit, or which it fails."""
    failed = [c.name for c in program.constraints if float(c.excess(performance)) > 0]
    return f"fails: {', '.join(failed)}" if failed else "meets every limit"

"""The whole stiffness x gap plane of a candidate, rolled out before any optimiser."""

from __future__ import annotations

from dataclasses import dataclass, replace

from coupling_design.design.problem import DesignProblem
from coupling_design.design.reach import reachable_stiffness
from coupling_design.design.results import DesignMap, Performance
from coupling_design.design.scan import grid
from coupling_design.design.search import Workbench


@dataclass(frozen=True)
class Survey:
    """Performances over stiffness, row by row from the smallest gap to the largest."""

    rows: tuple[tuple[Performance, ...], ...]

    @property
    def smallest_gap(self) -> tuple[Performance, ...]:
        """The scan over stiffness at the smallest gap."""
        return self.rows[0]

    @property
    def largest_gap(self) -> tuple[Performance, ...]:
        """The scan over stiffness at the largest gap."""
        return self.rows[-1]

    def design_map(self, name: str) -> DesignMap:
        """Return damage and peak over the plane, as plain numbers."""
        return DesignMap(
            name=name,
            torsional_stiffness=tuple(p.torsional_stiffness for p in self.rows[0]),
            key_gap=tuple(row[0].key_gap for row in self.rows),
            damage=tuple(tuple(p.damage for p in row) for row in self.rows),
            peak_transmission_force=tuple(
                tuple(float(p.peak_transmission_force) for p in row)
                for row in self.rows
            ),
        )


def survey(bench: Workbench, program: DesignProblem) -> Survey:
    """Return the survey of a program's plane, as far as natural frequency allows."""
    evaluator, space = program.evaluator, program.space
    left = reachable_stiffness(evaluator, program.constraints, space.stiffness)
    narrowed = replace(space, stiffness=left or space.stiffness)
    effort = bench.effort
    points = grid(narrowed, effort.stiffnesses, effort.survey_gaps)
    bench.progress(
        f"mapping {evaluator.candidate.label}, {len(points)} stiffnesses and gaps"
    )
    found = evaluator.performances(points)
    n = effort.stiffnesses if narrowed.stiffness[1] > narrowed.stiffness[0] else 1
    return Survey(tuple(found[i : i + n] for i in range(0, len(found), n)))

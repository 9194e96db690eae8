"""A run-down at every point of a grid."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import product
from typing import Any

import numpy as np

from coupling_design.arithmetic import FloatArray
from coupling_design.case.edit.overrides import override
from coupling_design.case.load import case_of
from coupling_design.case.text.document import Document
from coupling_design.checks.time_step import check_time_step
from coupling_design.checks.warnings import ends_above_resonance
from coupling_design.errors import SimulationError
from coupling_design.explore.axes import GAP_PATH, STIFFNESS_PATH, Axis
from coupling_design.explore.grid import Grid, Quantity
from coupling_design.explore.points import Point, find_point
from coupling_design.explore.simulation import facts_of
from coupling_design.machine.machine import Case
from coupling_design.wear.conditioning import are_chaotic
from coupling_design.wear.evaluator import Evaluator
from coupling_design.wear.performance import Performance

COMPLETE = "complete"
# Points per batch: what takes well under a second on machine code, and without.
_BATCH, _SMALL_BATCH = 64, 4
_TOTALS = (
    ("natural_frequency", "Hz", "lowest natural frequency, gap closed, undamped"),
    ("damage", "1", "Miner sum of one run-down, of the bearing that suffers more"),
    ("damage_1", "1", "Miner sum of one run-down, {0}"),
    ("damage_2", "1", "Miner sum of one run-down, {1}"),
    ("peak_transmission_force", "N", "largest transmission force F_c"),
    ("peak_combined_load_1", "N", "largest combined load, {0}"),
    ("peak_combined_load_2", "N", "largest combined load, {1}"),
    ("final_speed", "rad/s", "of what turns fastest when the run-down ends"),
    ("above_resonance", "1", "1 where it ends before the largest order's resonance"),
    ("chaotic", "1", "1 where a start moved by 1e-12 rad moves damage by over 1e-3"),
)

Advance = Callable[[int], None]


@dataclass(frozen=True)
class Plan:
    """A sweep not yet run: its axes, and the case of each place off stiffness and gap.

    `cases` has an entry for each combination of the other axes' indices; `named_size`
    is one of the catalogue in place of the present coupling.
    """

    case: Case
    axes: tuple[Axis, ...]
    cases: dict[tuple[int, ...], Case]
    named_size: str | None = None

    def point(self, case: Case) -> Point:
        """Return what a case has where no axis says otherwise."""
        return find_point(case, size=self.named_size)

    @property
    def shape(self) -> tuple[int, ...]:
        """How many values each axis has."""
        return tuple(len(axis.texts) for axis in self.axes)

    @property
    def size(self) -> int:
        """How many run-downs it takes."""
        return math.prod(self.shape)


def plan_sweep(
    document: Document, case: Case, axes: tuple[Axis, ...], size: str | None = None
) -> Plan:
    """Return a sweep with every case validated; raise CaseError if one is not valid."""
    find_point(case, size=size)
    others = [axis for axis in axes if not axis.is_design]
    cases = {}
    for indices in product(*(range(len(axis.texts)) for axis in others)):
        values = [
            f"{axis.path}={axis.texts[i]}"
            for axis, i in zip(others, indices, strict=True)
        ]
        cases[indices] = case_of(override(document, values)) if values else case
        check_time_step(cases[indices])
    return Plan(case, axes, cases, size)


def run_sweep(plan: Plan, advance: Advance = lambda _: None) -> Grid:
    """Return what a run-down does at every point of a plan.

    NaN where it leaves finite numbers. Interrupted, it returns what is finished; the
    fact `status` says so. `advance` takes how many points are done since the last.
    """
    totals: FloatArray = np.full((len(_TOTALS), plan.size), np.nan)
    done = 0
    status = COMPLETE
    try:
        for evaluator, places in _batches(plan):
            points = [point for _, point in places]
            rows = _perform(evaluator, points)
            for (index, _), row in zip(places, rows, strict=True):
                totals[:, np.ravel_multi_index(index, plan.shape)] = row
            done += len(points)
            advance(len(points))
    except KeyboardInterrupt:
        status = f"interrupted after {done} of {plan.size} points"
    return _grid(plan, totals, status, int(done - np.isfinite(totals[1]).sum()))


def _grid(plan: Plan, totals: FloatArray, status: str, diverged: int) -> Grid:
    names = [bearing.name for bearing in plan.case.bearings]
    facts = facts_of(plan.case, plan.point(plan.case))
    return Grid(
        axes=tuple(axis.quantity for axis in plan.axes),
        quantities=tuple(
            Quantity(name, unit, meaning.format(*names), values.reshape(plan.shape))
            for (name, unit, meaning), values in zip(_TOTALS, totals, strict=True)
        ),
        facts={
            **facts,
            "status": status,
            "diverged": str(diverged),
            "rest_speed": repr(
                float(plan.case.driveline.engine_resistance.transition_speed)
            ),
        },
    )


_Place = tuple[tuple[int, ...], tuple[float, float]]


def _batches(plan: Plan) -> Iterator[tuple[Evaluator, Sequence[_Place]]]:
    """Yield evaluators with some points each: where in the grid, stiffness and gap."""
    for other, case in plan.cases.items():
        present = plan.point(case)
        evaluator = Evaluator(case, present.candidate)
        places = list(_places(plan, other, present))
        size = _BATCH if evaluator.is_compiled else _SMALL_BATCH
        for start in range(0, len(places), size):
            yield evaluator, places[start : start + size]


def _places(plan: Plan, other: tuple[int, ...], present: Point) -> Iterator[_Place]:
    fixed = iter(other)
    choices = [
        range(len(axis.texts)) if axis.is_design else (next(fixed),)
        for axis in plan.axes
    ]
    for index in product(*choices):
        values: dict[str, Any] = {
            axis.path: float(axis.quantity.values[i])
            for axis, i in zip(plan.axes, index, strict=True)
            if axis.is_design
        }
        yield (
            index,
            (
                values.get(STIFFNESS_PATH, present.torsional_stiffness),
                values.get(GAP_PATH, present.key_gap),
            ),
        )


def _perform(
    evaluator: Evaluator, points: Sequence[tuple[float, float]]
) -> list[list[float]]:
    try:
        found = evaluator.performances(points)
        return [
            [
                *_row(each),
                float(ends_above_resonance(evaluator.case, each)),
                float(is_chaotic),
            ]
            for each, is_chaotic in zip(
                found, are_chaotic(evaluator, points), strict=True
            )
        ]
    except SimulationError:
        if len(points) == 1:
            return [[math.nan] * len(_TOTALS)]
        return [row for point in points for row in _perform(evaluator, [point])]


def _row(performance: Performance) -> list[float]:
    return [
        float(performance.natural_frequency),
        performance.damage,
        *map(float, performance.damages),
        float(performance.peak_transmission_force),
        *map(float, performance.peak_combined_load),
        performance.spread.final_speed if performance.spread else math.nan,
    ]

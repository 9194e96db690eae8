"""What passes from one step of the design flow to the next."""

from __future__ import annotations

from dataclasses import dataclass, replace

from coupling_design.machine.candidate import Candidate
from coupling_design.machine.coupling_type import CouplingType
from coupling_design.machine.hub_seat import ConnectionOption
from coupling_design.machine.machine import Case
from coupling_design.machine.words import ConnectionKind, Plan
from coupling_design.search.optimum import Optimum
from coupling_design.search.plane import Survey
from coupling_design.search.program import Constraint
from coupling_design.search.workbench import Workbench
from coupling_design.steps.baseline import Baseline
from coupling_design.steps.step_result import StepResult


@dataclass(frozen=True)
class AllowedType:
    """A coupling type still in the running, with the stiffness left to it [N m/rad]."""

    coupling_type: CouplingType
    stiffness: tuple[float, float]


@dataclass(frozen=True)
class Solution:
    """The design so far: its candidate and optimum, and what it has to keep."""

    plan: Plan
    candidate: Candidate
    allowed: AllowedType
    optimum: Optimum
    constraints: tuple[Constraint, ...]


@dataclass(frozen=True)
class FlowState:
    """The design flow after some of its steps; a step returns a new one.

    `elastic` and `stiff` are the types left for either plan; `solution` is None until
    a step has found a design; `nearest` is the best of those that failed. `surveys`,
    each with the number of its step, become the steps' maps at the end of the flow.
    """

    case: Case
    bench: Workbench
    baseline: Baseline
    elastic: tuple[AllowedType, ...] = ()
    stiff: tuple[AllowedType, ...] = ()
    steps: tuple[StepResult, ...] = ()
    solution: Solution | None = None
    nearest: Optimum | None = None
    surveys: tuple[tuple[int, Survey], ...] = ()

    def after(self, result: StepResult, **changes: object) -> FlowState:
        """Return the state with a step's result and whatever it changes."""
        return replace(self, steps=(*self.steps, result), **changes)  # type: ignore[arg-type]


def connection_option(case: Case, kind: ConnectionKind) -> ConnectionOption:
    """Return the case's option of a kind; the case guarantees that it exists."""
    return next(option for option in case.connections if option.kind is kind)


def options_of(case: Case, coupling_type: CouplingType) -> tuple[ConnectionOption, ...]:
    """Return the connections a type may have, the tightest last."""
    options = [o for o in case.connections if o.kind in coupling_type.connections]
    return tuple(sorted(options, key=lambda option: -option.minimum_gap))


def gap_nearest_present(case: Case, option: ConnectionOption) -> float:
    """Return the gap of an option that is nearest to the present one [m]."""
    present = getattr(case.driveline.connection, "gap", 0.0)
    return min(max(present, option.minimum_gap), option.maximum_gap)

"""What a design run found: plain frozen values in SI, for the report and for JSON."""

from __future__ import annotations

from dataclasses import dataclass, field

from coupling_design.checks.fatigue_limits import FatigueLimits
from coupling_design.flow.size_choice import CatalogueChoice
from coupling_design.machine.machine import Case
from coupling_design.machine.sourced_value import SourcedValue
from coupling_design.machine.words import Plan
from coupling_design.parts.criterion import Criterion
from coupling_design.search.design_map import DesignMap
from coupling_design.search.optimum import Optimum
from coupling_design.steps.baseline import Baseline
from coupling_design.steps.step_result import StepResult
from coupling_design.wear.conditioning import Conditioning
from coupling_design.wear.performance import Performance
from coupling_design.wear.sensitivity import Sensitivity
from coupling_design.wear.signals import Rundown, RundownHistory


@dataclass(frozen=True)
class ChosenDesign:
    """The coupling to take, against the present one and against every limit.

    `size` is its name in the catalogue, None for an ideal stiffness between sizes.
    `reduction_range` is what the reduction of damage lies between when inputs move;
    `fuel_cut_at_once`, of the high-stiffness plan alone, what it does if the fuel's
    torque goes at once, the bound.
    """

    plan: Plan
    coupling_type: str
    connection: str
    performance: Performance
    rundown: Rundown
    conditioning: Conditioning
    damage_reduction: float
    criteria: tuple[Criterion, ...]
    sensitivity: Sensitivity
    reduction_range: tuple[float, float]
    fuel_cut_at_once: Performance | None = None
    size: str | None = None

    @property
    def digits(self) -> int:
        """Digits of the damage that stand, numerically and when inputs move."""
        return min(self.conditioning.digits, self.sensitivity.digits)


@dataclass(frozen=True)
class LoadReading:
    """One way to read the load limit, and what the chosen design does under it."""

    reading: str
    criteria: tuple[Criterion, ...]
    passes: bool
    permissible_transmission_force: float


@dataclass(frozen=True)
class DesignOutcome:
    """The whole run: everything a report needs.

    `chosen` is None when no design meets the limits; `nearest` then names the
    candidate that came nearest and `nearest_criteria` how near, `reasons` what rules
    out any. `warnings` are to be read first, `remarks` limit what was shown. `engine`
    says what did the `rollouts`, and `coarse_rollouts` at a longer step for maps. For
    figures: `histories`, the present run-down first, and `chosen_map`, the plane of
    the chosen coupling where no step has it.
    """

    case: Case
    baseline: Baseline
    steps: tuple[StepResult, ...]
    chosen: ChosenDesign | None
    strict_reading: LoadReading | None
    nearest: Optimum | None
    nearest_criteria: tuple[Criterion, ...]
    assumptions: tuple[SourcedValue, ...]
    engine: str
    rollouts: int
    run_time: float
    coarse_rollouts: int = 0
    catalogue_choice: CatalogueChoice | None = None
    fatigue_limits: tuple[FatigueLimits, ...] = ()
    warnings: tuple[str, ...] = ()
    reasons: tuple[str, ...] = ()
    remarks: tuple[str, ...] = ()
    histories: tuple[RundownHistory, ...] = field(default=(), compare=False, repr=False)
    chosen_map: DesignMap | None = None

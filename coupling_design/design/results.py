"""What a design run found: plain frozen values in SI, for the report and for JSON."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import StrEnum

from coupling_design.case.case import Case, Plan, SourcedValue
from coupling_design.design.catalogue_choice import CatalogueChoice
from coupling_design.design.fatigue_limits import FatigueLimits
from coupling_design.design.maps import CoarseStep as CoarseStep
from coupling_design.design.maps import DesignMap as DesignMap
from coupling_design.design.performance import Criterion as Criterion
from coupling_design.design.performance import Performance as Performance
from coupling_design.design.performance import Sense as Sense
from coupling_design.design.performance import Verdict as Verdict
from coupling_design.design.sensitivity import Sensitivity
from coupling_design.design.signals import RundownHistory


class Decision(StrEnum):
    """How a step of the flow ended."""

    PASS = "pass"
    FAIL = "fail"
    SKIPPED = "skipped"


@dataclass(frozen=True)
class Conditioning:
    """How firmly a damage stands.

    Attributes
    ----------
    damage_change_by_start : relative change when the start is moved by 1e-12 rad
    damage_change_by_step : relative change when the time step is halved
    peak_change_by_step : relative change of the peak force when it is halved
    digits : significant digits that both leave standing, 1 to 6
    """

    damage_change_by_start: float
    damage_change_by_step: float
    peak_change_by_step: float
    digits: int


@dataclass(frozen=True)
class Optimum:
    """A point that an optimisation ended at, checked again on its own.

    Attributes
    ----------
    objective : what was minimised, in words
    performance : of the point, by a rollout of its own
    connection : key, spline or tight_fit
    coupling_type : name
    method : "ipopt", or "scan" where Ipopt gave nothing better
    solver_status : Ipopt's own words
    starts, starts_agreeing : how many there were and how many ended at this point
    scan_points : rollouts of the scan that chose the starts
    rollouts : evaluations of all starts together
    kkt_residual : largest entry of the scaled Lagrangian's gradient at the point [-]
    active_constraints : names of constraints and bounds that hold the point
    held_by : the same in words, or that the objective goes on falling
    conditioning : how firmly its damage stands
    """

    objective: str
    performance: Performance
    connection: str
    coupling_type: str
    method: str
    solver_status: str
    starts: int
    starts_agreeing: int
    scan_points: int
    rollouts: int
    kkt_residual: float | None
    active_constraints: tuple[str, ...]
    held_by: str
    conditioning: Conditioning | None


@dataclass(frozen=True)
class Alternative:
    """One line of what a step examined: a candidate, how it fared, and why."""

    name: str
    passes: bool
    performance: Performance | None
    remark: str


@dataclass(frozen=True)
class StepResult:
    """What one step of the flow asked and found.

    `findings` are sentences on what was examined, `caveats` on what to be wary of.
    """

    step: int
    title: str
    question: str
    decision: Decision
    criteria: tuple[Criterion, ...] = ()
    alternatives: tuple[Alternative, ...] = ()
    findings: tuple[str, ...] = ()
    caveats: tuple[str, ...] = ()
    optimum: Optimum | None = None
    maps: tuple[DesignMap, ...] = ()


@dataclass(frozen=True)
class Rundown:
    """How a run-down went, read from its history.

    Attributes
    ----------
    resonance_speed : shaft speed at the largest swing of the force [rad/s]
    resonance_swing : half the peak-to-peak of the force at that swing [N]
    rest_time : when the engine came to rest [s], None if it did not
    revolutions : turns of the generator shaft, forward [-]
    final_speed : of the generator [rad/s]
    out_of_range_time : time with viscosity ratio below ISO 281's range [s]
    """

    resonance_speed: float
    resonance_swing: float
    rest_time: float | None
    revolutions: float
    final_speed: float
    out_of_range_time: float


@dataclass(frozen=True)
class Baseline:
    """The present coupling in the present connection."""

    performance: Performance
    connection: str
    coupling_type: str
    rundown: Rundown
    conditioning: Conditioning
    time_step: float
    largest_stable_step: float
    sensitivity: Sensitivity

    @property
    def digits(self) -> int:
        """Digits of the damage that stand, numerically and when inputs move."""
        return min(self.conditioning.digits, self.sensitivity.digits)


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

"""Present and chosen coupling over the speed range: Campbell diagram, steady vibration.

Sources
-------
[1] Advances in Mechanical Engineering 2023, doi 10.1177/16878132231190062: section
    "Design method", steps 2 and 4, sqrt 2 between excitation and natural frequency.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from coupling_design.arithmetic import FloatArray
from coupling_design.flow.outcome import ChosenDesign
from coupling_design.line.parameters import Driveline
from coupling_design.machine.candidate import Candidate, candidate_driveline
from coupling_design.machine.machine import Case
from coupling_design.machine.words import ConnectionKind, Plan
from coupling_design.speeds.campbell import (
    CriticalSpeed,
    critical_speeds,
    natural_frequencies,
    order_lines,
)
from coupling_design.speeds.vibration import (
    OperatingPoint,
    SteadyVibration,
    evaluate_vibration,
    operating_points,
)
from coupling_design.steps.limits import ISOLATION_RATIO
from coupling_design.steps.present import present_candidate
from coupling_design.steps.so_far import connection_option

CHART_END = 1.1  # of the highest working speed
# Points of the curves near a critical speed, relative to it: 0.5 % apart, so that a
# damping ratio of 0.01 still draws a round peak.
_AROUND_PEAKS = 1 + np.arange(-20, 21) / 200


@dataclass(frozen=True)
class ForbiddenBand:
    """Speeds that an order forbids to a coupling, [1]: sqrt 2 from its lowest mode.

    Soft plan: all below `border`, where excitation over natural frequency is less than
    sqrt 2. High-stiffness plan: all above, where natural frequency over excitation is.
    `order` [-], `border` [rad/s]; `reaches_working_speed` says whether it fails.
    """

    order: float
    plan: Plan
    border: float
    reaches_working_speed: bool


@dataclass(frozen=True)
class CouplingSpeeds:
    """One coupling over the speed range.

    Attributes
    ----------
    name, label : what it is to the design, "present", or a size's name; its type and
        connection
    torsional_stiffness : [N m/rad]
    natural_frequencies : of all torsional modes, ascending (n_modes,) [Hz]
    critical_speeds : slowest first, also those beyond the chart
    forbidden_bands : one per order
    vibration : over the chart
    operating_points : both ends of the working range, the worst in it and of all
    """

    name: str
    label: str
    torsional_stiffness: float
    natural_frequencies: FloatArray
    critical_speeds: tuple[CriticalSpeed, ...]
    forbidden_bands: tuple[ForbiddenBand, ...]
    vibration: SteadyVibration
    operating_points: tuple[OperatingPoint, ...]

    @property
    def separated(self) -> bool:
        """Whether every critical speed keeps its margin to the working range."""
        return all(critical.passes for critical in self.critical_speeds)

    @property
    def isolated(self) -> bool:
        """Whether no forbidden band reaches the working range."""
        return not any(band.reaches_working_speed for band in self.forbidden_bands)


@dataclass(frozen=True)
class SpeedMap:
    """Campbell diagram and steady vibration of a case, present coupling and chosen.

    Attributes
    ----------
    orders : of the excitation (n_orders,) [-]
    working_speed : lowest and highest [rad/s]
    speeds : of the diagram, both ends (2,) [rad/s]
    order_lines : frequency of each order at both ends (n_orders, 2) [Hz]
    present, chosen : the couplings; None where none was chosen
    """

    orders: FloatArray
    working_speed: tuple[float, float]
    speeds: FloatArray
    order_lines: FloatArray
    present: CouplingSpeeds
    chosen: CouplingSpeeds | None


def evaluate_speed_map(
    case: Case, chosen: ChosenDesign | None = None, other: Candidate | None = None
) -> SpeedMap:
    """Return the case's speed map, the chosen coupling's beside the present one's.

    `other` is a real size to show in place of the present coupling.
    """
    shown = other or present_candidate(case)
    name = other.size.name if other and other.size else "present"
    ends = np.array([0.0, _end(case.duty.working_speed)])
    return SpeedMap(
        orders=np.array([o.order for o in case.working_excitation], dtype=float),
        working_speed=case.duty.working_speed,
        speeds=ends,
        order_lines=order_lines(_at_work(case, case.driveline), ends),
        present=_coupling_speeds(case, name, shown, _line_of(case, shown)),
        chosen=None if chosen is None else _chosen_speeds(case, chosen),
    )


def _chosen_speeds(case: Case, chosen: ChosenDesign) -> CouplingSpeeds:
    kind = next(t for t in case.coupling_types if t.name == chosen.coupling_type)
    option = connection_option(case, ConnectionKind(chosen.connection))
    size = next((each for each in kind.sizes if each.name == chosen.size), None)
    candidate = Candidate(kind, option, size)
    design = chosen.performance
    driveline = candidate_driveline(
        case, candidate, design.torsional_stiffness, design.key_gap
    )
    return _coupling_speeds(case, "chosen", candidate, driveline)


def _coupling_speeds(
    case: Case, name: str, candidate: Candidate, driveline: Driveline
) -> CouplingSpeeds:
    working, driveline = case.duty.working_speed, _at_work(case, driveline)
    critical = critical_speeds(driveline, working)
    frequencies = natural_frequencies(driveline)
    peaks = np.outer([c.speed for c in critical], _AROUND_PEAKS).ravel()
    vibration = evaluate_vibration(driveline, _end(working), (*working, *peaks))
    return CouplingSpeeds(
        name=name,
        label=candidate.label,
        torsional_stiffness=float(driveline.coupling.torsional_stiffness),
        natural_frequencies=frequencies,
        critical_speeds=critical,
        forbidden_bands=tuple(
            _band(o.order, candidate.coupling_type.plan, float(frequencies[0]), working)
            for o in driveline.excitation
        ),
        vibration=vibration,
        operating_points=operating_points(vibration, working),
    )


def _line_of(case: Case, candidate: Candidate) -> Driveline:
    """Return the driveline with a size in it, or with the present stiffness."""
    size, line = candidate.size, case.driveline
    stiffness = size.torsional_stiffness if size else line.coupling.torsional_stiffness
    gap = getattr(line.connection, "gap", 0.0)
    return candidate_driveline(case, candidate, stiffness, gap)


def _at_work(case: Case, driveline: Driveline) -> Driveline:
    """Return a driveline driven as it is at working speed."""
    return replace(driveline, excitation=case.working_excitation)


def _band(
    order: float, plan: Plan, frequency: float, working: tuple[float, float]
) -> ForbiddenBand:
    """Return [1]: i Omega / omega_n >= sqrt 2 (soft), omega_n / (i Omega) (stiff)."""
    resonance = 2 * math.pi * frequency / order
    if plan is Plan.ELASTIC:
        border = ISOLATION_RATIO * resonance
        return ForbiddenBand(order, plan, border, border > working[0])
    border = resonance / ISOLATION_RATIO
    return ForbiddenBand(order, plan, border, border < working[1])


def _end(working: tuple[float, float]) -> float:
    return CHART_END * working[1]

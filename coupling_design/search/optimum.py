"""A point that an optimisation ended at."""

from __future__ import annotations

from dataclasses import dataclass

from coupling_design.wear.conditioning import Conditioning
from coupling_design.wear.performance import Performance


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

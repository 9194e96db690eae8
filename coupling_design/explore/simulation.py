"""One run-down, signal by signal."""

from __future__ import annotations

import math
from dataclasses import dataclass

from coupling_design import __version__
from coupling_design.arithmetic import FloatArray
from coupling_design.explore.grid import Grid, Quantity
from coupling_design.explore.points import Point
from coupling_design.machine.machine import Case
from coupling_design.wear.conditioning import chaotic
from coupling_design.wear.evaluator import Evaluator
from coupling_design.wear.performance import Performance
from coupling_design.wear.signals import RundownHistory, rundown_history


@dataclass(frozen=True)
class Simulation:
    """A run-down of one coupling.

    Attributes
    ----------
    case, point : what was rolled out
    performance : its totals, judged over all crank angles
    signals : over time, of the crank angle whose peak decides
    is_chaotic : whether a nudge of the start moves the damage by more than it may
    """

    case: Case
    point: Point
    performance: Performance
    signals: Grid
    is_chaotic: bool


def simulate_point(case: Case, point: Point) -> Simulation:
    """Return the run-down of a point; raise SimulationError where it diverges."""
    evaluator = Evaluator(case, point.candidate)
    stiffness, gap = point.torsional_stiffness, point.key_gap
    performance = evaluator.performance(stiffness, gap)
    line = evaluator.history(stiffness, gap)
    history = rundown_history(
        case, point.candidate.label, line, performance, "simulated"
    )
    facts = {
        **facts_of(case, point),
        "crank_angle": f"{math.degrees(line.crank_angle):.6g} deg",
        "gravity_angle": f"{math.degrees(line.gravity_angle):.6g} deg",
    }
    signals = Grid((_time(history),), _signals(history, case), facts)
    is_chaotic = chaotic(evaluator, performance)
    return Simulation(case, point, performance, signals, is_chaotic)


def facts_of(case: Case, point: Point) -> dict[str, str]:
    """Return what a file of results must say of where they come from."""
    return {
        "title": case.name,
        "case_file": case.file,
        "case_sha256": case.sha256,
        "overrides": "; ".join(case.overrides),
        "coupling": point.candidate.label,
        "source": f"coupling_design {__version__}",
    }


def _time(history: RundownHistory) -> Quantity:
    return Quantity("time", "s", "time since the shutdown", history.driveline.time)


def _signals(history: RundownHistory, case: Case) -> tuple[Quantity, ...]:
    line = history.driveline
    rows: list[tuple[str, str, str, FloatArray]] = [
        ("engine_speed", "rad/s", "speed of the engine", line.engine_speed),
        ("generator_speed", "rad/s", "speed of the generator", line.generator_speed),
        (
            "transmission_force",
            "N",
            "F_c, tangential at the connection's radius",
            line.transmission_force,
        ),
        (
            "coupling_torque",
            "N*m",
            "torque in the elastic part of the coupling",
            line.coupling_torque,
        ),
        ("generator_angle", "rad", "turned since the start", line.generator_angle),
    ]
    for k, (bearing, seen) in enumerate(
        zip(case.bearings, history.bearings, strict=True), start=1
    ):
        load = f"combined load, {bearing.name}"
        rows.append((f"combined_load_{k}", "N", load, seen.combined_load))
    for k, (bearing, seen) in enumerate(
        zip(case.bearings, history.bearings, strict=True), start=1
    ):
        damage = f"Miner sum up to the end of the step, {bearing.name}"
        rows.append((f"damage_{k}", "1", damage, seen.damage))
    return tuple(Quantity(*row) for row in rows)

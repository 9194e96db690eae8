"""What the initial speed does to damage: in one run-down, and judged over chance.

Close to the stop's end gravity stands still against the joint, before that it goes
round with it: where it stands when the resonance passes is chance, and a slightly
faster start throws the dice again.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from coupling_design.arithmetic import FloatArray
from coupling_design.machine.machine import Case
from coupling_design.wear.evaluator import Evaluator
from coupling_design.wear.variables import INITIAL_SPEED
from studies.machine import (
    high_stiffness,
    present,
    present_point,
    required_stiffness,
)

# The invented small set, whose bearings feel their rotor's weight most.
INVENTED = Path(__file__).parents[1] / "cases" / "small_genset.yaml"
# An odd number, so that the middle is the case's own speed.
_FACTORS = np.linspace(0.97, 1.03, 25)
_LONGER = 1.25

Coupling = tuple[Evaluator, tuple[float, float]]


@dataclass(frozen=True)
class SpeedReach:
    """Lowest and highest relative change of D over the initial speed [-].

    `one_run_down` is that from the case's own crank angle and direction of gravity,
    `judged` that of the mean over them.
    """

    case: str
    coupling: str
    one_run_down: tuple[float, float]
    judged: tuple[float, float]


def couplings(case: Case) -> tuple[Coupling, Coupling]:
    """Return the present coupling and the stiff one, each with its design point."""
    return (
        (present(case), present_point(case)),
        (high_stiffness(case), (required_stiffness(case), 0.0)),
    )


def until_rest(case: Case) -> Case:
    """Return the case with run-downs long enough for faster ones to come to rest."""
    duration = round(_LONGER * case.shutdown.duration, 1)
    return replace(case, shutdown=replace(case.shutdown, duration=duration))


def reaches(case: Case) -> tuple[SpeedReach, SpeedReach]:
    """Return what the initial speed does to both couplings of a case."""
    built, stiff = (
        SpeedReach(
            case.name,
            name,
            _ends(_damages(each.scan, point)),
            _ends(_damages(each, point)),
        )
        for name, (each, point) in zip(
            ("present", "stiff"), couplings(until_rest(case)), strict=True
        )
    )
    return built, stiff


def _damages(evaluator: Evaluator, point: tuple[float, float]) -> FloatArray:
    chances = evaluator.chances
    columns = evaluator.run_downs.variables.columns([point] * len(_FACTORS), chances)
    columns[INITIAL_SPEED] *= np.repeat(_FACTORS, chances.shape[1])
    return np.array([p.damage for p in evaluator.performances_from(columns)])


def _ends(damages: FloatArray) -> tuple[float, float]:
    changes = damages / damages[len(damages) // 2] - 1
    return float(changes.min()), float(changes.max())

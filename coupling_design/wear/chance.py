"""What is chance in a run-down: crank angle and direction of gravity at its start.

A result is judged over evenly spread ones: the largest peak, the mean damage.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from coupling_design.arithmetic import FloatArray
from coupling_design.events.settled_state import period_of
from coupling_design.line.parameters import (
    FuelCutStart,
    QuasiSteadyStart,
    Shutdown,
)
from coupling_design.machine.machine import Case

# Of the golden section: a lattice of this slope fills the square most evenly.
_GOLDEN = (3 - math.sqrt(5)) / 2


@dataclass(frozen=True)
class Spread:
    """How far the totals of a run-down reach over what is chance, lowest and highest.

    Attributes
    ----------
    crank_angles : how many run-downs there were
    damages : of bearing 1 and of bearing 2 [-]
    peak_transmission_force : [N]
    mean_peak : mean of that force [N]
    worst : place of the run-down with the largest peak force
    final_speed : of whatever turns fastest when the run-downs end [rad/s]
    repeats : whether the settled vibration they start from is periodic
    """

    crank_angles: int
    damages: tuple[tuple[float, float], tuple[float, float]]
    peak_transmission_force: tuple[float, float]
    mean_peak: float
    worst: int
    final_speed: float = 0.0
    repeats: bool = True


def chances(case: Case, n: int) -> FloatArray:
    """Return n crank angles and directions of gravity [rad], shape (2, n).

    The first are the case's own. Crank angles are spread over the orders' period,
    beyond which they repeat; gravity goes round once, in leaps, so that each of its
    directions meets another crank angle: n run-downs stand for n times as many.
    """
    place = np.arange(n)
    leap = next(m for m in _nearest(_GOLDEN * n) if math.gcd(m, n) == 1)
    period = period_of(case.driveline.excitation)
    shutdown = case.shutdown
    return np.stack(
        [
            float(shutdown.crank_angle) + period * place / n,
            float(shutdown.gravity_angle) + 2 * math.pi * (leap * place % n) / n,
        ]
    )


def describe_start(shutdown: Shutdown) -> str:
    """Return what the line does when the run-down begins."""
    match shutdown.start:
        case FuelCutStart(duration=0.0):
            return "settled at idle, the fuel's mean torque gone at once"
        case FuelCutStart(duration=duration):
            over = f"taken away over {duration:.3g} s"
            return f"settled at idle, the fuel's mean torque {over}"
        case QuasiSteadyStart():
            return "turning evenly, twisted by the mean deceleration, no vibration yet"
    return "settled vibration of the engine turned without fuel"


def _nearest(value: float) -> list[int]:
    """Return whole numbers from 1 on, the nearest to a value first."""
    last = math.ceil(2 * value) + 2
    return sorted(range(1, last), key=lambda number: abs(number - value))

"""Campbell diagram: where an order of excitation meets a natural frequency.

Sources
-------
[1] Friswell, Penny, Garvey, Lees (2010), Dynamics of Rotating Machines: Campbell
    diagram; order i crosses f_n at the speed Omega = 2 pi f_n / i.
[2] API 617, torsional analysis: natural frequencies at least 10 % below or above any
    excitation within the operating speed range, as told by Wang, Feese, Pettinato
    (2012), Torsional natural frequencies: measurement vs. prediction, 41st
    Turbomachinery Symposium. Written for turbomachines; here a yardstick.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import StrEnum

import numpy as np

from coupling_design.arithmetic import FloatArray
from coupling_design.line.modes import modes
from coupling_design.line.parameters import Driveline

REQUIRED_SEPARATION = 0.10


class Position(StrEnum):
    """Where a critical speed lies, seen from the working speed range."""

    BELOW = "below"
    INSIDE = "inside"
    ABOVE = "above"


@dataclass(frozen=True)
class CriticalSpeed:
    """A speed at which an order of excitation meets a natural frequency.

    Attributes
    ----------
    speed : mean speed of the crankshaft [rad/s]
    order : of the excitation [-]
    mode : 1 is the lowest torsional mode; the rigid body's is none
    natural_frequency : of that mode, gap closed, undamped [Hz]
    position : seen from the working speed range
    separation_margin : to the nearer end of that range, relative to that end, negative
        inside [-]
    passes : whether the margin is at least `REQUIRED_SEPARATION`
    """

    speed: float
    order: float
    mode: int
    natural_frequency: float
    position: Position
    separation_margin: float
    passes: bool


def natural_frequencies(driveline: Driveline) -> FloatArray:
    """Return all torsional natural frequencies, undamped, gap closed, ascending [Hz].

    The rigid body's zero is left out: (n_bodies - 1,). No order of speed enters the
    model's matrices, so they are horizontal lines in the diagram.
    """
    return modes(driveline).angular_frequencies[1:] / (2 * math.pi)


def order_lines(driveline: Driveline, speeds: FloatArray) -> FloatArray:
    """Return the frequency of each order at each mean speed [rad/s], in [Hz].

    `speeds` (n_speeds,) give frequencies (n_orders, n_speeds): f = i Omega / (2 pi),
    [1].
    """
    orders = np.array([o.order for o in driveline.excitation], dtype=float)
    return np.outer(orders, speeds) / (2 * math.pi)


def critical_speeds(
    driveline: Driveline, working_speed: tuple[float, float]
) -> tuple[CriticalSpeed, ...]:
    """Return where the orders meet the natural frequencies, slowest first, [1].

    `working_speed` is the lowest and the highest [rad/s]. There is a speed for each
    order and natural frequency (n_orders (n_bodies - 1),).
    """
    found = [
        _critical_speed(excitation.order, mode, float(frequency), working_speed)
        for mode, frequency in enumerate(natural_frequencies(driveline), start=1)
        for excitation in driveline.excitation
    ]
    return tuple(sorted(found, key=lambda critical: critical.speed))


def separation_margin(speed: float, working_speed: tuple[float, float]) -> float:
    """Return the distance of a speed to the nearer end of a range, over that end [-].

    Positive outside the range, negative inside, [2]. Speeds in [rad/s].
    """
    lowest, highest = working_speed
    below, above = (lowest - speed) / lowest, (speed - highest) / highest
    return max(below, above)


def _critical_speed(
    order: float, mode: int, frequency: float, working_speed: tuple[float, float]
) -> CriticalSpeed:
    lowest, highest = working_speed
    speed = 2 * math.pi * frequency / order
    margin = separation_margin(speed, working_speed)
    if speed < lowest:
        position = Position.BELOW
    elif speed > highest:
        position = Position.ABOVE
    else:
        position = Position.INSIDE
    return CriticalSpeed(
        speed=speed,
        order=order,
        mode=mode,
        natural_frequency=frequency,
        position=position,
        separation_margin=margin,
        passes=margin >= REQUIRED_SEPARATION,
    )

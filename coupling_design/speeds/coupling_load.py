"""What steady vibration asks of a coupling, in the vocabulary of DIN 740-2.

Sources
-------
[1] DIN 740-2:1986, Flexible shaft couplings: vibratory torque T_W against T_KW, damping
    power P_W against P_KV, frequency factor S_f, resonance factor V_R.
[2] FLENDER Standard Couplings, catalogue MD 10.1: the frequency factor FF of [1].

The vibratory torques are those of `forced_response`. A relative damping or loss factor
is work per cycle, whatever the frequency [1]: each order has it at its own.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from coupling_design.line.forced_response import forced_response
from coupling_design.line.modes import natural_angular_frequency
from coupling_design.line.parameters import Driveline

_SPEEDS = 33
_REFERENCE_FREQUENCY = 10.0  # [Hz], at which T_KW is given, [1]


@dataclass(frozen=True)
class WorkingLoad:
    """The worst that a range of speeds asks of a coupling.

    Attributes
    ----------
    vibratory_torque : sum over orders of T_W S_f, should their crests meet [N m]
    vibratory_speed : where that is largest [rad/s]
    power_loss : sum over orders of the heat from damping, P_W [W]
    power_speed : where that is largest [rad/s]
    """

    vibratory_torque: float
    vibratory_speed: float
    power_loss: float
    power_speed: float


@dataclass(frozen=True)
class Passage:
    """The worst resonance below the working speeds, passed in each start and stop.

    `torque` is the sum over orders at `speed` [rad/s], swung up in full [N m].
    """

    torque: float
    speed: float
    order: float


def frequency_factor(frequency: float) -> float:
    """Return S_f = sqrt(f / 10 Hz) [-], 1 up to 10 Hz; [1], FF in [2]."""
    return math.sqrt(max(frequency / _REFERENCE_FREQUENCY, 1.0))


def working_load(driveline: Driveline, speeds: tuple[float, float]) -> WorkingLoad:
    """Return the worst of a range of mean speeds (lowest, highest) [rad/s]."""
    lowest, highest = speeds
    inside = [w for _, w in _resonances(driveline) if lowest < w < highest]
    looked_at = sorted([*np.linspace(lowest, highest, _SPEEDS).tolist(), *inside])
    torques: list[float] = []
    powers: list[float] = []
    for speed in looked_at:
        orders = _orders(driveline, speed)
        torques.append(sum(T_W * frequency_factor(f) for f, T_W, _ in orders))
        powers.append(sum(P_W for _, _, P_W in orders))
    worst, hottest = int(np.argmax(torques)), int(np.argmax(powers))
    return WorkingLoad(
        vibratory_torque=torques[worst],
        vibratory_speed=looked_at[worst],
        power_loss=powers[hottest],
        power_speed=looked_at[hottest],
    )


def resonance_passage(driveline: Driveline, lowest_speed: float) -> Passage | None:
    """Return the worst resonance below a mean speed [rad/s], None if there is none.

    [1] swings it up in full, by V_R = 2 pi / psi: a passage reaches less.
    """
    passed = [
        Passage(sum(T_W for _, T_W, _ in _orders(driveline, speed)), speed, order)
        for order, speed in _resonances(driveline)
        if speed <= lowest_speed
    ]
    return max(passed, key=lambda passage: passage.torque, default=None)


def _resonances(driveline: Driveline) -> list[tuple[float, float]]:
    """Return each order and the mean speed [rad/s] at which it meets the coupling."""
    omega_n = float(natural_angular_frequency(driveline))
    return [(each.order, omega_n / each.order) for each in driveline.excitation]


def _orders(driveline: Driveline, speed: float) -> list[tuple[float, float, float]]:
    """Return frequency [Hz], T_W [N m] and P_W [W] of each order at a mean speed."""
    response = forced_response(driveline, np.array([speed]), per_cycle=True)
    return [
        (
            float(order) * speed / (2 * math.pi),
            float(np.abs(response.coupling_torque[i, 0])),
            float(response.power_loss[i, 0]),
        )
        for i, order in enumerate(response.orders)
    ]

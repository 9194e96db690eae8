"""Steady vibration of a coupling over the speed range, order by order and together.

Sources
-------
[1] DIN 740-2:1986, Flexible shaft couplings: vibratory torque T_W, damping power P_W.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from coupling_design.arithmetic import FloatArray
from coupling_design.line.forced_response import forced_response
from coupling_design.line.parameters import Driveline

_SPEEDS = 550  # evenly over the range; those asked for come on top


@dataclass(frozen=True)
class SteadyVibration:
    """Amplitudes of the steady vibration over speed, gap closed, linear, [1].

    Attributes
    ----------
    speeds : (n_speeds,) [rad/s]
    vibratory_torque : in the elastic coupling (n_orders, n_speeds) [N m]
    vibratory_torque_sum : all orders, as if their crests met (n_speeds,) [N m]
    vibratory_torque_rms : root mean square of all orders (n_speeds,) [N m]
    twist : of the elastic coupling (n_orders, n_speeds) [rad]
    transmission_torque_sum : through the connection, as the sum above (n_speeds,)
        [N m]; the gap stays closed while the mean torque is larger
    power_loss : heat in the coupling, all orders (n_speeds,) [W]
    """

    speeds: FloatArray
    vibratory_torque: FloatArray
    vibratory_torque_sum: FloatArray
    vibratory_torque_rms: FloatArray
    twist: FloatArray
    transmission_torque_sum: FloatArray
    power_loss: FloatArray


@dataclass(frozen=True)
class OperatingPoint:
    """The steady vibration at one speed, named; units as in `SteadyVibration`.

    `vibratory_torque` is (n_orders,); all else are single numbers.
    """

    name: str
    speed: float
    vibratory_torque: tuple[float, ...]
    vibratory_torque_sum: float
    vibratory_torque_rms: float
    transmission_torque_sum: float
    power_loss: float


def evaluate_vibration(
    driveline: Driveline, highest_speed: float, also: Sequence[float]
) -> SteadyVibration:
    """Return the steady vibration up to a speed, and at others on the way [rad/s].

    Name speeds near resonance in `also`, so that no peak falls between two points; the
    range begins above zero, where a line free to turn has no steady vibration. Shapes
    are those of `SteadyVibration`, its speeds ascending and each there once.
    """
    even = np.linspace(0.0, highest_speed, _SPEEDS + 1)[1:]
    others = [speed for speed in also if 0.0 < speed < highest_speed]
    speeds = np.unique(np.concatenate([even, others]))
    response = forced_response(driveline, speeds, per_cycle=True)
    torque = np.abs(response.coupling_torque)
    return SteadyVibration(
        speeds=speeds,
        vibratory_torque=torque,
        vibratory_torque_sum=torque.sum(axis=0),
        # Different orders, each of mean square T^2 / 2, are orthogonal over a turn.
        vibratory_torque_rms=np.sqrt((torque**2).sum(axis=0) / 2),
        twist=np.abs(response.twist),
        transmission_torque_sum=np.abs(response.transmission_torque).sum(axis=0),
        power_loss=response.power_loss.sum(axis=0),
    )


def operating_points(
    vibration: SteadyVibration, working: tuple[float, float]
) -> tuple[OperatingPoint, ...]:
    """Return both ends of the working range [rad/s], the worst in it and of all.

    These are four points. The ends must be among the vibration's speeds.
    """
    speeds, total = vibration.speeds, vibration.vibratory_torque_sum
    inside = (speeds >= working[0]) & (speeds <= working[1])
    places = {
        "lowest working speed": np.searchsorted(speeds, working[0]),
        "highest working speed": np.searchsorted(speeds, working[1]),
        "worst of the working range": np.where(inside, total, -1.0).argmax(),
        "worst of all speeds": total.argmax(),
    }
    return tuple(_point(name, vibration, int(at)) for name, at in places.items())


def _point(name: str, vibration: SteadyVibration, at: int) -> OperatingPoint:
    return OperatingPoint(
        name=name,
        speed=float(vibration.speeds[at]),
        vibratory_torque=tuple(float(t) for t in vibration.vibratory_torque[:, at]),
        vibratory_torque_sum=float(vibration.vibratory_torque_sum[at]),
        vibratory_torque_rms=float(vibration.vibratory_torque_rms[at]),
        transmission_torque_sum=float(vibration.transmission_torque_sum[at]),
        power_loss=float(vibration.power_loss[at]),
    )

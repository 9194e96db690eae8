"""The orders of an engine's torque, and which of them survive.

An order is the number of periods per turn of the crankshaft; a four-stroke engine has
half orders too. One cylinder gives all of them; summed over cylinders that fire at
angles theta_c, phasors of order i turned by exp(-j i theta_c), most cancel.

Sources
-------
[1] Den Hartog, Mechanical Vibrations, 4th edition, McGraw-Hill 1956, chapter 5:
    torque analysis by harmonics, and the star of their phases.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from coupling_design.arithmetic import FloatArray
from coupling_design.engine.parameters import Engine
from coupling_design.engine.pressure import cycle_angles
from coupling_design.engine.torque import cylinder_torque

ComplexArray = NDArray[np.complex128]


_ROUNDING = 1e-10  # of the largest order of all cylinders in step


@dataclass(frozen=True)
class TorqueOrder:
    """One harmonic: amplitude [N m] times sin(order x crank angle + phase [rad])."""

    order: float
    amplitude: float
    phase: float


@dataclass(frozen=True)
class OrderRow:
    """One order of the engine beside what its cylinders would give in step.

    `in_step_amplitude` [N m] is the sum of the cylinders' amplitudes, what is left
    if none cancelled; `survives` says whether the order is above the threshold.
    """

    order: float
    amplitude: float
    phase: float
    in_step_amplitude: float
    survives: bool


def engine_orders(
    engine: Engine, highest_order: float, threshold: float = 0.01
) -> tuple[TorqueOrder, ...]:
    """Return the surviving orders, lowest first.

    T(theta) = mean + sum of amplitude sin(order theta + phase). An order survives if
    its amplitude exceeds `threshold` times that of the engine's largest order, which
    may itself lie above `highest_order`. Amplitudes are in [N m], phases in [rad].
    """
    return tuple(
        TorqueOrder(row.order, row.amplitude, row.phase)
        for row in list_orders(engine, highest_order, threshold)
        if row.survives
    )


def list_orders(
    engine: Engine, highest_order: float, threshold: float = 0.01
) -> tuple[OrderRow, ...]:
    """Return every order up to the highest, those that cancel too.

    A row for each 1 / turns, lowest first; `threshold` is that of `engine_orders` [-].
    """
    phasors, in_step = _phasors(engine)
    amplitudes = np.abs(phasors)
    # What cancels leaves rounding of what does not: that is no order, however low
    # the threshold.
    limit = max(threshold * amplitudes.max(), _ROUNDING * in_step.max())
    turns = engine.cycle.turns
    count = min(int(highest_order * turns + 1e-9), len(phasors))
    return tuple(
        OrderRow(
            order=(k + 1) / turns,
            amplitude=float(amplitudes[k]),
            phase=float(np.angle(phasors[k])),
            in_step_amplitude=float(in_step[k]),
            survives=bool(amplitudes[k] > limit),
        )
        for k in range(count)
    )


def cylinder_phasors(engine: Engine, fires: bool) -> ComplexArray:
    """Return amplitude exp(j phase) of one cylinder's orders, mean left out [N m].

    Of n cycle angles (n / 2 - 1,); element k - 1 is the order k / turns. With c_k the
    complex Fourier coefficient, 2 Re(c_k e^{jx}) = A sin(x + phase) gives A e^{j phase}
    = 2 j c_k.
    """
    torque = cylinder_torque(cycle_angles(engine.cycle), engine, fires)
    coefficients = np.fft.rfft(torque) / len(torque)
    phasors: ComplexArray = 2j * coefficients[1:-1]
    return phasors


def _phasors(engine: Engine) -> tuple[ComplexArray, FloatArray]:
    """Return the engine's phasors, and the sum of its cylinders' amplitudes [N m]."""
    kinds = {fires: cylinder_phasors(engine, fires) for fires in (True, False)}
    orders = np.arange(1, len(kinds[True]) + 1) / engine.cycle.turns
    total = np.zeros_like(kinds[True])
    in_step = np.zeros_like(orders)
    for index, firing in enumerate(engine.firing_angles):
        own = kinds[index not in engine.misfiring]
        total = total + own * np.exp(-1j * orders * firing)
        in_step = in_step + np.abs(own)
    return total, in_step

"""Pressure in a cylinder over its cycle: motored, fired, or as measured.

The cycle angle [rad] counts from firing top dead centre and may be any number. The
closed part is idealised as the two whole strokes around it; on the others, if there
are any, the gas is at intake pressure, so that gas exchange does no work.

Fired, the motored pressure is raised in proportion to the fraction burnt [1],

    p = p_motored (1 + rise x_b),

and the one number `rise` is what reaches the indicated mean pressure: a synthetic
trace, right in its work, plausible in its shape.

Sources
-------
[1] Matekunas, Modes and measures of cyclic combustion variability, SAE 830337, 1983:
    fired over motored pressure, less one, follows the mass fraction burnt.
[2] Heywood, Internal Combustion Engine Fundamentals, McGraw-Hill 1988: sections 2.3,
    2.7 and 9.2.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from coupling_design.arithmetic import FloatArray
from coupling_design.engine.crank import cylinder_volume, piston_lever
from coupling_design.engine.parameters import (
    Charge,
    Cycle,
    Cylinder,
    Engine,
    IndicatedCombustion,
    PressureTrace,
)

# Wiebe's efficiency parameter: 99.9 % are burnt after the duration, 1 - exp(-a).
BURNT_AFTER_DURATION = -math.log(1e-3)
SAMPLES_PER_TURN = 3600


def cycle_angles(cycle: Cycle) -> FloatArray:
    """Return equally spaced cycle angles from 0 to the cycle's end, 0.1 degrees apart.

    They are (turns SAMPLES_PER_TURN,) [rad]. Sums over them integrate periodic
    functions: trapezoidal rule without its ends.
    """
    samples = SAMPLES_PER_TURN * cycle.turns
    return np.arange(samples, dtype=np.float64) * (cycle.angle / samples)


def motored_pressure(
    angle: FloatArray, cylinder: Cylinder, charge: Charge, cycle: Cycle
) -> FloatArray:
    """Return the pressure without combustion [Pa].

    Polytropic: p V^n is constant in compression and in expansion ([2] section 2.3
    measures n so), each with its exponent. It is of the shape of `angle`.
    """
    phi = _from_firing(angle, cycle)
    p0 = charge.intake_pressure
    V = cylinder_volume(phi, cylinder)
    V_c = cylinder.clearance_volume
    r_c = cylinder.compression_ratio
    compressed = p0 * (r_c * V_c / V) ** charge.compression_exponent
    top = p0 * r_c**charge.compression_exponent
    expanded = top * (V_c / V) ** charge.expansion_exponent
    closed = np.where(phi < 0, compressed, expanded)
    return np.where(_is_closed(phi, cycle), closed, p0)


def burnt_fraction(
    angle: FloatArray, combustion: IndicatedCombustion, cycle: Cycle
) -> FloatArray:
    """Return the fraction of the fuel burnt [-], Wiebe's function, [2] eq. (9.30).

    x_b = 1 - exp(-a ((theta - theta_0) / duration)^(m + 1)) in the closed part, of the
    shape of `angle`.
    """
    phi = _from_firing(angle, cycle)
    a, m = BURNT_AFTER_DURATION, combustion.shape
    progress = np.maximum((phi - combustion.start) / combustion.duration, 0.0)
    burnt = 1 - np.exp(-a * progress ** (m + 1))
    return np.where(_is_closed(phi, cycle), burnt, 0.0)


def pressure_rise(engine: Engine, combustion: IndicatedCombustion) -> float:
    """Return fired over motored pressure, less one, when all is burnt [-].

    The work of a cycle is linear in it: [2] eq. (2.14), W = closed integral of p dV,
    equals the mean pressure times the displacement.
    """
    angles = cycle_angles(engine.cycle)
    motored = motored_pressure(angles, engine.cylinder, engine.charge, engine.cycle)
    burnt = burnt_fraction(angles, combustion, engine.cycle)
    wanted = combustion.mean_pressure - mean_pressure(motored, engine)
    return wanted / mean_pressure(motored * burnt, engine)


def mean_pressure(pressures: FloatArray, engine: Engine) -> float:
    """Return the indicated mean pressure [Pa] of pressures at the `cycle_angles`.

    The pressures are (n_angles,) [Pa], the mean is one number.
    """
    angles = cycle_angles(engine.cycle)
    lever = piston_lever(angles, engine.cylinder)
    step = engine.cycle.angle / len(angles)
    return float(np.sum(pressures * lever) * step / engine.cylinder.stroke)


def cylinder_pressure(angle: FloatArray, engine: Engine, fires: bool) -> FloatArray:
    """Return the pressure in a cylinder that fires, or is motored [Pa].

    It is of the shape of `angle`.
    """
    match engine.combustion if fires else None:
        case PressureTrace(angles, pressures):
            turn = engine.cycle.angle
            return np.interp(angle, angles, pressures, period=turn)
        case IndicatedCombustion() as combustion:
            burnt = burnt_fraction(angle, combustion, engine.cycle)
            factor = 1 + pressure_rise(engine, combustion) * burnt
        case None:
            factor = np.ones_like(angle, dtype=np.float64)
    motored = motored_pressure(angle, engine.cylinder, engine.charge, engine.cycle)
    return np.asarray(motored * factor)


def _from_firing(angle: FloatArray, cycle: Cycle) -> FloatArray:
    """Return the angle brought to within half a cycle of firing dead centre."""
    half = cycle.angle / 2
    return (np.asarray(angle) + half) % cycle.angle - half


def _is_closed(phi: FloatArray, cycle: Cycle) -> NDArray[np.bool_]:
    return np.abs(phi) <= (math.pi if cycle is Cycle.FOUR_STROKE else math.inf)

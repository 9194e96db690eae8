"""The shipped 16V280 set on its way through resonance, where its key rattles.

Its run-downs start turning evenly: a start that every program can be given.
"""

import dataclasses
import functools

import casadi as ca
import numpy as np

from coupling_design.events.recording import simulate
from coupling_design.line.even_start import quasi_steady_state
from coupling_design.line.modes import natural_angular_frequency
from coupling_design.line.parameters import QuasiSteadyStart
from coupling_design.signals.resonance import largest_swing
from tests.verification.drivelines import shipped_case
from tests.verification.integration import rate_function, rk4


def evenly(shutdown):
    """Return one run-down, from even turning at crank angle 0."""
    return dataclasses.replace(shutdown, start=QuasiSteadyStart(), crank_angles=1)


def start_of(driveline, speed):
    """Return the quasi-steady start of a driveline at a speed [rad/s]."""
    return np.asarray(ca.DM(quasi_steady_state(driveline, speed))).ravel()


@functools.cache
def resonance():
    """Return the largest swing of the shipped case's run-down."""
    driveline, shutdown = shipped_case().driveline, evenly(shipped_case().shutdown)
    history = simulate(driveline, shutdown)
    return largest_swing(history, natural_angular_frequency(driveline))


@functools.cache
def state_before_resonance(lead):
    """Return the shipped driveline's state `lead` seconds before its largest swing."""
    driveline, shutdown = shipped_case().driveline, shipped_case().shutdown
    steps = round((resonance().time - lead) / shutdown.time_step)
    start = start_of(driveline, shutdown.initial_speed)
    return rk4(rate_function(driveline), start, shutdown.time_step, steps)


def impacts(twists, half_gap):
    """Return how often a key crosses its gap, and the share of time it is inside."""
    flank = np.sign(twists[np.abs(twists) >= half_gap])
    inside = float(np.mean(np.abs(twists) < half_gap))
    return int(np.count_nonzero(np.diff(flank))), inside

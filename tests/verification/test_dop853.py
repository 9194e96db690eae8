"""RK4 with the case's step beside DOP853 at 1e-12, on the same smoothed equations.

Sources
-------
[1] Hairer, Norsett, Wanner (1993), Solving Ordinary Differential Equations I, II.5:
    DOP853, with a relative tolerance of 1e-12.
[2] What the case promises: half the time step moves its damage by less than 0.1 %.
[3] Advances in Mechanical Engineering 2023, doi 10.1177/16878132231190062: model and
    test of the 16V280 set differ by 0.66 % at resonance. A solver must add less.

Damage is a sum over steps in the code and an integral here. The peak is the largest at
a step in the code and the largest at any time here: of a key that swings at omega_c,
steps h apart may miss 1 - cos(omega_c h / 2).
"""

import dataclasses
import math

import casadi as ca
import numpy as np
import pytest

from coupling_design.events.recording import simulate
from coupling_design.line.contact import half_gap_angle
from coupling_design.line.modes import modes
from coupling_design.line.motion import motion
from coupling_design.line.parameters import Shutdown
from coupling_design.parts.bearing.damage import damage_increment
from coupling_design.parts.bearing.loads import (
    combined_load,
    rotational_loads,
    static_loads,
)
from tests.verification.comparison import Comparison, collect, disagreements
from tests.verification.drivelines import (
    evaluator,
    high_stiffness_candidate,
    present_candidate,
    shipped_case,
)
from tests.verification.integration import dop853, rate_function, state_symbol
from tests.verification.resonance import evenly, impacts, resonance, start_of

WINDOW = 2.0  # through the resonance [s]
SPEED_BEFORE = 1.3  # of the speed of the largest swing
PROMISE = 1e-3  # [2]
MODEL_AGAINST_TEST = 0.0066  # [3]
HIGH_STIFFNESS = 192.75e6  # two masses at sqrt 2 times 133.33 Hz [N m/rad]


def damage_rates(_, now):
    """Return both bearings' damage per second, eqs. (4) to (14)."""
    case = shipped_case()
    forces = rotational_loads(now.transmission_force, case.shaft)
    weights = static_loads(case.shaft)
    return ca.vertcat(
        *(
            damage_increment(
                combined_load(force, weight, now.generator_angle),
                now.generator_speed,
                1.0,
                bearing,
                case.lubrication,
                case.reliability,
            )
            for force, weight, bearing in zip(
                forces, weights, case.bearings, strict=True
            )
        )
    )


@dataclasses.dataclass(frozen=True)
class RunDown:
    """What becomes of a run-down, by either solver.

    `damages` of both bearings, `peak` of the transmission force [N] and
    `coupling_torque` at the times asked for [N m].
    """

    damages: tuple[float, float]
    peak: float
    coupling_torque: np.ndarray
    states: np.ndarray | None = None


def signals(driveline, states):
    """Return transmission force [N] and coupling torque [N m] at states, (2, n)."""
    state = state_symbol(driveline)
    now = motion(driveline, state)
    both = ca.vertcat(now.transmission_force, now.coupling_torque)
    function = ca.Function("signals", [state], [both])
    return np.asarray(function.map(states.shape[1])(states))


def by_dop853(driveline, shutdown, sampling):
    """Return a run-down by [1], sampled evenly and finely about its largest forces."""
    times = np.arange(0.0, shutdown.duration + sampling / 2, sampling)
    start = [*start_of(driveline, shutdown.initial_speed), 0.0, 0.0]
    states = dop853(rate_function(driveline, damage_rates), start, times)
    motion_states, damages = states[:-2], states[-2:, -1]
    force, torque = signals(driveline, motion_states)
    rate, fine = rate_function(driveline), np.linspace(0.0, 2 * sampling, 41)
    peak = np.abs(force).max()
    for i in largest_maxima(np.abs(force)):
        about = dop853(rate, motion_states[:, i - 1], fine)
        peak = max(peak, np.abs(signals(driveline, about)[0]).max())
    return RunDown(tuple(damages), float(peak), torque[:-1], motion_states)


def largest_maxima(values, count=20):
    """Return where the largest of the local maxima inside a signal are."""
    inner = values[1:-1]
    at = 1 + np.flatnonzero((inner >= values[:-2]) & (inner >= values[2:]))
    return at[np.argsort(values[at])[-count:]]


def by_our_march(candidate, point, shutdown):
    """Return the same run-down as the design flow and the time histories have it."""
    our_evaluator = evaluator(candidate, **vars(shutdown))
    performance = our_evaluator.performance(*point)
    history = simulate(our_evaluator.driveline(*point), shutdown)
    return RunDown(
        performance.damages,
        performance.peak_transmission_force,
        history.coupling_torque,
    )


def compared(where, candidate, point, shutdown, sampling, refinements=(1,)):
    """Return damages, peak and trajectory of a run-down beside those by [1]."""
    driveline = evaluator(candidate).driveline(*point)
    theirs = by_dop853(driveline, shutdown, sampling)
    found = []
    for refinement in refinements:
        step = shutdown.time_step / refinement
        finer = dataclasses.replace(shutdown, time_step=step)
        ours = by_our_march(candidate, point, finer)
        stride = round(sampling / step)
        found += rows(
            f"{where}, step {step:g} s", driveline, ours, theirs, step, stride
        )
    return found


def rows(where, driveline, ours, theirs, step, stride):
    closeness = 1e-2 if step < shipped_case().shutdown.time_step else 1.0
    missed = 1 - math.cos(modes(driveline).angular_frequencies[-1] * step / 2)
    largest = np.abs(theirs.coupling_torque).max()
    apart = np.abs(ours.coupling_torque[::stride] - theirs.coupling_torque).max()
    source = "DOP853, tolerance 1e-12"
    return [
        *(
            Comparison(
                f"damage of bearing {number}, {where}",
                source,
                float(published),
                float(value),
                "-",
                closeness * PROMISE * float(published),
                f"{value / published - 1:+.2e} of it",
            )
            for number, published, value in zip(
                (1, 2), theirs.damages, ours.damages, strict=True
            )
        ),
        Comparison(
            f"peak transmission force, {where}",
            source,
            theirs.peak,
            float(ours.peak),
            "N",
            missed * theirs.peak,
            f"{ours.peak / theirs.peak - 1:+.2%} of it; between two steps "
            f"{missed:.2%} of the key's swing may be missed",
        ),
        Comparison(
            f"largest difference of the coupling torque, {where}, to the largest",
            source,
            0.0,
            float(apart / largest),
            "-",
            closeness * MODEL_AGAINST_TEST,
            "tolerance: what the paper's model and test differ by"
            if closeness == 1
            else "",
        ),
    ]


def present_point():
    """Return stiffness and gap of the shipped case as built."""
    driveline = shipped_case().driveline
    return driveline.coupling.torsional_stiffness, driveline.connection.gap


def through_resonance():
    """Compare 2 s through the resonance, at the case's step and at a tenth of it."""
    step = shipped_case().shutdown.time_step
    shutdown = evenly(Shutdown(SPEED_BEFORE * resonance().speed, WINDOW, step))
    where = f"present coupling and gap, {WINDOW:g} s through resonance"
    candidate = present_candidate(shipped_case())
    return compared(where, candidate, present_point(), shutdown, step, (1, 10))


def high_stiffness_run_down():
    """Compare the whole run-down of the coupling of step 4, tightly fitted."""
    case = shipped_case()
    candidate = high_stiffness_candidate(case)
    shutdown = evenly(case.shutdown)
    point = (HIGH_STIFFNESS, 0.0)
    where = "high-stiffness coupling, tight fit, whole run-down"
    return compared(where, candidate, point, shutdown, 5 * shutdown.time_step)


def present_run_down():
    """Compare the whole run-down of the set as built."""
    case = shipped_case()
    candidate = present_candidate(case)
    step = case.shutdown.time_step
    where = "present coupling and gap, whole run-down"
    shutdown = evenly(case.shutdown)
    return compared(where, candidate, present_point(), shutdown, step)


GROUPS = (through_resonance, high_stiffness_run_down)
SLOW_GROUPS = (present_run_down,)


def comparisons():
    """Return what this module compares, the slow ones too."""
    return collect(GROUPS + SLOW_GROUPS)


@pytest.mark.parametrize(
    "group",
    [*GROUPS, *(pytest.param(group, marks=pytest.mark.slow) for group in SLOW_GROUPS)],
)
def test_agrees_with_its_source(group):
    assert disagreements(group) == []


def test_the_key_rattles_in_the_window():
    """The comparison is worth little if the key does not cross its gap."""
    driveline = shipped_case().driveline
    shutdown = Shutdown(SPEED_BEFORE * resonance().speed, WINDOW, 1e-4)
    states = by_dop853(driveline, shutdown, 1e-3).states

    half_gap = half_gap_angle(driveline.connection)
    crossings, inside = impacts(states[1] - states[2], half_gap)
    assert crossings >= 4
    assert inside > 0.05

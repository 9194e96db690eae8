"""The settled vibration that a run-down starts from, beside other ways to find it.

Sources
-------
[1] Hairer, Norsett, Wanner (1993), Solving Ordinary Differential Equations I, II.5:
    DOP853, here with a relative tolerance of 1e-11, on the held line's equations as
    they are written out below, from rest twist until they repeat.
[2] The linear forced response about the mean torque, of a joint that stays closed.
[3] Even turning, the start without any vibration, to which it comes without orders.
[4] Central differences of the settled state, extrapolated from two steps: as precise as
    1e-6 of themselves, what the two differ by, and what a state closes to by the step.

The held line: J_i w_i' = torques + J_i dec with dec = (all resistances at omega0) /
(sum of J), the orders at the crank's mean position, which turns at omega0. Turning the
line as a whole changes nothing, and its mean speed settles within minutes only; so
what is compared is what its joints carry, in shares of their mean.
"""

import dataclasses
import functools
import math

import casadi as ca
import numpy as np
import pytest

from coupling_design.case import load_case
from coupling_design.events.held_line import HeldLine
from coupling_design.events.lift_off import LiftOff
from coupling_design.events.periodic_orbit import PeriodicOrbit
from coupling_design.events.settled_state import period_of, settled_state
from coupling_design.events.start import StartingStates
from coupling_design.line.even_start import quasi_steady_state
from coupling_design.line.parameters import LossFactorDamping, TightFit
from coupling_design.march.fastest import fastest_marcher
from tests.verification.comparison import Comparison, collect, disagreements
from tests.verification.drivelines import CASE_FILE, shipped_case

CLOSE = 1e-6  # of the mean torque
PROMISE = 1e-3  # of what the case's step may be off by
ANGLES = 16
NONE = ca.SX.sym("none", 0)
NO_VALUES = np.empty(0)
MARINE_FILE = CASE_FILE.with_name("8l_marine.yaml")


def louder(driveline, factor):
    """Return the driveline with its orders' amplitudes times a factor."""
    orders = tuple(
        dataclasses.replace(order, amplitude=factor * order.amplitude)
        for order in driveline.excitation
    )
    return dataclasses.replace(driveline, excitation=orders)


@functools.cache
def opening_line():
    """Return the marine set driven so hard that its key lifts off, and still settles.

    A tenth harder the vibration is chaotic: nothing to compare.
    """
    driveline = load_case(MARINE_FILE).driveline
    law = LossFactorDamping(0.9 / (2 * math.pi))  # its psi of 0.9, as eta
    coupling = dataclasses.replace(driveline.coupling, damping_law=law)
    return louder(dataclasses.replace(driveline, coupling=coupling), 27.0)


def shutdown_of_the_shipped_case():
    return shipped_case().shutdown


# ---------------------------------------------------------------------------
# The held line in other hands


class Held:
    """The keyed line's equations, typed a second time, for numbers."""

    def __init__(self, driveline, speed):
        d, key, law = driveline, driveline.connection, driveline.coupling.damping_law
        self.J = d.engine_inertia, d.coupling_inertia, d.generator_inertia
        self.k = d.coupling.torsional_stiffness
        if isinstance(law, LossFactorDamping):
            reduced = self.J[0] * (self.J[1] + self.J[2]) / sum(self.J)
            self.c = law.loss_factor * math.sqrt(self.k * reduced)
        else:
            self.c = law.damping_factor * self.k / law.characteristic_frequency
        self.kg, self.cg = key.contact_stiffness, key.oil_damping
        self.b, self.s = key.gap / (2 * key.radius), key.smoothing * key.radius
        self.ends = d.engine_resistance, d.generator_resistance
        self.orders = [(o.order, o.amplitude, o.phase) for o in d.excitation]
        self.speed = speed
        self.dec = sum(self.brake(end, speed) for end in self.ends) / sum(self.J)
        # What passes each joint on average, and the twist at which it does.
        self.key_torque = self.brake(self.ends[1], speed) - self.J[2] * self.dec
        self.torque = self.key_torque - self.J[1] * self.dec
        self.theta_mean = self.torque / self.k + self.key_twist()

    @staticmethod
    def brake(end, speed):
        dry = end.friction * math.tanh(speed / end.transition_speed)
        return end.viscous * speed + dry

    def pressed(self, x):
        b, s = self.b, self.s
        right, left = math.tanh(s * (x - b)), math.tanh(s * (x + b))
        return x + 0.5 * ((x - b) * right - (x + b) * left)

    def key_twist(self):
        from scipy.optimize import brentq

        flank = self.b * math.copysign(1.0, self.key_torque)
        far = flank + 2 * self.key_torque / self.kg
        return brentq(
            lambda x: self.kg * self.pressed(x) - self.key_torque,
            flank,
            far,
            xtol=1e-16,
        )

    def rate(self, t, y):
        a1, a2, a3, w1, w2, w3 = y
        theta = self.theta_mean + self.speed * t
        drive = sum(T * math.sin(i * theta + phase) for i, T, phase in self.orders)
        joint = self.k * (a1 - a2) + self.c * (w1 - w2)
        key = self.kg * self.pressed(a2 - a3) + self.cg * (w2 - w3)
        J1, J2, J3 = self.J
        return [
            w1,
            w2,
            w3,
            (drive - self.brake(self.ends[0], w1) - joint) / J1 + self.dec,
            (joint - key) / J2 + self.dec,
            (key - self.brake(self.ends[1], w3)) / J3 + self.dec,
        ]

    def rest(self):
        """Return rest twist, at the speed whose mean the orders make omega0."""
        x = self.key_twist()
        ahead = sum(
            T * math.cos(i * self.theta_mean + phase) / (i * self.speed)
            for i, T, phase in self.orders
        )
        w = self.speed - ahead / sum(self.J)
        return [self.torque / self.k + x, x, 0.0, w, w, w]

    def torques(self, states):
        """Return what coupling and key carry at states (6, n), to their means."""
        a1, a2, a3, w1, w2, w3 = states
        joint = self.k * (a1 - a2) + self.c * (w1 - w2)
        pressed = np.array([self.pressed(x) for x in a2 - a3])
        key = self.kg * pressed + self.cg * (w2 - w3)
        return np.stack([joint / self.torque, key / self.key_torque])

    def settled(self, seconds, angles, period):
        """Return the states at evenly spread crank angles once they repeat, by [1]."""
        from scipy.integrate import ode

        solver = ode(self.rate)
        # A longer step is taken for stiffness where the key hardly swings any more.
        longest = 1 / math.sqrt(self.kg / self.J[1])
        solver.set_integrator(
            "dop853", rtol=1e-11, atol=1e-14, nsteps=10**8, max_step=longest
        )
        solver.set_initial_value(self.rest(), 0.0)
        turns = math.ceil(seconds * self.speed / period)
        states = []
        for i in range(angles):
            states.append(solver.integrate((turns + i / angles) * period / self.speed))
            assert solver.successful()
        return np.stack(states, axis=1)


def orbit_of(driveline, shutdown):
    """Return our settled vibration at ANGLES crank angles, marched until periodic."""
    held = HeldLine(driveline, shutdown, NONE, 0)
    period = period_of(driveline.excitation)
    orbit = PeriodicOrbit(held, period, shutdown.initial_speed)
    return orbit.settle(NO_VALUES, ANGLES, with_slopes=False)


def linear_states(driveline, shutdown):
    """Return the same by [2]."""
    period = period_of(driveline.excitation)
    angles = period * np.arange(ANGLES) / ANGLES
    return np.hstack(
        [
            np.asarray(ca.DM(settled_state(driveline, shutdown.initial_speed, angle)))
            for angle in angles
        ]
    )


def far_apart(what, source, driveline, shutdown, ours, theirs, tolerance=CLOSE):
    """Return by how much the joints' torques differ, coupling then key."""
    held = Held(driveline, shutdown.initial_speed)
    apart = np.abs(held.torques(ours) - held.torques(theirs)).max(axis=1)
    return [
        Comparison(
            f"largest difference of the {joint} torque, {what}, to its mean",
            source,
            0.0,
            float(value),
            "-",
            tolerance,
        )
        for joint, value in zip(("coupling", "key"), apart, strict=True)
    ]


def closed_joint_in_other_hands():
    """The present coupling of the shipped case, its key on its flank all the time."""
    driveline, shutdown = shipped_case().driveline, shutdown_of_the_shipped_case()
    held = Held(driveline, shutdown.initial_speed)
    theirs = held.settled(5.0, ANGLES, period_of(driveline.excitation))
    return far_apart(
        "present coupling, settled",
        "DOP853, tolerance 1e-11, 5 s from rest twist",
        driveline,
        shutdown,
        linear_states(driveline, shutdown),
        theirs,
    )


def open_gap_in_other_hands():
    """A key that lifts off its flank each period; our own step, and a tenth of it."""
    driveline, shutdown = opening_line(), shutdown_of_the_shipped_case()
    held = Held(driveline, shutdown.initial_speed)
    theirs = held.settled(8.0, ANGLES, period_of(driveline.excitation))
    found = []
    for time_step, tolerance in ((1e-4, PROMISE), (1e-5, CLOSE)):
        finer = dataclasses.replace(shutdown, time_step=time_step)
        found += far_apart(
            f"a key that lifts off, settled, step {time_step:g} s",
            "DOP853, tolerance 1e-11, 8 s from rest twist",
            driveline,
            shutdown,
            orbit_of(driveline, finer).states,
            theirs,
            tolerance,
        )
    return found


def marched_beside_linear():
    """The present coupling: shooting, and 200 periods marched, beside [2]."""
    driveline, shutdown = shipped_case().driveline, shutdown_of_the_shipped_case()
    linear = linear_states(driveline, shutdown)
    return [
        *far_apart(
            "present coupling, periodic orbit",
            "linear forced response",
            driveline,
            shutdown,
            orbit_of(driveline, shutdown).states,
            linear,
        ),
        *far_apart(
            "present coupling, marched for 300 periods from rest twist",
            "linear forced response",
            driveline,
            shutdown,
            marched(driveline, shutdown, 300),
            linear[:, :1],
        ),
    ]


def marched(driveline, shutdown, periods):
    """Return the held line's state (6, 1) after so many periods of our own steps."""
    held, speed = Held(driveline, shutdown.initial_speed), shutdown.initial_speed
    step, steps = HeldLine(driveline, shutdown, NONE, 0).step(
        period_of(driveline.excitation), speed
    )
    march = fastest_marcher(step, periods * steps)
    start = np.array([*held.rest(), held.theta_mean])[:, np.newaxis]
    return march(start, np.zeros((6, 1)), 1)[:6]


GROUPS = (closed_joint_in_other_hands, open_gap_in_other_hands, marched_beside_linear)


def comparisons():
    """Return what this module compares."""
    return collect(GROUPS)


@pytest.mark.parametrize("group", GROUPS)
def test_agrees_with_its_source(group):
    assert disagreements(group) == []


def test_the_key_lifts_off():
    """Else the comparison with an open gap would be that with a closed one."""
    driveline, shutdown = opening_line(), shutdown_of_the_shipped_case()
    ours = orbit_of(driveline, shutdown)
    b = driveline.connection.gap / (2 * driveline.connection.radius)
    twists = ours.states[1] - ours.states[2]
    assert ours.repeats
    assert LiftOff(driveline, shutdown, NONE).happens(NO_VALUES)
    assert np.abs(twists).min() < b < np.abs(twists).max()


def test_the_linear_answer_is_another_where_the_gap_opens():
    driveline, shutdown = opening_line(), shutdown_of_the_shipped_case()
    ours = orbit_of(driveline, shutdown)
    linear = linear_states(driveline, shutdown)
    rows = far_apart("", "", driveline, shutdown, ours.states, linear)
    assert max(row.ours for row in rows) > 1e-2


@pytest.mark.parametrize("kind", ["key", "tight"])
def test_without_orders_it_is_even_turning(kind):
    """[3], to 1e-12."""
    driveline = louder(shipped_case().driveline, 0.0)
    if kind == "tight":
        driveline = dataclasses.replace(driveline, connection=TightFit(radius=0.1))
    speed = shipped_case().shutdown.initial_speed
    settled = np.asarray(ca.DM(settled_state(driveline, speed))).ravel()
    evenly = np.asarray(ca.DM(quasi_steady_state(driveline, speed))).ravel()
    assert settled == pytest.approx(evenly, rel=1e-12, abs=1e-12)


# ---------------------------------------------------------------------------
# How the start moves with stiffness and gap


def starting(driveline, shutdown):
    """Return what finds the starts at (stiffness, gap), and the point itself."""
    p = ca.SX.sym("p", 2)
    line = dataclasses.replace(
        driveline,
        coupling=dataclasses.replace(driveline.coupling, torsional_stiffness=p[0]),
        connection=dataclasses.replace(driveline.connection, gap=p[1]),
    )
    point = np.array([driveline.coupling.torsional_stiffness, driveline.connection.gap])
    return StartingStates(line, shutdown, p, 2, shutdown.initial_speed), point


@pytest.mark.parametrize("opens", [False, True], ids=["closed", "open"])
@pytest.mark.parametrize("variable", [0, 1], ids=["stiffness", "gap"])
def test_slopes_are_those_of_differences(opens, variable):
    """[4]; turned as a whole the line is the same, so angles are taken to the last."""
    driveline = opening_line() if opens else shipped_case().driveline
    shutdown = shutdown_of_the_shipped_case()
    starts, point = starting(driveline, shutdown)

    def twists(states):
        return np.concatenate([states[:2] - states[2], states[3:]])

    def at(share):
        moved = point.copy()
        moved[variable] *= 1 + share
        return twists(starts(moved[:, np.newaxis], 1).states[:, 0])

    def central(share):
        return (at(share) - at(-share)) / (2 * share)

    step = 1e-4
    rounding = 1e-11 / step  # that near an orbit closes, angles by 1, speeds by omega0

    ours = starts(point[:, np.newaxis], 1, with_slopes=True).slopes[0, :, variable]
    ours = twists(ours) * point[variable]
    fine, coarse = central(step / 2), central(step)
    expected, doubts = fine + (fine - coarse) / 3, np.abs(fine - coarse) / 3
    for part, unit in ((slice(2), 1.0), (slice(2, None), shutdown.initial_speed)):
        largest, doubt = np.abs(expected[part]).max(), doubts[part].max()
        assert doubt < 1e-3 * largest
        allowed = 1e-6 * largest + doubt + rounding * unit
        assert np.abs(ours[part] - expected[part]).max() < allowed

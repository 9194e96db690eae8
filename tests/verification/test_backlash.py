"""An inertia that bounces in a backlash: sharp, and as our smoothed contact has it.

Sources
-------
[1] Modelica.Mechanics.Rotational.Examples.Backlash: J = 5 kg m^2 against ground,
    c = 20 000 N m/rad, d = 50 N m s/rad, backlash pi/4 in all, from phi = pi/2 at rest.
    Its ElastoBacklash never pulls: beyond the gap tau = tau_c + min(tau_c, tau_d), and
    zero where that would change sign.
[2] The same solved exactly from event to event, to the ten digits typed in below.
[3] Reference trajectory Backlash.csv, modelica/MAP-LIB_ReferenceResults (Dymola 2020x,
    DASSL with a tolerance of 1e-6).
[4] Kim, Rook, Singh (2005), Effect of smoothening functions on the frequency response
    of an oscillator with clearance non-linearity, J. Sound Vib. 281.

Our contact pulls, and its damping acts inside the gap too (oil). So the sharp
trajectory of [1] checks our solver of sharp laws, and that solver, with our law, is
what the smoothed contact must converge to.
"""

import functools
import math
from itertools import pairwise

import numpy as np
import pytest

from coupling_design.line.parameters import (
    Coupling,
    Driveline,
    KeyedConnection,
    ProportionalDamping,
)
from tests.verification.comparison import Comparison, collect, disagreements
from tests.verification.drivelines import NONE, shipped_case
from tests.verification.integration import dop853, rate_function, rk4

J, C, D = 5.0, 20_000.0, 50.0
HALF_GAP = math.pi / 8
START = (math.pi / 2, 0.0)

# fmt: off
EVENTS = (
    # event                     time [s]       phi [rad]     speed [rad/s]   of [2]
    ("torque clamps to zero",   0.0236592158,  0.558190627, -66.1966180),
    ("leaves +b/2",             0.0261592158,  0.392699082, -66.1966180),
    ("hits -b/2",               0.0380238426, -0.392699082, -66.1966180),
    ("clamps on the other side", 0.0853523395, -0.524933378, 52.8937186),
    ("leaves -b/2",             0.0878523395, -0.392699082,  52.8937186),
    ("hits +b/2",               0.1027009488,  0.392699082,  52.8937186),
)
NEXT_IMPACT_SPEEDS = (-42.2641753, 33.7707494, -26.9841658, 21.5614168)
STATES = (
    # time [s]  phi [rad]   speed [rad/s]   of [2]
    (0.05, -1.07836737, -42.5650553),
    (0.1,   0.24983586,  52.89371861),
    (0.2,  -0.96183607,  12.00252966),
    (0.5,  -0.30995804, -17.22842571),
    (1.0,  -0.15558141,  -7.02293728),
)
DYMOLA_STATES = (
    # of [3]
    (0.05, -1.07836433, -42.5653991),
    (1.0,  -0.15557037,  -7.02293040),
)
# fmt: on
SPEED_RATIO = 0.79904  # of two successive impacts, [2]


# Sharp laws, solved from event to event


def spring(y):
    """Return tau_c, the contact's elastic torque at either flank."""
    return C * math.copysign(max(abs(y[0]) - HALF_GAP, 0.0), y[0])


def sided(y):
    """Return elastic and damping torque, positive where they push the inertia off."""
    side = math.copysign(1.0, y[0])
    return side * spring(y), side * D * y[1]


def at_the_edge(_, y):
    return abs(y[0]) - HALF_GAP


def stops_pushing(_, y):
    return sum(sided(y))


def damping_is_the_smaller(_, y):
    elastic, damping = sided(y)
    return damping - elastic


def torque_free(_):
    return 0.0


# What each phase of [1] exerts, and how it may end; events of a phase in that order.
NO_PULL = {
    "gap": (torque_free, {at_the_edge: ("meets", +1)}),
    "meets": (
        lambda y: 2 * spring(y),
        {damping_is_the_smaller: ("pushes", -1)},
    ),
    "pushes": (
        lambda y: spring(y) + D * y[1],
        {stops_pushing: ("clamped", -1)},
    ),
    "clamped": (torque_free, {at_the_edge: ("gap", -1)}),
}
# Our law: the damper is always there, and the flank pulls while the spring is pressed.
WITH_PULL = {
    "gap": (lambda y: D * y[1], {at_the_edge: ("pushes", +1)}),
    "pushes": (
        lambda y: spring(y) + D * y[1],
        {at_the_edge: ("gap", -1)},
    ),
}


@functools.cache
def sharp(law_name, end):
    """Return the events (phase that begins, time, state) and the solution's pieces."""
    from scipy.integrate import solve_ivp

    law = {"no pull": NO_PULL, "with pull": WITH_PULL}[law_name]
    phase, time, state = "pushes", 0.0, np.array(START)
    events, pieces = [], []
    while time < end:
        torque, ends = law[phase]
        (event, (next_phase, direction)) = next(iter(ends.items()))

        def terminal(t, y, event=event):
            return event(t, y)

        terminal.terminal, terminal.direction = True, direction
        solution = solve_ivp(
            lambda t, y, torque=torque: (y[1], -torque(y) / J),
            (time, end),
            state,
            "DOP853",
            dense_output=True,
            events=terminal,
            rtol=1e-13,
            atol=1e-14,
            max_step=1e-3,
        )
        pieces.append(solution)
        time, state = solution.t[-1], solution.y[:, -1]
        if solution.status == 1:
            phase = next_phase
            events.append((phase, time, state))
    return tuple(events), tuple(pieces)


def sharp_state(law_name, end, time):
    """Return the sharp law's state at a time."""
    _, pieces = sharp(law_name, end)
    piece = next(p for p in pieces if p.t[0] <= time <= p.t[-1])
    return piece.sol(time)


# The sharp law of [1] against [2] and [3]


def sharp_events():
    events, _ = sharp("no pull", 1.0)
    named = {"clamped": "clamps", "gap": "leaves", "meets": "hits"}
    ours = [event for event in events if event[0] in named]
    found = []
    for (name, *expected), (phase, time, state) in zip(
        EVENTS, ours[: len(EVENTS)], strict=True
    ):
        assert named[phase] in name
        for quantity, unit, published, value in zip(
            ("time", "angle", "speed"),
            ("s", "rad", "rad/s"),
            expected,
            (time, *state),
            strict=True,
        ):
            found.append(
                Comparison(
                    f"sharp backlash, {name}: {quantity}",
                    "Modelica backlash example, solved from event to event",
                    published,
                    float(value),
                    unit,
                    1e-7,
                    "solver of the sharp laws, without our contact",
                )
            )
    return found


def sharp_impacts():
    events, _ = sharp("no pull", 1.0)
    speeds = [state[1] for phase, _, state in events if phase == "meets"]
    clamps = [t for phase, t, _ in events if phase == "clamped"]
    leaves = [t for phase, t, _ in events if phase == "gap"]
    source = "Modelica backlash example, solved from event to event"
    return [
        *(
            Comparison(
                f"sharp backlash, speed of impact {number}",
                source,
                published,
                float(speed),
                "rad/s",
                1e-7,
            )
            for number, (published, speed) in enumerate(
                zip(NEXT_IMPACT_SPEEDS, speeds[2:6], strict=True), start=3
            )
        ),
        Comparison(
            "sharp backlash, ratio of two impact speeds, the one farthest from source",
            source,
            SPEED_RATIO,
            float(
                max(
                    (-b / a for a, b in pairwise(speeds)),
                    key=lambda ratio: abs(ratio - SPEED_RATIO),
                )
            ),
            "-",
            5e-6,
        ),
        Comparison(
            "sharp backlash, longest time without torque before the flanks part",
            "d / c, exact",
            D / C,
            max(b - a for a, b in zip(clamps, leaves, strict=False)),
            "s",
            1e-12,
        ),
    ]


def sharp_states():
    # DASSL keeps 1e-6 a step, not over a second: 1e-5 of the largest angle and speed.
    exact, dymola = (1e-7, 1e-7), (1e-5 * START[0], 1e-5 * 66.2)
    rows = [("solved from event to event", exact, *row) for row in STATES]
    rows += [("Dymola's trajectory", dymola, *row) for row in DYMOLA_STATES]
    found = []
    for source, tolerances, time, *expected in rows:
        state = sharp_state("no pull", 1.0, time)
        for quantity, unit, tolerance, published, value in zip(
            ("angle", "speed"), ("rad", "rad/s"), tolerances, expected, state,
            strict=True,
        ):  # fmt: skip
            found.append(
                Comparison(
                    f"sharp backlash, {quantity} at {time} s",
                    f"Modelica backlash example, {source}",
                    published,
                    float(value),
                    unit,
                    tolerance,
                    "solver of the sharp laws, without our contact",
                )
            )
    return found


# Our smoothed contact


def smoothed(sharpness, half_gap=HALF_GAP):
    """Return our driveline with its coupling inertia alone in the key's gap.

    No coupling holds it, the generator behind the key is as good as the ground; with
    a radius of 1 m, `sharpness` [1/rad] is the key's smoothing.
    """
    return Driveline(
        engine_inertia=1.0,
        coupling_inertia=J,
        generator_inertia=1e30,
        coupling=Coupling(0.0, ProportionalDamping(0.0, 1.0)),
        connection=KeyedConnection(
            radius=1.0,
            gap=2 * half_gap,
            contact_stiffness=C,
            oil_damping=D,
            smoothing=sharpness,
        ),
        excitation=(),
        engine_resistance=NONE,
        generator_resistance=NONE,
    )


KEYED_START = (0.0, START[0], 0.0, 0.0, START[1], 0.0)
ANGLE, SPEED = 1, 4  # of the coupling inertia, in the state
END = 0.2  # five impacts
SHARPNESSES = tuple(200.0 * 2**i for i in range(6))


@functools.cache
def smoothed_state(sharpness):
    """Return angle and speed at the end, by DOP853 on our equations."""
    rate = rate_function(smoothed(sharpness))
    states = dop853(rate, KEYED_START, (0.0, END), tolerance=1e-13)
    return states[[ANGLE, SPEED], -1]


@functools.cache
def smoothing_errors():
    """Return how far the smoothed contact is from the sharp one, (n, 2)."""
    expected = sharp_state("with pull", END, END)
    return np.array([smoothed_state(s) - expected for s in SHARPNESSES])


def observed_order(sizes, errors):
    """Return the slope of log error over log size."""
    return float(np.polyfit(np.log(sizes), np.log(np.abs(errors)), 1)[0])


def smoothed_law_becomes_the_sharp_one():
    errors = smoothing_errors()
    widths = 1 / np.array(SHARPNESSES)
    remark = (
        f"s from {SHARPNESSES[0]:g} to {SHARPNESSES[-1]:g} per rad; error of the "
        "angle {:.1e} to {:.1e} rad"
    ).format(*np.abs(errors[[0, -1], 0]))
    return [
        Comparison(
            f"order in the smoothing width 1/s at which the {name} at {END} s becomes "
            "that of the sharp law that may pull",
            "the smoothed edge stores pi^2 k / (24 s^2) less energy",
            2.0,
            observed_order(widths, errors[:, column]),
            "-",
            0.1,
            remark,
        )
        for column, name in enumerate(("angle", "speed"))
    ]


def sharpness_of_the_shipped_case():
    """Compare at the ratio of gap to smoothing width of the 16V280 case.

    The smoothing costs some (s b)^-2 of everything.
    """
    expected = sharp_state("with pull", END, END)
    key = shipped_case().driveline.connection
    s_b = key.smoothing * key.gap / 2
    s, tolerance = s_b / HALF_GAP, s_b**-2
    found = []
    for solver, state in (
        ("DOP853", smoothed_state(s)),
        ("our march of 1e-5 s", marched_state(s, 1e-5)),
    ):
        found += [
            Comparison(
                f"smoothed backlash, {name} at {END} s, s b = {s_b:g}, {solver}",
                "sharp law that may pull, solved from event to event",
                float(published),
                float(value),
                unit,
                tolerance * scale,
            )
            for name, unit, scale, published, value in zip(
                ("angle", "speed"),
                ("rad", "rad/s"),
                (START[0], 66.2),
                expected,
                state,
                strict=True,
            )
        ]
    return found


@functools.cache
def marched_state(sharpness, time_step):
    """Return angle and speed at the end by our own RK4."""
    rate = rate_function(smoothed(sharpness))
    state = rk4(rate, KEYED_START, time_step, round(END / time_step))
    return state[[ANGLE, SPEED]]


def closed_gap():
    """Compare the companion without backlash with its damped oscillation."""
    omega_0, zeta = math.sqrt(C / J), D / (2 * math.sqrt(C * J))
    decay, omega_d = zeta * omega_0, omega_0 * math.sqrt(1 - zeta**2)
    rate = rate_function(smoothed(1e4, half_gap=0.0))
    steps = 2000
    ours = rk4(rate, KEYED_START, END / steps, steps)
    t = END
    angle = START[0] * math.exp(-decay * t)
    angle *= math.cos(omega_d * t) + decay / omega_d * math.sin(omega_d * t)
    speed = -START[0] * math.exp(-decay * t) * omega_0**2 / omega_d
    speed *= math.sin(omega_d * t)
    return [
        Comparison(
            "natural frequency without backlash",
            "Modelica backlash example, springDamper",
            63.2456,
            omega_0,
            "rad/s",
            5e-5,
        ),
        Comparison(
            "damping ratio without backlash",
            "Modelica backlash example, springDamper",
            0.0790569,
            zeta,
            "-",
            5e-8,
        ),
        *(
            Comparison(
                f"{name} at {END} s, gap closed, our march",
                "damped oscillation, exact",
                published,
                float(value),
                unit,
                1e-8 * scale,
            )
            for name, unit, scale, published, value in zip(
                ("angle", "speed"),
                ("rad", "rad/s"),
                (START[0], 66.2),
                (angle, speed),
                ours[[ANGLE, SPEED]],
                strict=True,
            )
        ),
    ]


GROUPS = (
    sharp_events,
    sharp_impacts,
    sharp_states,
    smoothed_law_becomes_the_sharp_one,
    sharpness_of_the_shipped_case,
    closed_gap,
)


def comparisons():
    """Return what this module compares."""
    return collect(GROUPS)


@pytest.mark.parametrize("group", GROUPS)
def test_agrees_with_its_source(group):
    assert disagreements(group) == []


def test_error_falls_with_each_doubling_of_the_sharpness():
    angle_errors = np.abs(smoothing_errors()[:, 0])

    # Order 2: a quarter each time, once s b is beyond 100.
    assert angle_errors[1:] / angle_errors[:-1] == pytest.approx(0.25, abs=0.05)


def test_pulling_matters():
    """The two sharp laws are not the same: why [1] alone cannot check our contact."""
    apart = sharp_state("with pull", END, END) - sharp_state("no pull", 1.0, END)

    assert abs(apart[0]) > 0.1

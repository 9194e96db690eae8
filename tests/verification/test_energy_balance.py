"""Does a rollout keep its books: work done on the line = stored + dissipated?

Sources
-------
[1] The first law. Works are integrated beside the motion, by the same RK4; what is
    stored is worked out from the two end states alone, the smoothed contact's
    potential by quadrature of its own torque over the twist.
[2] Hairer, Norsett, Wanner (1993), Solving Ordinary Differential Equations I, II.1:
    RK4 has order 4.

The set turns with some 1e5 J, its contact stores less than one. So the balance is
compared with what the coupling's damper takes out, and the contact's own balance with
what the contact stores at most, neither with the total.
"""

import functools

import casadi as ca
import numpy as np
import pytest

from coupling_design.line.contact import contact_deflection, half_gap_angle
from coupling_design.line.damping import coupling_damping
from coupling_design.line.motion import reduced_inertia
from coupling_design.line.torques import excitation_torque, resistance_torque
from tests.verification.comparison import Comparison, collect, disagreements
from tests.verification.drivelines import shipped_case, with_gap
from tests.verification.integration import dop853, rate_function, rk4
from tests.verification.resonance import (
    impacts,
    start_of,
    state_before_resonance,
)

WINDOW = 1.0  # about the largest swing [s]
TIME_STEP = 1e-5
TIME_STEPS = (1e-5, 5e-6, 2.5e-6, 1.25e-6)
PRESS = 1e-3  # of the key [rad]
WORKS = (
    "excitation",
    "engine resistance",
    "generator resistance",
    "coupling damper",
    "oil",
    "contact",
)


def power(driveline):
    """Return the function (state, motion) -> power of each of WORKS [W]."""
    connection = driveline.connection
    c = coupling_damping(driveline.coupling, reduced_inertia(driveline))

    def of(state, _):
        th1, th2, th3, w1, w2, w3 = ca.vertsplit(state)
        pressed = contact_deflection(th2 - th3, connection)
        return ca.vertcat(
            excitation_torque(th1, driveline.excitation) * w1,
            resistance_torque(w1, driveline.engine_resistance) * w1,
            resistance_torque(w3, driveline.generator_resistance) * w3,
            c * (w1 - w2) ** 2,
            connection.oil_damping * (w2 - w3) ** 2,
            connection.contact_stiffness * pressed * (w2 - w3),
        )

    return of


def contact_energy(twist, connection):
    """Return the integral of k_g f from 0 to a twist [J]."""
    from scipy.integrate import quad

    edge = float(np.sign(twist) * half_gap_angle(connection))
    inside = abs(edge) < abs(twist)
    integral, _ = quad(
        lambda x: contact_deflection(x, connection),
        0.0,
        twist,
        points=[edge] if inside else None,
        limit=500,
        epsabs=1e-20,
        epsrel=1e-12,
    )
    return connection.contact_stiffness * integral


def stored(driveline, state):
    """Return the energy of motion, coupling and contact at a state [J]."""
    inertias = (
        driveline.engine_inertia,
        driveline.coupling_inertia,
        driveline.generator_inertia,
    )
    kinetic = sum(J * w**2 / 2 for J, w in zip(inertias, state[3:6], strict=True))
    coupling = driveline.coupling.torsional_stiffness * (state[0] - state[1]) ** 2 / 2
    contact = contact_energy(state[1] - state[2], driveline.connection)
    return kinetic, coupling, contact


@functools.cache
def start(gap):
    """Return the state before the resonance; with the gap closed, a quiet one."""
    state = state_before_resonance(WINDOW / 2)
    driveline = shipped_case().driveline
    if gap == driveline.connection.gap:
        return state
    return start_of(with_gap(driveline, gap), float(state[3]))


def books(gap, time_step, begin, window=WINDOW):
    """Return works (6,) and what is stored more at the end (3,) [J]."""
    driveline = with_gap(shipped_case().driveline, gap)
    rate = rate_function(driveline, power(driveline))
    end = rk4(
        rate, [*begin, *np.zeros(len(WORKS))], time_step, round(window / time_step)
    )
    change = np.subtract(stored(driveline, end), stored(driveline, begin))
    return end[6:], change


def imbalance(works, change):
    """Return work in - stored - dissipated, as a share of the damper's work."""
    return (works[0] - works[1:5].sum() - change.sum()) / works[3]


def contact_imbalance(works, change, most):
    """Return the same of the contact, as a share of the most it stores."""
    return (works[5] - change[2]) / most


@functools.cache
def key_twists(gap):
    """Return the twists of the key in the window, every 1e-4 s, by DOP853."""
    driveline = with_gap(shipped_case().driveline, gap)
    times = np.arange(0.0, WINDOW, 1e-4)
    states = dop853(rate_function(driveline), start(gap), times)
    return states[1] - states[2]


def energy_balance():
    gap = shipped_case().driveline.connection.gap
    return [*_energy_balance("present gap", gap), *_energy_balance("gap closed", 0.0)]


def _energy_balance(name, gap):
    connection = with_gap(shipped_case().driveline, gap).connection
    twists = key_twists(gap)
    most = contact_energy(float(np.abs(twists).max()), connection)
    works, change = books(gap, TIME_STEP, start(gap))
    crossings, inside = impacts(twists, half_gap_angle(connection))
    where = f"{WINDOW:g} s of resonance, {name}, step {TIME_STEP:g} s"
    remark = f"{crossings} crossings of the gap, inside it {inside:.0%} of the time"
    return [
        Comparison(
            f"energy balance of {where}: imbalance to the coupling damper's work",
            "first law",
            0.0,
            float(imbalance(works, change)),
            "-",
            1e-6,
            remark if gap else "",
        ),
        Comparison(
            f"energy balance of the contact alone, {where}: imbalance to the most that "
            "it stores",
            "first law",
            0.0,
            float(contact_imbalance(works, change, most)),
            "-",
            1e-6,
            f"it stores {most:.2g} J at most",
        ),
    ]


def order_of_the_balance():
    """Release the key from a press, gap closed: smooth, and every mode swings."""
    begin = start(0.0) + np.array([PRESS, PRESS, 0, 0, 0, 0])
    k_g = shipped_case().driveline.connection.contact_stiffness
    most = k_g * PRESS**2 / 2
    errors = [
        abs(contact_imbalance(*books(0.0, h, begin, 0.05), most)) for h in TIME_STEPS
    ]
    return [
        Comparison(
            "order in the time step at which the contact's balance closes, gap closed",
            "order of RK4",
            4.0,
            float(np.polyfit(np.log(TIME_STEPS), np.log(errors), 1)[0]),
            "-",
            0.3,
            f"steps {TIME_STEPS[0]:g} to {TIME_STEPS[-1]:g} s, imbalance "
            f"{errors[0]:.1e} to {errors[-1]:.1e} of what it stores",
        )
    ]


GROUPS = (energy_balance, order_of_the_balance)


def comparisons():
    """Return what this module compares."""
    return collect(GROUPS)


@pytest.mark.parametrize("group", GROUPS)
def test_agrees_with_its_source(group):
    assert disagreements(group) == []


def test_the_key_rattles_in_the_window():
    """The balance is worth little if the key does not cross its gap."""
    connection = shipped_case().driveline.connection

    crossings, inside = impacts(key_twists(connection.gap), half_gap_angle(connection))
    assert crossings >= 4
    assert inside > 0.05

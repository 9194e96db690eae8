"""An event of the tests' own: constant torque on an engine at rest, worked by hand."""

import dataclasses

import casadi as ca
import numpy as np
import pytest

from coupling_design.events.recording import record_event
from coupling_design.line.motion import motion, reduced_inertia, state_names
from coupling_design.line.parameters import Coupling, LossFactorDamping
from coupling_design.march.fastest import fastest_marcher
from coupling_design.march.sensitivities import with_sensitivities
from coupling_design.wear.quantities import PEAK_FORCE, TOTALS, place_of
from coupling_design.wear.step import joint_start, joint_step

TORQUE = 50.0  # N m
NOTHING = ca.SX.sym("parameters", 0)


def joined(rates, last):
    if isinstance(rates, np.ndarray):
        return np.vstack([rates, last])
    return ca.vertcat(rates, last)


@dataclasses.dataclass(frozen=True)
class SpinUp:
    """Constant torque on the engine, and one state of its own: the work it did [J]."""

    driveline: object
    torque: object = TORQUE
    time_step: float = 1e-4
    n_steps: int = 2000
    crank_angle: float = 0.0
    gravity_angle: float = 0.0

    @property
    def state_names(self):
        return (*state_names(self.driveline), "work")

    def motion(self, state):
        n = len(self.state_names) - 1
        moved = motion(self.driveline, state[:n], self.torque)
        power = self.torque * moved.engine_speed
        return dataclasses.replace(moved, state_rate=joined(moved.state_rate, power))

    def start(self):
        return ca.SX.zeros(len(self.state_names))


@pytest.fixture(scope="module")
def line(tight, quiet):
    coupling = Coupling(1e5, LossFactorDamping(0.0))
    return quiet(dataclasses.replace(tight, coupling=coupling))


def joint_ends(event, case, parameters=NOTHING, values=()):
    step = joint_step(event, case, parameters)
    start = joint_start(event, parameters)(ca.DM(values))[0]
    column = np.array(values, dtype=float).reshape(-1, 1)
    return fastest_marcher(step, event.n_steps)(np.asarray(start), column)[:, 0]


def test_its_peak_is_that_of_a_sudden_torque(line, calm):
    # Undamped, T on J1 from rest: the joint swings about T J23 / (J1 + J23), from 0.
    # What the seat carries to the generator is J3 / J23 of it.
    ends = joint_ends(SpinUp(line), calm)
    steady = TORQUE * 20.0 / 32.0 / 0.1
    assert ends[-len(TOTALS) :][place_of(PEAK_FORCE)] == pytest.approx(
        2 * steady, rel=1e-5
    )


def test_its_books_close(line, calm):
    event = SpinUp(line)
    theta_1, theta_3, omega_1, omega_3, work = joint_ends(event, calm)[:5]
    duration = event.n_steps * event.time_step
    impulse = 10.0 * omega_1 + 22.0 * omega_3
    stored = 5.0 * omega_1**2 + 11.0 * omega_3**2 + 5e4 * (theta_1 - theta_3) ** 2
    assert impulse == pytest.approx(TORQUE * duration, rel=1e-12)
    assert stored == pytest.approx(work, rel=1e-6)
    assert work == pytest.approx(TORQUE * theta_1, rel=1e-6)


def test_it_is_recorded(line):
    event = SpinUp(line)
    history = record_event(event, np.zeros((5, 1)))
    omega = np.sqrt(1e5 / reduced_inertia(line))
    swing = 1 - np.cos(omega * history.time)
    assert history.coupling_torque == pytest.approx(
        TORQUE * 22.0 / 32.0 * swing, abs=1e-5 * TORQUE
    )


def test_its_slopes_are_carried_along(line, calm):
    torque = ca.SX.sym("torque")
    event = SpinUp(line, torque)
    step = with_sensitivities(joint_step(event, calm, torque))
    start = joint_start(event, torque)(TORQUE)[0]
    both = np.vstack([np.asarray(start), np.zeros(start.shape)])
    march = fastest_marcher(step, event.n_steps)
    ends = march(both, np.array([[TORQUE]]))[:, 0]
    value, slope = np.split(ends, 2)
    # The line is linear: speeds grow with the torque, the work with its square.
    assert slope[2:4] == pytest.approx(value[2:4] / TORQUE, rel=1e-9)
    assert slope[4] == pytest.approx(2 * value[4] / TORQUE, rel=1e-9)

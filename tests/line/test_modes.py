import dataclasses
import math

import casadi as ca
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from coupling_design.line.modes import (
    damping_matrix,
    largest_stable_step,
    mass_matrix,
    modes,
    natural_angular_frequency,
    stiffness_matrix,
)
from coupling_design.line.parameters import (
    Coupling,
    KeyedConnection,
    ProportionalDamping,
)

INERTIAS = st.floats(min_value=0.1, max_value=1e3)
STIFFNESSES = st.floats(min_value=1e3, max_value=1e9)
UNDAMPED = ProportionalDamping(0.0, 1.0)


def with_key(driveline, **changes):
    connection = dataclasses.replace(driveline.connection, **changes)
    return dataclasses.replace(driveline, connection=connection)


def test_two_masses(tight):
    # sqrt(1e5 / 6.875)
    assert natural_angular_frequency(tight) == pytest.approx(120.6045, abs=1e-4)


def test_three_masses_by_hand(keyed):
    """Solve w^4 - B w^2 + C = 0 by hand.

    B = 1e5 (1/10 + 1/2) + 1e6 (1/2 + 1/20) = 610 000, C = 1e11 * 32 / 400 = 8e9:
    w^2 = (610 000 -+ sqrt(3.721e11 - 0.32e11)) / 2 = 13 409.53 and 596 590.47
    """
    frequencies = modes(keyed).angular_frequencies

    assert frequencies**2 == pytest.approx([0, 13_409.53, 596_590.47], abs=5e-3)
    assert natural_angular_frequency(keyed) ** 2 == pytest.approx(13_409.53, abs=5e-3)


@given(INERTIAS, INERTIAS, INERTIAS, STIFFNESSES, STIFFNESSES)
def test_closed_form_agrees_with_the_eigenvalues(keyed, J1, J2, J3, k, k_g):
    driveline = dataclasses.replace(
        with_key(keyed, contact_stiffness=k_g),
        engine_inertia=J1,
        coupling_inertia=J2,
        generator_inertia=J3,
        coupling=Coupling(k, UNDAMPED),
    )
    # An eigenvalue solver is right to rounding of the largest root only.
    squares = modes(driveline).angular_frequencies ** 2
    closed_form = natural_angular_frequency(driveline) ** 2

    assert closed_form == pytest.approx(squares[1], rel=1e-9, abs=1e-13 * squares[2])


@pytest.mark.parametrize("contact_stiffness", [1e9, 1e11, 1e13])
def test_a_stiff_key_is_a_tight_fit(keyed, tight, contact_stiffness):
    driveline = with_key(keyed, contact_stiffness=contact_stiffness)
    ratio = natural_angular_frequency(driveline) / natural_angular_frequency(tight)

    # The key in series: 1 - (k / k_g) (J3 / (J2 + J3))^2 / 2, the first order
    softening = 1e5 / contact_stiffness * (20 / 22) ** 2 / 2
    assert 1 - ratio == pytest.approx(softening, rel=1e-3, abs=1e-14)


def test_frequency_may_be_a_symbol(keyed):
    k = ca.SX.sym("k")
    driveline = dataclasses.replace(keyed, coupling=Coupling(k, UNDAMPED))
    compiled = ca.Function("w", [k], [natural_angular_frequency(driveline)])

    expected = natural_angular_frequency(keyed)
    assert float(compiled(1e5)) == pytest.approx(expected, rel=1e-14)


def test_matrices_by_hand(keyed):
    # c = 0.5 * 1e5 / 250 = 200; resistances at standstill: 1 + 30/0.2, 0.5 + 10/0.2
    stiffness = [[1e5, -1e5, 0], [-1e5, 1.1e6, -1e6], [0, -1e6, 1e6]]
    damping = [[200 + 151, -200, 0], [-200, 250, -50], [0, -50, 50 + 50.5]]

    assert mass_matrix(keyed).tolist() == [[10, 0, 0], [0, 2, 0], [0, 0, 20]]
    assert stiffness_matrix(keyed) == pytest.approx(np.array(stiffness))
    assert damping_matrix(keyed) == pytest.approx(np.array(damping))


def test_matrices_of_a_tight_fit(tight):
    assert mass_matrix(tight).tolist() == [[10, 0], [0, 22]]
    assert stiffness_matrix(tight).tolist() == [[1e5, -1e5], [-1e5, 1e5]]
    expected = np.array([[200 + 151, -200], [-200, 200 + 50.5]])
    assert damping_matrix(tight) == pytest.approx(expected)


def test_matrices_are_the_motion_linearised(closed, motion_at, quiet):
    state = np.array([3e-3, 1e-3, -2e-3, 0.3, -0.2, 0.1])
    accelerations = motion_at(quiet(closed), state).state_rate[3:]

    torques = -stiffness_matrix(closed) @ state[:3]
    torques -= damping_matrix(quiet(closed)) @ state[3:]
    inertias = np.diag(mass_matrix(closed))
    assert accelerations == pytest.approx(torques / inertias, rel=1e-12)


def test_shapes_of_two_masses(tight):
    # Momentum vanishes: 10 * 1 + 22 * (-10/22) = 0
    shapes = modes(tight).shapes

    assert shapes[:, 0] == pytest.approx([1, 1], rel=1e-9)
    assert shapes[:, 1] == pytest.approx([1, -10 / 22], rel=1e-12)


def test_shapes_solve_the_eigenvalue_problem(keyed):
    found = modes(keyed)

    assert np.abs(found.shapes).max(axis=0) == pytest.approx([1, 1, 1])
    inertia = mass_matrix(keyed) @ found.shapes @ np.diag(found.angular_frequencies**2)
    stiffness = stiffness_matrix(keyed) @ found.shapes
    assert inertia == pytest.approx(stiffness, abs=1e-9 * np.abs(stiffness).max())


def rk4_spectral_radius(driveline, step):
    """Return the largest growth in one RK4 step, the rigid body left out."""
    inverse = np.linalg.inv(mass_matrix(driveline))
    n = len(inverse)
    slope = 1.09984 if isinstance(driveline.connection, KeyedConnection) else 1.0
    A = np.zeros((2 * n, 2 * n))
    A[:n, n:] = np.eye(n)
    A[n:, :n] = -inverse @ stiffness_matrix(driveline, slope)
    A[n:, n:] = -inverse @ damping_matrix(driveline)
    hA = step * A
    powers = [np.linalg.matrix_power(hA, i) / math.factorial(i) for i in range(5)]
    growth = np.sort(np.abs(np.linalg.eigvals(sum(powers))))
    # Unbraked, the line turns on for ever: its factor is one.
    return growth[np.abs(growth - 1) > 1e-7].max()


@pytest.mark.parametrize("name", ["keyed", "closed", "tight"])
@pytest.mark.parametrize("damping_factor", [0.02, 0.5, 20.0])
def test_largest_stable_step_is_the_border(request, name, damping_factor):
    driveline = request.getfixturevalue(name)
    law = ProportionalDamping(damping_factor, 250.0)
    driveline = dataclasses.replace(driveline, coupling=Coupling(1e5, law))
    step = largest_stable_step(driveline)

    assert rk4_spectral_radius(driveline, 0.999 * step) < 1
    assert rk4_spectral_radius(driveline, 1.001 * step) > 1


def test_largest_stable_step_undamped(tight, quiet):
    # 2 sqrt 2 / omega_n
    driveline = dataclasses.replace(quiet(tight), coupling=Coupling(1e5, UNDAMPED))

    expected = 2 * math.sqrt(2) / natural_angular_frequency(tight)
    assert largest_stable_step(driveline) == pytest.approx(expected, rel=1e-7)


def test_largest_stable_step_undamped_with_a_key(keyed, quiet):
    # The contact is up to 1.09984 times as steep as k_g.
    driveline = dataclasses.replace(
        quiet(with_key(keyed, oil_damping=0.0)), coupling=Coupling(1e5, UNDAMPED)
    )
    steepest = with_key(driveline, contact_stiffness=1.09984e6)

    expected = 2 * math.sqrt(2) / modes(steepest).angular_frequencies[-1]
    assert largest_stable_step(driveline) == pytest.approx(expected, rel=1e-7)


def test_largest_stable_step_overdamped(tight, quiet):
    """On the negative real axis RK4 is bounded to h lambda = -2.785294."""
    law = ProportionalDamping(5000.0, 1.0)
    driveline = dataclasses.replace(quiet(tight), coupling=Coupling(1e5, law))
    # s^2 + (c / J) s + k / J = 0 with c = 5e8, J = 6.875
    c_J, k_J = 5e8 / 6.875, 1e5 / 6.875
    fastest = (c_J + math.sqrt(c_J**2 - 4 * k_J)) / 2

    step = largest_stable_step(driveline)
    assert step == pytest.approx(2.785294 / fastest, rel=1e-6)

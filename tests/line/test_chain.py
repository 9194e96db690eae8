import casadi as ca
import numpy as np
import pytest
from opentorsion import Assembly, Disk, Shaft
from scipy.integrate import solve_ivp
from scipy.linalg import eigh

from coupling_design.line.chain import (
    Chain,
    Contact,
    Elastic,
    Rigid,
    chain_damping,
    chain_mass,
    chain_motion,
    chain_stiffness,
    unfold,
)
from coupling_design.line.parameters import KeyedConnection
from coupling_design.march.runge_kutta import rk4_step

LENGTHS = range(2, 13)


def random_chain(n, *, damping=0.0, seed=0):
    rng = np.random.default_rng(seed + n)
    J = rng.uniform(0.5, 50.0, n).tolist()
    k = rng.uniform(1e4, 1e7, n - 1).tolist()
    c = (damping * rng.uniform(1.0, 100.0, n - 1)).tolist()
    return Chain(tuple(J), tuple(map(Elastic, k, c)))


PUBLISHED = {
    # Friswell, Penny, Garvey, Lees (2010), 9.7.1; Hz to two decimals.
    "five discs": (
        (3.5e-3, 3.5e-3, 3.5e-3, 0.15, 0.05),
        (12e3, 12e3, 14e3, 10e3),
        2 * np.pi * np.array([81.21, 141.21, 378.95, 536.36]),
    ),
    # The tutorial of openTorsion; rad/s.
    "tutorial": (
        (100.0, 10.0, 50.0, 10.0, 80.0),
        (25e6,) * 4,
        np.array([368.9, 784.482, 2268.087, 2380.5]),
    ),
}


@pytest.mark.parametrize("name", PUBLISHED)
def test_published_chains(name):
    J, k, published = PUBLISHED[name]
    chain = Chain(J, tuple(Elastic(each, 0.0) for each in k))
    squares = eigh(chain_stiffness(chain), chain_mass(chain), eigvals_only=True)
    assert np.sqrt(squares[1:]) == pytest.approx(published, rel=1e-4)


@pytest.mark.parametrize("seed", [0, 100])
@pytest.mark.parametrize("n", LENGTHS)
def test_modes_are_those_of_opentorsion(n, seed):
    """Each shaft of openTorsion has its own inertia, here none."""
    chain = random_chain(n, seed=seed)
    shafts = [
        Shaft(i, i + 1, k=joint.stiffness, I=0.0)
        for i, joint in enumerate(chain.joints)
    ]
    disks = [Disk(i, J) for i, J in enumerate(chain.inertias)]
    _, natural, _ = Assembly(shafts, disk_elements=disks).modal_analysis()
    theirs = np.sort(np.abs(natural))[::2][1:]

    squares = eigh(chain_stiffness(chain), chain_mass(chain), eigvals_only=True)
    assert np.sqrt(squares[1:]) == pytest.approx(theirs, rel=1e-9)


@pytest.mark.parametrize("n", LENGTHS)
def test_a_linear_chain_moves_as_its_matrices_say(n):
    chain = random_chain(n, damping=1.0)
    rng = np.random.default_rng(1)
    state, torques = rng.normal(size=2 * n), rng.normal(scale=1e4, size=n)
    grounds = rng.uniform(0.0, 5.0, n)
    outer = torques - grounds * state[n:]

    K, C = chain_stiffness(chain), chain_damping(chain, grounds)
    expected = (torques - K @ state[:n] - C @ state[n:]) / chain_mass(chain).diagonal()
    rate = chain_motion(chain, state[:, np.newaxis], outer[:, np.newaxis]).state_rate
    assert rate[:n, 0] == pytest.approx(state[n:])
    assert rate[n:, 0] == pytest.approx(expected, rel=1e-9, abs=1e-6)


def tightly_joined(stiffness):
    """Return 2 and 3 kg m^2 on a spring, the second with two more fitted to it."""
    seat = Rigid() if stiffness is None else Elastic(stiffness, 0.0)
    return Chain((2.0, 3.0, 4.0, 5.0), (Elastic(1e3, 10.0), seat, seat))


def test_rigid_joints_carry_what_turns_all_behind_them():
    """By hand: 1e3 * 0.01 + 10 * 0.1 = 11 N m before; 12 kg m^2 under 11 + 7 - 6."""
    chain = tightly_joined(None)
    state = np.array([[0.01], [0.0], [0.1], [0.0]])
    moved = chain_motion(chain, state, (0.0, 7.0, 0.0, -6.0))

    assert chain.bodies == ((0,), (1, 2, 3))
    assert moved.state_rate[:, 0] == pytest.approx([0.1, 0.0, -11.0 / 2.0, 1.0])
    carried = [float(torque[0]) for torque in moved.joint_torques]
    # The last: 5 * 1 + 6; the one before: 4 * 1 and what the last carries.
    assert carried == pytest.approx([11.0, 15.0, 11.0])


def test_a_rigid_joint_is_the_limit_of_a_stiff_one():
    masses = chain_mass(tightly_joined(1e12))
    stiff = eigh(chain_stiffness(tightly_joined(1e12)), masses, eigvals_only=True)
    rigid = tightly_joined(None)
    tight = eigh(chain_stiffness(rigid), chain_mass(rigid), eigvals_only=True)
    assert stiff[1] == pytest.approx(tight[1], rel=1e-6)


def test_angles_and_speeds_of_what_is_fitted_are_those_of_its_body():
    angles, speeds = unfold(tightly_joined(None), np.array([1.0, 2.0, 3.0, 4.0]))
    assert angles == [1.0, 2.0, 2.0, 2.0]
    assert speeds == [3.0, 4.0, 4.0, 4.0]


@pytest.mark.parametrize("fitted", [False, True])
def test_what_joints_carry_balances_each_inertia(fitted):
    """J_i times its acceleration is what comes in less what goes out, fitted or not."""
    key = KeyedConnection(0.1, 1e-4, 2e6, 5.0, 4e6)
    chain = Chain(
        (2.0, 3.0, 4.0, 5.0, 6.0),
        (
            Elastic(1e3, 10.0),
            Rigid() if fitted else Elastic(5e3, 1.0),
            Contact(key),
            Rigid(),
        ),
    )
    n = len(chain.bodies)
    rng = np.random.default_rng(3)
    state = rng.normal(scale=0.1, size=(2 * n, 1))
    outer = rng.normal(scale=100.0, size=(5, 1))
    moved = chain_motion(chain, state, outer)

    by_body = dict(enumerate(moved.state_rate[n:, 0]))
    at = {i: k for k, body in enumerate(chain.bodies) for i in body}
    through = [0.0, *(float(np.ravel(t)[0]) for t in moved.joint_torques), 0.0]
    for i, J in enumerate(chain.inertias):
        net = float(outer[i, 0]) + through[i] - through[i + 1]
        assert J * by_body[at[i]] == pytest.approx(net, rel=1e-9, abs=1e-6)


def test_six_inertias_run_down_as_dop853_says():
    """Order 4 on the first, brakes on the ends, marched by RK4 over half a second."""
    chain, n = random_chain(6, damping=1.0), 6
    brakes = (20.0, 0.0, 0.0, 0.0, 0.0, 35.0)

    def outer(angles, speeds, sin):
        drives = [500.0 * sin(4 * angles[0]), *[0.0] * (n - 1)]
        return [T - c * w for T, c, w in zip(drives, brakes, speeds, strict=True)]

    def theirs(_, y):
        J = np.array(chain.inertias)
        twist, rate = -np.diff(y[:n]), -np.diff(y[n:])
        k, c = np.array([(j.stiffness, j.damping) for j in chain.joints]).T
        carried = np.concatenate([[0.0], k * twist + c * rate, [0.0]])
        torques = np.array(outer(y[:n], y[n:], np.sin))
        return np.concatenate([y[n:], (torques + carried[:-1] - carried[1:]) / J])

    start = np.concatenate([np.zeros(n), np.full(n, 60.0)])
    exact = solve_ivp(
        theirs, (0.0, 0.5), start, method="DOP853", rtol=1e-11, atol=1e-12
    ).y[:, -1]

    y = ca.SX.sym("y", 2 * n)

    def rate(state):
        angles, speeds = unfold(chain, state)
        return chain_motion(chain, state, outer(angles, speeds, ca.sin)).state_rate

    step = ca.Function("step", [y], [rk4_step(rate, y, 2e-5)])
    end = np.asarray(step.mapaccum(25_000)(start))[:, -1]
    assert end == pytest.approx(exact, rel=1e-6)


@pytest.mark.parametrize("joints", [0, 2])
def test_joints_must_be_those_between_the_inertias(joints):
    with pytest.raises(ValueError, match="2 inertias have 1 joints"):
        Chain((1.0, 2.0), (Rigid(),) * joints)

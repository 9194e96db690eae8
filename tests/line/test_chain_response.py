import numpy as np
import pytest
from opentorsion import Assembly, Disk, Shaft

from coupling_design.line.chain import Chain, Elastic, Rigid, chain_motion
from coupling_design.line.chain_response import chain_response

OMEGA = np.array([3.0, 80.0, 650.0, 2500.0])


def random_chain(n, seed):
    rng = np.random.default_rng(seed + n)
    J = rng.uniform(0.5, 50.0, n).tolist()
    k, c = rng.uniform(1e4, 1e7, n - 1), rng.uniform(10.0, 1000.0, n - 1)
    return Chain(tuple(J), tuple(map(Elastic, k.tolist(), c.tolist()))), rng


def respond(chain, torques, brakes):
    damping = [np.asarray(joint.damping) for joint in chain.flexible]
    return chain_response(chain, OMEGA, torques, damping, brakes)


@pytest.mark.parametrize("seed", [0, 100])
@pytest.mark.parametrize("n", range(2, 13))
def test_the_response_is_that_of_opentorsion(n, seed):
    chain, rng = random_chain(n, seed)
    torques = rng.normal(size=(len(OMEGA), n)) + 1j * rng.normal(size=(len(OMEGA), n))
    brakes = rng.uniform(0.0, 20.0, n)
    shafts = [
        Shaft(i, i + 1, k=joint.stiffness, c=joint.damping, I=0.0)
        for i, joint in enumerate(chain.joints)
    ]
    disks = [
        Disk(i, J, c=c)
        for i, (J, c) in enumerate(zip(chain.inertias, brakes, strict=True))
    ]
    theirs, _ = Assembly(shafts, disk_elements=disks).ss_response(torques.T, OMEGA)
    ours = respond(chain, torques, brakes)
    assert np.abs(ours - theirs.T).max() <= 1e-9 * np.abs(theirs).max()


def test_the_response_obeys_the_equations_of_motion():
    """At four instants of a period, with two inertias fitted to each other."""
    chain = Chain(
        (2.0, 3.0, 4.0, 5.0), (Elastic(1e5, 50.0), Rigid(), Elastic(2e5, 20.0))
    )
    rng = np.random.default_rng(2)
    torques = rng.normal(size=(len(OMEGA), 4)) + 1j * rng.normal(size=(len(OMEGA), 4))
    brakes = np.array([1.0, 2.0, 3.0, 4.0])
    q = respond(chain, torques, brakes)
    body_of = [0, 1, 1, 2]
    for w, angles, outer in zip(OMEGA, q, torques, strict=True):
        turn = np.exp(1j * np.array([0.0, 0.7, 1.9, 4.0]))
        state = np.imag(
            np.vstack([np.outer(a, turn) for a in (angles, 1j * w * angles)])
        )
        acting = np.imag(np.outer(outer, turn)) - brakes[:, None] * state[3:][body_of]
        rates = chain_motion(chain, state, list(acting)).state_rate
        expected = np.imag(np.outer(-(w**2) * angles, turn))
        assert rates[3:] == pytest.approx(expected, rel=1e-7, abs=1e-10)

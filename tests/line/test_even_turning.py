import numpy as np
import pytest

from coupling_design.line.chain import Chain, Contact, Elastic, Rigid, chain_motion
from coupling_design.line.contact import transmission_torque
from coupling_design.line.even_turning import (
    contact_twist,
    even_angles,
    even_torques,
)
from coupling_design.line.parameters import KeyedConnection

KEY = KeyedConnection(0.1, 1e-4, 2e6, 5.0, 4e6)
CHAIN = Chain((2.0, 3.0, 4.0, 5.0), (Elastic(1e3, 10.0), Contact(KEY), Rigid()))
OUTER = (-70.0, 0.0, -14.0, -28.0)
ACCELERATION = sum(OUTER) / sum(CHAIN.inertias)


def test_what_each_joint_carries_by_hand():
    """All slow down by 8 rad/s^2: 5 * -8 + 28 = -12, less 4 * 8 - 14, less 3 * 8."""
    assert ACCELERATION == -8.0
    assert even_torques(CHAIN, ACCELERATION, OUTER) == pytest.approx(
        (-54.0, -30.0, -12.0)
    )


def test_angles_by_hand():
    """-54 N m on 1e3 N m/rad; -30 on 2e6 and half the gap of 1e-4 m at 0.1 m."""
    key = -30.0 / 2e6 - 0.5e-3
    assert even_angles(CHAIN, ACCELERATION, OUTER) == pytest.approx(
        (-0.054 + key, key, 0.0), rel=1e-6
    )


def test_a_chain_so_twisted_does_turn_with_one_acceleration():
    angles = even_angles(CHAIN, ACCELERATION, OUTER)
    state = np.array([[*angles, *[50.0] * len(angles)]]).T
    moved = chain_motion(CHAIN, state, OUTER)
    assert moved.state_rate[len(angles) :, 0] == pytest.approx([ACCELERATION] * 3)
    carried = [float(np.ravel(torque)[0]) for torque in moved.joint_torques]
    assert carried == pytest.approx(even_torques(CHAIN, ACCELERATION, OUTER))


@pytest.mark.parametrize("torque", [-5e3, -1.0, 1.0, 5e3])
def test_a_key_carries_the_torque_at_its_twist(torque):
    twist = contact_twist(torque, KEY)
    assert transmission_torque(twist, 0.0, KEY) == pytest.approx(torque, rel=1e-9)

import math

import pytest

from coupling_design.engine import (
    Arrangement,
    Charge,
    Cycle,
    Cylinder,
    Engine,
    firing_angles,
)

ORDER = tuple("15738426")


@pytest.fixture
def cylinder():
    """Return a cylinder of the 16V280: rod ratio 0.245, no mass."""
    return Cylinder(
        bore=0.280,
        stroke=0.285,
        rod_length=0.1425 / 0.245,
        compression_ratio=12.5,
        reciprocating_mass=0.0,
    )


@pytest.fixture
def charge():
    return Charge(1e5, 1e5, 1.32, 1.32)


@pytest.fixture
def vee(cylinder, charge):
    """Return a maker of the 16V280, motored, with a bank angle in degrees."""

    def make(bank_angle, **changes):
        arrangement = Arrangement(16, ORDER, math.radians(bank_angle))
        angles = firing_angles(arrangement, Cycle.FOUR_STROKE)
        values = {
            "cylinder": cylinder,
            "charge": charge,
            "cycle": Cycle.FOUR_STROKE,
            "firing_angles": angles,
            "reference_speed": 4 * math.pi,  # 120 rpm
        }
        return Engine(**(values | changes))

    return make

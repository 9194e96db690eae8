import math

import pytest

from coupling_design.engine import Charge, Cycle, Cylinder, Engine
from coupling_design.engine.crank_mode import UNCERTAINTY, first_crank_mode

# Mendes, Meirelles, Zampieri 2008, doi 10.1243/14644193JMBD126, Fig. 4: six cylinders,
# first mode 216.577 Hz.
PUBLISHED = 216.577


@pytest.fixture
def engine():
    """Return a maker of the published engine with other sizes."""

    def make(cylinders=6, bore=0.105, stroke=0.137):
        return Engine(
            cylinder=Cylinder(
                bore=bore,
                stroke=stroke,
                rod_length=1.5 * stroke,
                compression_ratio=17.0,
                reciprocating_mass=2.521,
            ),
            charge=Charge(1e5, 1e5, 1.32, 1.32),
            cycle=Cycle.FOUR_STROKE,
            firing_angles=tuple(4 * math.pi * i / cylinders for i in range(cylinders)),
            reference_speed=4 * math.pi,
        )

    return make


def test_published_six_cylinder_engine(engine):
    found = first_crank_mode(engine(), is_v=False)
    assert 1 / UNCERTAINTY < found / PUBLISHED < UNCERTAINTY
    # By hand: journal 0.7 x 0.105 = 0.0735 m, I_p = pi/32 0.0735^4 = 2.8651e-6 m^4;
    # k = 8.2e10 x 2.8651e-6 / (1.8 x 0.105) = 1.2431e6 N m/rad;
    # J = 0.235 x 7850 x 0.105^3 x 0.137^2 = 0.040082 kg m^2; sin(pi/26) = 0.120537;
    # omega = 2 sqrt(1.2431e6/0.040082) 0.120537 = 1342.5 rad/s, 213.7 Hz.
    assert found == pytest.approx(213.7, rel=5e-4)


def test_a_chain_of_equal_throws(engine):
    """The closed form is the lowest eigenvalue of n masses on n springs, one end held.

    For one throw, omega = sqrt(k/J): 2 sin(pi/6) = 1. For two, the eigenvalues of
    [[2, -1], [-1, 1]] are (3 -+ sqrt 5)/2, the lower one 0.381966.
    """
    one, two = (first_crank_mode(engine(n), is_v=False) for n in (1, 2))
    assert (two / one) ** 2 == pytest.approx(0.381966, rel=1e-5)


def test_twice_as_large_is_half_as_fast(engine):
    """All lengths doubled: k grows by 8, J by 32."""
    small, large = engine(), engine(bore=0.210, stroke=0.274)
    assert first_crank_mode(large, is_v=False) == pytest.approx(
        first_crank_mode(small, is_v=False) / 2
    )


def test_a_v_has_half_the_throws_each_slower(engine):
    # Two rods side by side: k / 1.3, J x 1.6, so slower by sqrt(2.08) = 1.44222.
    v, line = (
        first_crank_mode(engine(12), is_v=True),
        first_crank_mode(engine(6), is_v=False),
    )
    assert line / v == pytest.approx(1.44222, rel=1e-5)

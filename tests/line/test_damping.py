import math

import pytest

from coupling_design.line.damping import coupling_damping
from coupling_design.line.parameters import (
    Coupling,
    LossFactorDamping,
    ProportionalDamping,
    RelativeDamping,
)


def test_proportional_damping():
    # kappa0 k / omega0 = 0.65 * 0.58e6 / 290, whatever the inertia
    coupling = Coupling(0.58e6, ProportionalDamping(0.65, 290.0))

    assert coupling_damping(coupling, 137.0) == pytest.approx(1300.0, rel=1e-14)
    assert coupling_damping(coupling, 1.0) == pytest.approx(1300.0, rel=1e-14)


def test_loss_factor_damping():
    # omega_n = sqrt(4e6 / 100) = 200 rad/s; c = 0.02 * 4e6 / 200
    coupling = Coupling(4e6, LossFactorDamping(0.02))

    assert coupling_damping(coupling, 100.0) == pytest.approx(400.0, rel=1e-14)


def test_relative_damping():
    # omega_n = 200 rad/s; c = 1.2 * 4e6 / (2 pi 200) = 12 000 / pi
    coupling = Coupling(4e6, RelativeDamping(1.2))

    assert coupling_damping(coupling, 100.0) == pytest.approx(3819.7186, abs=1e-4)


def test_relative_damping_is_the_share_of_the_work_of_a_cycle():
    # DIN 740: psi = A_D / A_el, with A_D = pi c omega_n a^2 and A_el = k a^2 / 2
    k, amplitude, omega_n = 4e6, 0.01, 200.0
    c = coupling_damping(Coupling(k, RelativeDamping(1.2)), 100.0)

    work_lost = math.pi * c * omega_n * amplitude**2
    assert work_lost / (k * amplitude**2 / 2) == pytest.approx(1.2, rel=1e-12)


@pytest.mark.parametrize(
    ("law", "growth"),
    [
        (ProportionalDamping(0.65, 290.0), 4.0),
        (LossFactorDamping(0.02), 2.0),
        (RelativeDamping(1.2), 2.0),
    ],
)
def test_damping_follows_four_times_the_stiffness(law, growth):
    soft, stiff = (coupling_damping(Coupling(k, law), 100.0) for k in (1e6, 4e6))

    assert stiff / soft == pytest.approx(growth, rel=1e-14)

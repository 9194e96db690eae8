import dataclasses

import numpy as np
import pytest

from coupling_design.parts.bearing.contact_stress import (
    contact_stress,
    minimum_load,
    permissible_transmission_force,
    strict_transmission_force,
)
from coupling_design.parts.bearing.parameters import Contact


@pytest.fixture(params=Contact)
def touching(request, nu2326):
    return dataclasses.replace(nu2326, contact=request.param)


def test_contact_stress(nu2326):
    # 3.62 MPa/sqrt(N) * sqrt(40 000 N) = 724 MPa
    assert contact_stress(40e3, nu2326) == pytest.approx(724e6, rel=1e-12)


def test_minimum_load_of_the_paper(nu2326):
    assert minimum_load(nu2326) == pytest.approx(48838.56, abs=0.005)
    assert contact_stress(minimum_load(nu2326), nu2326) == pytest.approx(800e6)


def test_a_ball_touches_in_a_point(ball):
    # 60 MPa/N^(1/3) * (27 000 N)^(1/3) = 60 * 30 = 1800 MPa
    point = dataclasses.replace(
        ball, stress_coefficient=60e6, minimum_stress=1800e6, contact=Contact.POINT
    )

    assert contact_stress(27e3, point) == pytest.approx(1800e6, rel=1e-12)
    # (1800/60)^3 = 27 000 N
    assert minimum_load(point) == pytest.approx(27e3, rel=1e-12)


def test_permissible_force_of_the_paper(shaft, nu2326):
    # 48 838.56 - 12 718.38 N
    force = permissible_transmission_force(shaft, (nu2326, nu2326))

    assert force == pytest.approx(36120.18, abs=0.005)


def test_strict_force_counts_the_lever(shaft, nu2326):
    # 36 120.18 N / 1.25; bearing 2 would permit 36 120.18 / 0.25 = 144 480.7 N
    force = strict_transmission_force(shaft, (nu2326, nu2326))

    assert force == pytest.approx(28896.14, abs=0.005)


def test_the_weaker_bearing_decides(shaft, nu2326):
    # S_min 400 MPa: (400/3.62)^2 = 12 209.64 N, less than the weight's 12 718.38 N
    weak = dataclasses.replace(nu2326, minimum_stress=400e6)

    force = permissible_transmission_force(shaft, (nu2326, weak))
    strict_force = strict_transmission_force(shaft, (nu2326, weak))

    assert force == pytest.approx(-508.74, abs=0.005)
    assert strict_force == pytest.approx(-508.74 / 0.25, abs=0.02)


def test_contact_stress_is_one_for_all_number_types(evaluations, touching):
    values = list(evaluations(lambda load: contact_stress(load, touching), 3e4))

    assert values == pytest.approx([values[0]] * 5, rel=1e-15)


def test_contact_stress_has_finite_derivatives_at_zero_load(derivatives, touching):
    for parts in derivatives(lambda load: contact_stress(load, touching), 0):
        assert all(np.isfinite(part).all() for part in parts)

import casadi as ca
import pytest

from coupling_design.march.divergence import steps_to_divergence


@pytest.fixture
def squaring():
    state, parameters = ca.SX.sym("x"), ca.SX.sym("p")
    return ca.Function("step", [state, parameters], [parameters * state**2])


def test_overflow_is_found_at_its_step(squaring):
    # 2^(2^n) is infinite from n = 10 on
    assert steps_to_divergence(squaring, 100, ca.DM(2), ca.DM(1)) == 10


def test_what_stays_finite_has_all_its_steps(squaring):
    assert steps_to_divergence(squaring, 100, ca.DM(1), ca.DM(1)) >= 100

import dataclasses
import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from coupling_design.parts.bearing.loads import (
    SMALLEST_LOAD,
    combined_load,
    rotational_loads,
    static_loads,
)

forces = st.floats(-2e5, 2e5)


def test_static_loads_of_the_paper(shaft):
    # 25 436.76 N * 460 mm / 920 mm = 12 718.38 N each
    assert static_loads(shaft) == pytest.approx((12718.38, 12718.38), rel=1e-12)


def test_static_loads_carry_the_weight_unevenly(shaft):
    nearer = dataclasses.replace(shaft, bearing_1_to_rotor=0.230)
    # 25 436.76 N * 460/690 = 16 957.84 N and * 230/690 = 8 478.92 N
    assert static_loads(nearer) == pytest.approx((16957.84, 8478.92), rel=1e-12)


def test_rotational_loads_of_the_paper(shaft):
    # (230+460+460)/920 = 1.25; -230/920 = -0.25: the lever turns bearing 2's load over
    assert rotational_loads(1000.0, shaft) == pytest.approx((1250, -250), rel=1e-12)


@given(forces)
def test_rotational_loads_balance_the_shaft(shaft, force):
    near, far = rotational_loads(force, shaft)

    assert near + far == pytest.approx(force, rel=1e-12, abs=1e-6)
    # About the hub: 230 mm to bearing 1, 1150 mm to bearing 2.
    assert 0.230 * near + 1.150 * far == pytest.approx(0, abs=1e-9 * abs(force))


def test_loads_of_both_bearings_where_the_force_points_down(shaft):
    # 1000 N along gravity: 12 718.38 + 1250 N at bearing 1, 12 718.38 - 250 N at 2
    loads = [
        combined_load(turning, weight, 0.0)
        for turning, weight in zip(
            rotational_loads(1000.0, shaft), static_loads(shaft), strict=True
        )
    ]

    assert loads == pytest.approx([13968.38, 12468.38], rel=1e-12)


def test_combined_load_at_sixty_degrees():
    # 20000^2 + 12718.38^2 + 2 * 20000 * 12718.38 * 0.5 = 8.161 248e8 N^2
    load = combined_load(20000.0, 12718.38, math.pi / 3)

    assert load == pytest.approx(28567.8979, abs=1e-3)


@given(forces, st.floats(0, 2e5), st.floats(-100, 100))
def test_combined_load_lies_between_difference_and_sum(rotational, static, angle):
    load = combined_load(rotational, static, angle)

    # Cancellation within the square leaves sqrt(machine epsilon) of the forces.
    slack = 1e-7 * (abs(rotational) + static) + SMALLEST_LOAD
    assert load >= abs(abs(rotational) - static) - slack
    assert load <= abs(rotational) + static + slack


@given(forces, st.floats(0, 2e5), st.floats(-10, 10))
def test_reversed_force_is_half_a_turn(rotational, static, angle):
    reversed_load = combined_load(-rotational, static, angle)
    turned_load = combined_load(rotational, static, angle + math.pi)

    assert reversed_load == pytest.approx(turned_load, rel=1e-6, abs=0.1)


def test_combined_load_is_one_for_all_number_types(evaluations):
    values = list(evaluations(combined_load, 3e4, 1.2e4, 2.0))

    assert values == pytest.approx([values[0]] * 5, rel=1e-15)


@pytest.mark.parametrize(
    "point", [(0, 0, 0), (0, 12e3, 0), (12e3, 12e3, math.pi), (0, 0, 1), (1e5, 0, 3)]
)
def test_combined_load_has_finite_derivatives(derivatives, point):
    for parts in derivatives(combined_load, *point):
        assert all(np.isfinite(part).all() for part in parts)

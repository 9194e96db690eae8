import math

import casadi as ca
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from coupling_design.parts.bearing.contact_stress import minimum_load
from coupling_design.parts.bearing.damage import (
    PAPER_UNIT,
    damage_increment,
    miner_damage,
    revolutions,
)
from coupling_design.parts.bearing.life import basic_rating_life
from coupling_design.parts.bearing.modified_life import modified_rating_life

loads = st.floats(0, 2e5)
speeds = st.floats(-110, 110)


def test_revolutions(rpm):
    # 120 rpm * 1 s / 60 = 2
    assert revolutions(rpm(120), 1.0) == pytest.approx(2, rel=1e-12)
    assert revolutions(-rpm(120), 1.0) == revolutions(rpm(120), 1.0)


def test_damage_increment(nu2326, grease, rpm):
    # 2 revolutions / 2.484079e9 (see the test of modified_rating_life) = 8.051275e-10
    damage = damage_increment(50e3, rpm(120), 1.0, nu2326, grease, 0.99)

    assert damage == pytest.approx(8.051275e-10, rel=1e-6)


def test_paper_unit_counts_life_in_millions():
    # the paper's D = 0.00405 stands for 4.05e-9 of a life
    damage = 4.05e-9

    assert damage * PAPER_UNIT == pytest.approx(0.00405)


def test_one_bin_is_one_over_its_life(nu2326, grease, rpm):
    one_turn = 2 * math.pi / rpm(300)
    life = modified_rating_life(60e3, rpm(300), nu2326, grease, 0.99)

    damage = miner_damage([60e3], [rpm(300)], one_turn, nu2326, grease, 0.99)

    assert damage == pytest.approx(1 / life, rel=1e-12)


@given(loads, speeds, st.integers(2, 50))
def test_splitting_a_bin_changes_nothing(nu2326, grease, load, speed, parts):
    whole = miner_damage([load], [speed], 1.0, nu2326, grease, 0.99)
    split = miner_damage(
        [load] * parts, [speed] * parts, 1.0 / parts, nu2326, grease, 0.99
    )

    assert split == pytest.approx(whole, rel=1e-12)


@given(st.lists(st.tuples(loads, speeds), min_size=2, max_size=20), st.data())
def test_damage_is_additive_in_time(nu2326, grease, history, data):
    at = data.draw(st.integers(0, len(history)))
    load, speed = np.array(history).T

    def damage(part):
        return miner_damage(load[part], speed[part], 1e-4, nu2326, grease, 0.99)

    both = damage(slice(None, at)) + damage(slice(at, None))

    assert damage(slice(None)) == pytest.approx(both, rel=1e-12)


def test_damage_saturates_at_low_load(nu2326, grease, rpm):
    # a_ISO = 50: L_p = 0.25 * 50 * L_10
    damage = damage_increment(1e3, rpm(1000), 60.0, nu2326, grease, 0.99)

    assert damage == pytest.approx(1000 / (12.5 * basic_rating_life(1e3, nu2326)))


def test_standstill_and_zero_load_do_no_damage(nu2326, grease):
    assert damage_increment(1e5, 0.0, 1.0, nu2326, grease, 0.99) == 0
    assert 0 <= damage_increment(0.0, 10.0, 1.0, nu2326, grease, 0.99) < 1e-30


def test_sense_of_rotation_does_not_matter(nu2326, grease):
    forth, back = (
        damage_increment(5e4, speed, 1.0, nu2326, grease, 0.99) for speed in (30, -30)
    )
    assert forth == back > 0


def test_small_loads_can_be_left_out(nu2326, grease):
    loads = minimum_load(nu2326) * np.array([0.5, 0.999, 1.0, 2.0])
    all_loads = damage_increment(loads, 30.0, 1.0, nu2326, grease, 0.99)
    large_loads = damage_increment(
        loads, 30.0, 1.0, nu2326, grease, 0.99, small_loads_do_damage=False
    )

    assert (large_loads == all_loads * [0, 0, 1, 1]).all()
    assert miner_damage(
        loads, [30.0] * 4, 1.0, nu2326, grease, 0.99, small_loads_do_damage=False
    ) == pytest.approx(large_loads.sum())


@pytest.mark.parametrize("counts_all", [True, False])
@pytest.mark.parametrize("point", [(5e4, 12.0), (3e4, 0.0), (0.0, 50.0), (6e4, -90.0)])
def test_damage_is_one_for_all_number_types(
    evaluations, bearing, grease, point, counts_all
):
    def damage(load, speed):
        return damage_increment(
            load,
            speed,
            1e-4,
            bearing,
            grease,
            0.99,
            small_loads_do_damage=counts_all,
        )

    values = list(evaluations(damage, *point))

    assert values == pytest.approx([values[0]] * 5, rel=1e-12, abs=0)


@pytest.mark.parametrize(
    "point", [(0, 0), (0, 50), (5e4, 0), (5e4, 1e-9), (5e4, 1.27), (5e4, 104.7)]
)
def test_damage_has_finite_derivatives(derivatives, bearing, grease, point):
    def damage(load, speed):
        return damage_increment(load, speed, 1e-4, bearing, grease, 0.99)

    for parts in derivatives(damage, *point):
        assert all(np.isfinite(part).all() for part in parts)


def test_graph_of_damage_stays_small(nu2326, grease):
    load, speed = ca.SX.sym("load"), ca.SX.sym("speed")
    damage = damage_increment(load, speed, 1e-4, nu2326, grease, 0.99)
    step = ca.Function("damage", [load, speed], [damage])
    powers = [
        step.instruction_id(i)
        for i in range(step.n_instructions())
        if step.instruction_id(i) in (ca.OP_POW, ca.OP_CONSTPOW)
    ]

    # nu_1, e_C, kappa^e, (e_C C_u / P)^0.4, bracket^-9.185, (C_r / P)^(10/3)
    assert len(powers) == 6
    assert step.n_nodes() < 120

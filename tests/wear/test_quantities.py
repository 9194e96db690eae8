import casadi as ca
import numpy as np
import pytest

from coupling_design.wear.quantities import (
    DAMAGES,
    PEAK_FORCE,
    PEAK_LOADS,
    QUANTITIES,
    TOTALS,
    Gathering,
    Segment,
    place_of,
)

SEGMENT = Segment(
    transmission_force=-120.0,
    combined_loads=(70.0, 20.0),
    damage_increments=(2e-12, 3e-13),
)


def test_each_is_named_once_and_found_by_its_name():
    assert len(set(TOTALS)) == len(QUANTITIES)
    assert [place_of(quantity) for quantity in QUANTITIES] == list(
        range(len(QUANTITIES))
    )


def test_damages_add_up():
    first, second = (each.gather(1e-9, SEGMENT) for each in DAMAGES)
    assert (first, second) == pytest.approx((1.002e-9, 1.0003e-9), rel=1e-12)


@pytest.mark.parametrize(("before", "after"), [(0.0, 120.0), (130.0, 130.0)])
def test_the_peak_force_is_the_largest_whatever_its_sign(before, after):
    assert PEAK_FORCE.gather(before, SEGMENT) == after


def test_the_peak_loads_are_those_of_each_bearing():
    assert [each.gather(50.0, SEGMENT) for each in PEAK_LOADS] == [70.0, 50.0]


@pytest.mark.parametrize("quantity", QUANTITIES, ids=TOTALS)
def test_symbols_gather_as_numbers(quantity):
    before, force = ca.SX.sym("before"), ca.SX.sym("force")
    loads, damages = ca.SX.sym("loads", 2), ca.SX.sym("damages", 2)
    segment = Segment(force, ca.vertsplit(loads), ca.vertsplit(damages))
    gather = ca.Function(
        "gather", [before, force, loads, damages], [quantity.gather(before, segment)]
    )
    found = gather(
        60.0,
        SEGMENT.transmission_force,
        list(SEGMENT.combined_loads),
        list(SEGMENT.damage_increments),
    )
    assert float(found) == quantity.gather(60.0, SEGMENT)


@pytest.mark.parametrize("quantity", QUANTITIES, ids=TOTALS)
def test_segments_in_any_order_leave_the_same(quantity):
    rng = np.random.default_rng(1)
    segments = [
        Segment(force, loads, loads * 1e-14)
        for force, loads in zip(
            rng.normal(0.0, 90.0, 20), rng.uniform(1, 99, (20, 2)), strict=True
        )
    ]
    there = back = 0.0
    for segment in segments:
        there = quantity.gather(there, segment)
    for segment in reversed(segments):
        back = quantity.gather(back, segment)
    exact = quantity.gathering is Gathering.LARGEST
    assert there == pytest.approx(back, rel=0.0 if exact else 1e-12)

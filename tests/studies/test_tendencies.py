"""What the paper claims of stiffness, gap and bearings, on the shipped case."""

from dataclasses import replace

import numpy as np
import pytest

from coupling_design.parts.bearing.contact_stress import minimum_load
from studies import contact, gap, honest_reading, lubrication, resonance, stiffness
from studies.forces import deviation_from_line, reversals
from studies.machine import (
    high_stiffness_history,
    least_elastic_peak,
    present_history,
    present_performance,
)
from studies.paper_results import comparisons


@pytest.fixture(scope="module")
def coarse_gaps(shipped):
    return gap.examine(shipped, (0.0, 0.1e-3, 0.2e-3, 0.3e-3))


@pytest.fixture(scope="module")
def coarse_stiffnesses(shipped):
    return stiffness.examine(shipped, (0.5, 1.0, 1.1, 2.0))


def test_damage_falls_as_the_gap_closes(coarse_gaps):
    assert reversals(list(coarse_gaps.damages)) == (0, 0.0)
    assert coarse_gaps.tight.damage_e6 < coarse_gaps.sweep[-1].damage_e6


def test_collision_force_falls_more_than_transmission_force(coarse_gaps):
    closed, open_ = coarse_gaps.sweep[0], coarse_gaps.sweep[-1]
    collision = open_.collision_range - closed.collision_range

    assert collision > open_.transmission_range - closed.transmission_range > 0


def test_a_tight_fit_has_next_to_no_collision_force(coarse_gaps):
    tight = coarse_gaps.tight

    assert tight.collision_range < 0.01 * tight.transmission_range


def test_half_the_stiffness_does_more_damage(coarse_stiffnesses):
    half, now = coarse_stiffnesses.at(0.5), coarse_stiffnesses.at(1.0)

    assert half.damage_e6 > now.damage_e6
    assert half.transmission_peak > now.transmission_peak
    assert half.collision_peak > now.collision_peak


def test_a_slightly_stiffer_coupling_does_less(coarse_stiffnesses):
    now, stiffer = coarse_stiffnesses.at(1.0), coarse_stiffnesses.at(1.1)

    assert stiffer.damage_e6 < now.damage_e6
    assert stiffer.transmission_peak < now.transmission_peak
    assert stiffer.collision_peak < now.collision_peak


def test_bearing_2_never_reaches_its_limit(shipped):
    loads = present_performance(shipped).peak_combined_load

    assert loads[1] < minimum_load(shipped.bearings[1])
    assert loads[0] > minimum_load(shipped.bearings[0])


@pytest.mark.slow
def test_no_elastic_stiffness_keeps_the_limit(shipped):
    _, least = least_elastic_peak(shipped)

    assert least > 36_120.18


def test_the_resonance_lies_where_the_paper_has_it(shipped):
    found = resonance.examine(shipped)
    fast, slow = found.speeds_rpm

    assert 100 < found.force_swing.speed * resonance.RPM < 140
    assert slow < found.force_swing.speed * resonance.RPM < fast
    assert found.chosen.number >= 3


def test_number_of_swings_hardly_depends_on_the_window(shipped):
    numbers = [swings.number for swings in resonance.examine(shipped).swings]

    assert max(numbers) - min(numbers) <= 2


def test_life_falls_from_stage_to_stage(shipped):
    found = lubrication.examine(shipped)
    start, end, _ = found.stages
    parts = (
        found.time < start,
        (found.time >= start) & (found.time <= end),
        found.time > end,
    )
    factors, lives = (
        [np.median(values[part]) for part in parts]
        for values in (found.life_modification_factor, found.modified_life)
    )

    assert factors == sorted(factors, reverse=True)
    assert lives == sorted(lives, reverse=True)


def test_damage_of_the_history_is_that_of_the_rollout(shipped):
    history = present_history(shipped)
    damage = honest_reading.damage(shipped, history, small_loads=True)

    one = replace(shipped, shutdown=replace(shipped.shutdown, crank_angles=1))
    assert damage == pytest.approx(present_performance(one).damage, rel=1e-6)


def test_damage_below_the_limit_is_not_nothing(shipped):
    history = high_stiffness_history(shipped)
    everything, above = (
        honest_reading.damage(shipped, history, small) for small in (True, False)
    )

    assert 0 <= above < everything


def test_sigma_per_radian_makes_the_gap_push_back(shipped):
    keys = honest_reading.examine(shipped).keys
    contrasts = honest_reading.smoothing_unit(shipped)

    assert contrasts[0].first < -0.1
    assert contrasts[1].first > 0.5
    assert [row.second for row in contrasts] == [0.0, 0.0]
    assert list(keys) == ["per radian", "per metre", "per millimetre"]


@pytest.mark.slow
def test_the_resolved_contact_is_resolved(shipped):
    own = contact.at_half(shipped, shipped.hub_seat.contact_stiffness)

    assert own.is_resolved
    assert own.change > 0


@pytest.mark.slow
def test_damage_over_the_gap_is_a_line(shipped):
    found = gap.examine(shipped)

    assert reversals(list(found.damages)) == (0, 0.0)
    assert found.deviation < 10


@pytest.mark.slow
def test_what_disagrees_with_the_paper_says_why(shipped):
    for row in comparisons(shipped):
        assert row.agrees or row.remark


def test_deviation_from_a_line_by_hand():
    # 0, 0, 3 over 0, 1, 2: best line -0.5 + 1.5 x, off by 0.5, 1, 0.5 of 3
    x, y = np.array([0.0, 1.0, 2.0]), np.array([0.0, 0.0, 3.0])

    assert deviation_from_line(x, y) == pytest.approx(100 / 3)


def test_reversals_by_hand():
    assert reversals([1.0, 2.0, 1.9, 3.0]) == (1, pytest.approx(5.0))

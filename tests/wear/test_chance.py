import dataclasses
import math

import numpy as np
import pytest

from coupling_design.line.parameters import (
    FuelCutStart,
    QuasiSteadyStart,
    SettledStart,
    Shutdown,
)
from coupling_design.wear.chance import chances, describe_start
from coupling_design.wear.quantities import TOTALS
from coupling_design.wear.totals import over_chance, spread_of

TURN = 2 * math.pi
PERIOD = math.pi  # of orders 2 and 4, those of the quick case


@pytest.fixture
def turned(quick, with_shutdown):
    """Return the quick case with a crank angle and a gravity angle of its own."""
    return with_shutdown(quick, crank_angle=0.3, gravity_angle=0.7)


@pytest.mark.parametrize("n", [1, 2, 3, 5, 8, 24])
def test_the_first_run_down_is_the_cases_own(turned, n):
    assert chances(turned, n)[:, 0] == pytest.approx([0.3, 0.7])


@pytest.mark.parametrize("n", [1, 2, 3, 5, 8, 24])
def test_each_angle_is_taken_once(turned, n):
    crank, gravity = chances(turned, n)
    assert sorted(crank - 0.3) == pytest.approx(PERIOD * np.arange(n) / n)
    assert sorted(gravity - 0.7) == pytest.approx(TURN * np.arange(n) / n)


def test_gravity_leaps_by_three_eighths_of_a_turn_among_eight(turned):
    """(3 - sqrt 5) / 2 of eight is 3.06."""
    gravity = (chances(turned, 8)[1] - 0.7) / TURN * 8
    assert gravity == pytest.approx([0, 3, 6, 1, 4, 7, 2, 5])


def totals(*columns):
    return np.array(columns, dtype=float).T


RUN_DOWNS = totals(
    # D1, D2, peak force, load 1, load 2
    (1e-9, 5e-11, 100.0, 70.0, 20.0),
    (3e-9, 1e-11, 120.0, 60.0, 30.0),
    (2e-9, 3e-11, 110.0, 90.0, 10.0),
)


def test_the_totals_of_the_tests_are_those_of_a_run_down():
    assert len(RUN_DOWNS) == len(TOTALS)


def test_damage_is_the_mean_and_each_peak_the_largest():
    assert over_chance(RUN_DOWNS) == pytest.approx([2e-9, 3e-11, 120.0, 90.0, 30.0])


def test_a_peaks_slope_is_that_of_the_run_down_that_has_it():
    slopes = np.arange(15.0).reshape(5, 3)  # rows 0 1 2, 3 4 5, 6 7 8, ...
    judged = over_chance(RUN_DOWNS, slopes)
    assert judged.shape == (5, 2)
    assert judged[:, 0] == pytest.approx(over_chance(RUN_DOWNS))
    assert judged[:, 1] == pytest.approx([1.0, 4.0, 7.0, 11.0, 13.0])


def test_one_run_down_is_judged_by_itself():
    assert over_chance(RUN_DOWNS[:, :1]) == pytest.approx(RUN_DOWNS[:, 0])


def test_spread_by_hand():
    speeds = np.array([[0.1, -0.4, 0.2], [0.0, 0.3, 0.1]])
    spread = spread_of(RUN_DOWNS, speeds, repeats=False)
    assert spread.crank_angles == 3
    assert spread.damages == ((1e-9, 3e-9), (1e-11, 5e-11))
    assert spread.peak_transmission_force == (100.0, 120.0)
    assert spread.mean_peak == pytest.approx(110.0)
    assert spread.worst == 1
    assert spread.final_speed == 0.4
    assert not spread.repeats


@pytest.mark.parametrize(
    ("start", "words"),
    [
        (SettledStart(), "settled vibration of the engine turned without fuel"),
        (QuasiSteadyStart(), "no vibration yet"),
        (FuelCutStart(0.0), "gone at once"),
        (FuelCutStart(0.231), "taken away over 0.231 s"),
    ],
)
def test_a_start_is_told_in_words(start, words):
    assert words in describe_start(Shutdown(50.0, 1.0, 1e-3, start))


def test_a_result_is_judged_over_the_shutdowns_crank_angles(
    quick, with_shutdown, evaluator
):
    """The mean of three run-downs of one angle each, and the largest peak of them."""
    three = with_shutdown(quick, crank_angles=3)
    together = evaluator(three, "rubber", "key").performance(2e3, 1e-4)
    apart = [
        evaluator(
            with_shutdown(quick, crank_angle=crank, gravity_angle=gravity),
            "rubber",
            "key",
        ).performance(2e3, 1e-4)
        for crank, gravity in chances(three, 3).T.tolist()
    ]
    assert together.damages[0] == pytest.approx(
        sum(each.damages[0] for each in apart) / 3, rel=1e-9
    )
    assert together.peak_transmission_force == pytest.approx(
        max(each.peak_transmission_force for each in apart), rel=1e-9
    )
    assert dataclasses.asdict(together.spread)["crank_angles"] == 3

"""Sums over orders, and the speeds that a chart is made of."""

import dataclasses

import numpy as np
import pytest

from coupling_design.line.forced_response import power_loss, vibratory_torque
from coupling_design.line.parameters import ExcitationOrder
from coupling_design.speeds.vibration import (
    evaluate_vibration,
    operating_points,
)

WORKING = (41.9, 104.7)


@pytest.fixture(scope="module")
def vibration(paper):
    return evaluate_vibration(paper.driveline, 110.0, (*WORKING, 14.76, 7.38, 400.0))


def test_speeds_are_those_asked_for_and_rise(vibration):
    speeds = vibration.speeds
    assert np.all(np.diff(speeds) > 0)
    assert speeds[0] > 0
    assert speeds[-1] == 110.0
    assert np.isin([*WORKING, 14.76, 7.38], speeds).all()


def test_amplitudes_are_those_of_the_driveline(paper, vibration):
    speeds = vibration.speeds
    torque = vibratory_torque(paper.driveline, speeds)
    assert np.array_equal(vibration.vibratory_torque, torque)
    assert np.array_equal(vibration.power_loss, power_loss(paper.driveline, speeds))
    stiffness = paper.driveline.coupling.torsional_stiffness
    assert np.all(vibration.twist * stiffness <= torque)


def test_sums_by_hand(vibration):
    first, second = vibration.vibratory_torque
    assert vibration.vibratory_torque_sum == pytest.approx(first + second)
    rms = np.sqrt(first**2 / 2 + second**2 / 2)
    assert vibration.vibratory_torque_rms == pytest.approx(rms)


def test_sums_bound_what_the_phases_make(paper, vibration):
    """Over a turn both orders together reach no more than the sum, with its rms."""
    at = 200
    first, second = vibration.vibratory_torque[:, at]
    angle = np.linspace(0, 2 * np.pi, 4096, endpoint=False)
    for phase in (0.0, 0.7, 2.0):
        torque = first * np.sin(4 * angle) + second * np.sin(8 * angle + phase)
        assert torque.max() <= vibration.vibratory_torque_sum[at]
        rms = vibration.vibratory_torque_rms[at]
        assert np.sqrt(np.mean(torque**2)) == pytest.approx(rms, rel=1e-9)


def test_one_order_alone(paper):
    line = dataclasses.replace(
        paper.driveline, excitation=(ExcitationOrder(4.0, 100.0, 0.0),)
    )
    found = evaluate_vibration(line, 110.0, ())
    assert np.array_equal(found.vibratory_torque[0], found.vibratory_torque_sum)
    expected = found.vibratory_torque[0] / np.sqrt(2)
    assert found.vibratory_torque_rms == pytest.approx(expected)


def test_operating_points_are_points_of_the_curves(vibration):
    points = operating_points(vibration, WORKING)
    assert [p.speed for p in points[:2]] == list(WORKING)
    for point in points:
        at = np.flatnonzero(vibration.speeds == point.speed)[0]
        assert point.vibratory_torque == tuple(vibration.vibratory_torque[:, at])
        assert point.vibratory_torque_sum == vibration.vibratory_torque_sum[at]
        assert point.power_loss == vibration.power_loss[at]


def test_the_worst_is_the_worst(vibration):
    _, _, in_range, of_all = operating_points(vibration, WORKING)
    total, speeds = vibration.vibratory_torque_sum, vibration.speeds
    working = (speeds >= WORKING[0]) & (speeds <= WORKING[1])
    assert of_all.vibratory_torque_sum == total.max()
    assert in_range.vibratory_torque_sum == total[working].max()
    assert WORKING[0] <= in_range.speed <= WORKING[1]

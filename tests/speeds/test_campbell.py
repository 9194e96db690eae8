"""Critical speeds, separation margins and order lines, worked by hand."""

import dataclasses
import math

import numpy as np
import pytest

from coupling_design.line.modes import natural_angular_frequency
from coupling_design.line.parameters import ExcitationOrder
from coupling_design.speeds.campbell import (
    CriticalSpeed,
    Position,
    critical_speeds,
    natural_frequencies,
    order_lines,
    separation_margin,
)

RPM = math.pi / 30
WORKING = (400 * RPM, 1000 * RPM)


def driven_by(driveline, *orders):
    excitation = tuple(ExcitationOrder(order, 100.0, 0.0) for order in orders)
    return dataclasses.replace(driveline, excitation=excitation)


def test_natural_frequencies_of_three_masses(keyed):
    # test_modes works them: w^2 = 13 409.53 and 596 590.47, roots 115.79953, 772.39269
    expected = [18.43007, 122.93012]
    assert natural_frequencies(keyed) == pytest.approx(expected, rel=1e-6)


def test_a_tight_fit_has_one(tight):
    # 120.60454 / (2 pi)
    assert natural_frequencies(tight) == pytest.approx([19.194809], rel=1e-6)


def test_the_lowest_is_the_one_the_design_uses(keyed):
    expected = natural_angular_frequency(keyed) / (2 * math.pi)
    assert natural_frequencies(keyed)[0] == pytest.approx(expected, rel=1e-12)


def test_order_lines_by_hand(keyed):
    # Order 4 at 600 rpm, 10 turns a second: 40 Hz.
    line = driven_by(keyed, 4.0, 8.0)
    lines = order_lines(line, np.array([0.0, 600 * RPM]))
    assert lines == pytest.approx(np.array([[0.0, 40.0], [0.0, 80.0]]))


def test_critical_speeds_by_hand(keyed):
    """Work them as 60 f_n / order, in rpm.

    Mode 1: 18.43007 * 60 / 4 = 276.451 and, order 8, 138.2255; mode 2: 122.93012 * 60 /
    4 = 1843.952 and 921.976. Margins: (400 - 138.2255) / 400 = 0.654436,
    (400 - 276.451) / 400 = 0.308872, (921.976 - 1000) / 1000 = -0.078024 and
    (1843.952 - 1000) / 1000 = 0.843952.
    """
    found = critical_speeds(driven_by(keyed, 4.0, 8.0), WORKING)

    speeds = [critical.speed / RPM for critical in found]
    assert speeds == pytest.approx([138.2255, 276.451, 921.976, 1843.952], rel=2e-6)
    assert [(c.order, c.mode) for c in found] == [(8, 1), (4, 1), (8, 2), (4, 2)]
    margins = [critical.separation_margin for critical in found]
    assert margins == pytest.approx([0.654436, 0.308872, -0.078024, 0.843952], abs=2e-6)
    below, inside, above = Position.BELOW, Position.INSIDE, Position.ABOVE
    assert [c.position for c in found] == [below, below, inside, above]
    assert [c.passes for c in found] == [True, True, False, True]


def test_an_order_line_passes_through_each_critical_speed(keyed):
    line = driven_by(keyed, 0.5, 3.0)
    for critical in critical_speeds(line, WORKING):
        frequencies = order_lines(line, np.array([critical.speed]))
        row = [0.5, 3.0].index(critical.order)
        assert frequencies[row, 0] == pytest.approx(critical.natural_frequency)


@pytest.mark.parametrize(
    ("rpm", "margin"),
    [
        (360, 0.1),  # (400 - 360) / 400
        (1100, 0.1),  # (1100 - 1000) / 1000
        (400, 0.0),
        (1000, 0.0),
        (500, -0.25),  # 100 rpm from 400
        (900, -0.1),  # 100 rpm from 1000
    ],
)
def test_separation_margin_by_hand(rpm, margin):
    assert separation_margin(rpm * RPM, WORKING) == pytest.approx(margin, abs=1e-12)


def critical_at(driveline, speed):
    """Return the critical speed of an order that meets the line there."""
    order = float(natural_angular_frequency(driveline)) / speed
    [found] = critical_speeds(driven_by(driveline, order), WORKING)
    assert isinstance(found, CriticalSpeed)
    return found


def test_ten_per_cent_is_enough(tight):
    assert critical_at(tight, 359.9 * RPM).passes
    assert not critical_at(tight, 360.1 * RPM).passes
    assert critical_at(tight, 1100.1 * RPM).passes
    assert not critical_at(tight, 1099.9 * RPM).passes


@pytest.mark.parametrize("rpm", [400.01, 700, 999.99])
def test_inside_the_range(tight, rpm):
    found = critical_at(tight, rpm * RPM)
    assert found.position is Position.INSIDE
    assert found.separation_margin < 0
    assert not found.passes


def test_stiffer_is_faster(keyed):
    line = driven_by(keyed, 4.0, 8.0)
    speeds = []
    for stiffness in (1e4, 1e5, 1e6, 1e7):
        coupling = dataclasses.replace(line.coupling, torsional_stiffness=stiffness)
        stiffer = dataclasses.replace(line, coupling=coupling)
        speeds.append([c.speed for c in critical_speeds(stiffer, WORKING)])
    assert np.all(np.diff(speeds, axis=0) > 0)


def test_no_excitation_no_critical_speed(keyed):
    assert critical_speeds(driven_by(keyed), WORKING) == ()

"""The speed map as text: a hand-made one, and the 16V280's."""

import dataclasses
import math
import re

import numpy as np
import pytest

from coupling_design.flow.speed_map import (
    CouplingSpeeds,
    ForbiddenBand,
    SpeedMap,
    evaluate_speed_map,
)
from coupling_design.machine.words import Plan
from coupling_design.report.console.console import plain_text
from coupling_design.report.console.speeds import render_speed_map
from coupling_design.speeds.campbell import CriticalSpeed, Position
from coupling_design.speeds.vibration import OperatingPoint, SteadyVibration

WIDTHS = (80, 120)
RPM = math.pi / 30
NOTHING = np.zeros(0)
POINTS = tuple(
    OperatingPoint(name, rpm * RPM, (first, second), total, rms, 0.9 * total, loss)
    for name, rpm, first, second, total, rms, loss in (
        ("lowest working speed", 400, 118.0, 6.15, 124.1, 83.54, 0.927),
        ("highest working speed", 1000, 23.7, 1.78, 25.5, 16.78, 0.119),
        ("worst of the working range", 563, 3201.0, 40.0, 3241.0, 2263.0, 100.5),
        ("worst of all speeds", 140, 4694.0, 49.6, 4743.6, 3320.0, 213.0),
    )
)
SOFT = CouplingSpeeds(
    name="present",
    label="steel-spring [bold], key",
    torsional_stiffness=0.4904e6,
    natural_frequencies=np.array([9.3956, 476.438]),
    critical_speeds=(
        CriticalSpeed(140.93 * RPM, 4.0, 1, 9.3956, Position.BELOW, 0.64768, True),
        CriticalSpeed(563.74 * RPM, 1.0, 1, 9.3956, Position.INSIDE, -0.40934, False),
        CriticalSpeed(1085.0 * RPM, 9.0, 1, 9.3956, Position.ABOVE, 0.085, False),
    ),
    forbidden_bands=(
        ForbiddenBand(4.0, Plan.ELASTIC, 199.31 * RPM, False),
        ForbiddenBand(1.0, Plan.ELASTIC, 797.24 * RPM, True),
    ),
    vibration=SteadyVibration(*[NOTHING] * 7),
    operating_points=POINTS,
)
STIFF = dataclasses.replace(
    SOFT,
    name="chosen",
    label="diaphragm, tight fit",
    torsional_stiffness=192.8e6,
    natural_frequencies=np.array([188.586]),
    critical_speeds=(
        CriticalSpeed(1414.39 * RPM, 8.0, 1, 188.586, Position.ABOVE, 0.41439, True),
    ),
    forbidden_bands=(ForbiddenBand(8.0, Plan.HIGH_STIFFNESS, 1000.13 * RPM, False),),
)
MAP = SpeedMap(
    orders=np.array([1.0, 4.0]),
    working_speed=(400 * RPM, 1000 * RPM),
    speeds=np.array([0.0, 1100 * RPM]),
    order_lines=np.zeros((2, 2)),
    present=SOFT,
    chosen=STIFF,
)


def flat(text):
    """Return a report's words in one line, without borders and line breaks."""
    return " ".join(re.sub(r"[│╭╮╰╯─]", " ", text).split())


@pytest.fixture(scope="module")
def shown(case):
    return lambda speed_map, width: plain_text(render_speed_map(case, speed_map), width)


@pytest.mark.parametrize("width", WIDTHS)
def test_fits_and_loses_nothing(case, shown, width):
    for speed_map in (MAP, evaluate_speed_map(case)):
        text = shown(speed_map, width)
        assert max(map(len, text.splitlines())) <= width
        assert "…" not in text
        assert "\x1b" not in text
        assert not re.search(r"[ \t]+$", text, re.MULTILINE)


@pytest.mark.parametrize("width", WIDTHS)
@pytest.mark.parametrize(
    "fact",
    [
        "Campbell diagram and steady vibration: 16V280",
        "working speed 400 to 1000 rpm",
        "diagram 0 to 1100 rpm",
        "excitation orders 1, 4",
        "coupling steel-spring [bold], key",
        "C_Tdyn 0.4904 MN*m/rad",
        "natural frequencies 9.396, 476.4 Hz",
        "4 1 9.396 140.9 +64.77 below PASS",
        "1 1 9.396 563.7 -40.93 inside FAIL",
        "9 1 9.396 1085 +8.50 above FAIL",
        "4 199.3 below elastic PASS",
        "1 797.2 below elastic FAIL",
        "Chosen coupling",
        "8 1 188.6 1414 +41.44 above PASS",
        "8 1000 above high stiffness PASS",
        "speed 400.0 1000 563.0 140.0 rpm",
        "T_W of order 1 0.1180 0.02370 3.201 4.694 kN*m",
        "T_W of order 4 0.006150 0.001780 0.04000 0.04960 kN*m",
        "T_W, sum 0.1241 0.02550 3.241 4.744 kN*m",
        "T_W, rms 0.08354 0.01678 2.263 3.320 kN*m",
        "at the connection, sum 0.1117 0.02295 2.917 4.269 kN*m",
        "power loss P_W 0.9270 0.1190 100.5 213.0 W",
        "Dry friction does not depend on speed",
    ],
)
def test_says(shown, width, fact):
    assert fact in flat(shown(MAP, width))


def test_without_a_chosen_coupling(shown):
    alone = dataclasses.replace(MAP, chosen=None)
    assert "Chosen coupling" not in shown(alone, 80)


@pytest.mark.parametrize("width", WIDTHS)
def test_of_the_16v280(case, shown, width):
    text = flat(shown(evaluate_speed_map(case), width))
    assert "8 1 9.396 70.47 +82.38 below PASS" in text
    assert "4 1 9.396 140.9 +64.77 below PASS" in text
    assert "FAIL" not in text


def test_many_orders_fit(case, shown):
    """An engine has two dozen; they go down the page, not across."""
    many = tuple(0.5 * i for i in range(1, 25))
    excitation = tuple(
        dataclasses.replace(case.driveline.excitation[0], order=order) for order in many
    )
    driveline = dataclasses.replace(case.driveline, excitation=excitation)
    text = shown(evaluate_speed_map(dataclasses.replace(case, driveline=driveline)), 80)
    assert max(map(len, text.splitlines())) <= 80
    assert "T_W of order 11.5" in text

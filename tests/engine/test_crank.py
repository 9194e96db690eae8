import math

import numpy as np
import pytest

from coupling_design.engine.crank import (
    cylinder_volume,
    lever_slope,
    piston_lever,
    piston_travel,
)

ANGLES = np.linspace(0.0, 2 * math.pi, 73)


def test_dead_centres(cylinder):
    assert piston_travel(0.0, cylinder) == pytest.approx(0.0, abs=1e-15)
    assert piston_travel(math.pi, cylinder) == pytest.approx(0.285)
    assert piston_lever(np.array([0, math.pi]), cylinder) == pytest.approx(0, abs=1e-15)
    volumes = cylinder_volume(np.array([math.pi, 0.0]), cylinder)
    assert volumes[0] / volumes[1] == pytest.approx(12.5)


def test_a_quarter_turn_by_hand(cylinder):
    # a = 142.5 mm, l = 142.5 / 0.245 = 581.633 mm:
    # l + a - sqrt(l^2 - a^2) = 724.133 - 563.906 = 160.226 mm; the lever is a.
    assert piston_travel(math.pi / 2, cylinder) == pytest.approx(0.160226, abs=1e-6)
    assert piston_lever(math.pi / 2, cylinder) == pytest.approx(0.1425)


def test_derivatives_agree_with_differences(cylinder):
    h = 1e-5
    around = ANGLES + h, ANGLES - h
    lever = np.subtract(*(piston_travel(a, cylinder) for a in around)) / (2 * h)
    slope = np.subtract(*(piston_lever(a, cylinder) for a in around)) / (2 * h)
    assert piston_lever(ANGLES, cylinder) == pytest.approx(lever, abs=1e-10)
    assert lever_slope(ANGLES, cylinder) == pytest.approx(slope, abs=1e-10)

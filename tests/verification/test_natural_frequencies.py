"""Torsional natural frequencies of published systems and of another program.

Sources
-------
[1] openTorsion, its test of two masses and its examples (Aalto University).
[2] TMS26, torsional benchmark 004, two discs, solved analytically.
[3] Friswell, Penny, Garvey, Lees (2010), Dynamics of Rotating Machines: geared branch,
    425.4, 634.1 and 3247.2 Hz. Its two branches are equal: against each other they
    swing on their own shafts, together they are one disc on both, so that the system
    falls into two masses held by a gear and three masses in a row.
[4] openTorsion 0.3.2, eigenvalues of an assembly of three discs and two shafts.
"""

import math

import numpy as np
import pytest

from coupling_design.line.modes import modes, natural_angular_frequency
from tests.verification.comparison import Comparison, collect, disagreements
from tests.verification.drivelines import three_masses, two_masses

RANDOM_LINES = 10


def hertz(angular_frequency):
    return float(angular_frequency) / (2 * math.pi)


def two_mass_system():
    driveline = two_masses(211.4, 8.3, 9.775e6)
    return [
        Comparison(
            "natural frequency, two masses of 211.4 and 8.3 kg m^2 on 9.775e6 N m/rad",
            "openTorsion, test of two masses",
            176.1,
            hertz(natural_angular_frequency(driveline)),
            "Hz",
            0.05,
        ),
    ]


def analytic_benchmark():
    driveline = two_masses(0.10, 0.20, 1000.0)
    found = modes(driveline)
    source = "TMS26 benchmark 004, analytic"
    return [
        Comparison(
            "natural angular frequency, two masses of 0.1 and 0.2 kg m^2",
            source,
            122.474487139158910,
            float(natural_angular_frequency(driveline)),
            "rad/s",
            1e-12,
        ),
        Comparison(
            "natural frequency of the same from the eigenvalues",
            source,
            19.492420030841906,
            hertz(found.angular_frequencies[1]),
            "Hz",
            1e-12,
        ),
        Comparison(
            "mode of the same, second mass to first",
            source,
            -0.5,
            float(found.shapes[1, 1] / found.shapes[0, 1]),
            "-",
            1e-12,
        ),
    ]


def geared_branch():
    # Main disc 400e-6 on 10 000 N m/rad to two gears of 25e-6; from them 5000 N m/rad
    # each to discs of 700e-6. In step, the two branches are one of 10 000 and 1400e-6.
    together = modes(three_masses((400e-6, 50e-6, 1400e-6), (10e3, 10e3)))
    # Out of step the gears stand still: a disc against an immovable mass.
    apart = two_masses(700e-6, 700e-6 * 1e12, 5e3)
    remark = "its two equal branches in step: three masses in a row"
    source = "Friswell et al. (2010), geared branch"
    return [
        Comparison(
            "first natural frequency, geared branch",
            source,
            425.4,
            hertz(natural_angular_frequency(apart)),
            "Hz",
            0.05,
            "its two equal branches out of step: each on its own shaft",
        ),
        Comparison(
            "second natural frequency, geared branch",
            source,
            634.1,
            hertz(together.angular_frequencies[1]),
            "Hz",
            0.05,
            remark,
        ),
        Comparison(
            "third natural frequency, geared branch",
            source,
            3247.2,
            hertz(together.angular_frequencies[2]),
            "Hz",
            0.05,
            remark,
        ),
    ]


def open_torsion_side_by_side():
    """Compare ten random lines, each from a gentle to a very stiff key."""
    pytest.importorskip(
        "opentorsion", reason="openTorsion comes with the extra named test"
    )
    rng = np.random.default_rng(20231)
    return [
        comparison
        for number in range(1, RANDOM_LINES + 1)
        for comparison in _side_by_side(number, rng)
    ]


def _side_by_side(number, rng):
    inertias = np.exp(rng.uniform(np.log([10, 0.5, 10]), np.log([500, 20, 1000])))
    stiffnesses = np.exp(rng.uniform(np.log([1e5, 1e7]), np.log([1e8, 1e9])))
    ours = modes(three_masses(inertias, stiffnesses)).angular_frequencies
    theirs = open_torsion_frequencies(inertias, stiffnesses)
    text = ", ".join(f"{value:.4g}" for value in (*inertias, *stiffnesses))
    # Both find eigenvalues with an error of some 1e-16 of the largest one's square.
    rounding = 1e-14 * theirs[2] ** 2
    return [
        Comparison(
            f"{name} natural frequency, random line {number}",
            "openTorsion, side by side",
            hertz(theirs[i]),
            hertz(ours[i]),
            "Hz",
            hertz(rounding / theirs[i]),
            f"J1, J2, J3 [kg m^2], k, k_g [N m/rad] = {text}",
        )
        for i, name in ((1, "first"), (2, "second"))
    ]


def open_torsion_assembly(inertias, stiffnesses, dampings=(0.0, 0.0)):
    """Return the same line as openTorsion builds it."""
    import opentorsion

    shafts = [
        opentorsion.Shaft(i, i + 1, k=k, c=c)
        for i, (k, c) in enumerate(zip(stiffnesses, dampings, strict=True))
    ]
    discs = [opentorsion.Disk(i, I=inertia) for i, inertia in enumerate(inertias)]
    return opentorsion.Assembly(shafts, disk_elements=discs)


def open_torsion_frequencies(inertias, stiffnesses):
    """Return its natural angular frequencies, ascending [rad/s]."""
    squares, _ = open_torsion_assembly(inertias, stiffnesses).undamped_modal_analysis()
    return np.sqrt(np.maximum(np.sort(squares.real), 0.0))


GROUPS = (
    two_mass_system,
    analytic_benchmark,
    geared_branch,
    open_torsion_side_by_side,
)


def comparisons():
    """Return what this module compares."""
    return collect(GROUPS)


@pytest.mark.parametrize("group", GROUPS)
def test_agrees_with_its_source(group):
    assert disagreements(group) == []


def test_closed_form_of_the_random_lines():
    """What the design flow uses must agree with what was compared above."""
    rng = np.random.default_rng(20232)
    for _ in range(RANDOM_LINES):
        inertias = np.exp(rng.uniform(np.log([10, 0.5, 10]), np.log([500, 20, 1000])))
        stiffnesses = np.exp(rng.uniform(np.log([1e5, 1e7]), np.log([1e8, 1e9])))
        driveline = three_masses(inertias, stiffnesses)
        squares = modes(driveline).angular_frequencies ** 2

        error = natural_angular_frequency(driveline) ** 2 - squares[1]
        assert abs(error) < 1e-14 * squares[2]

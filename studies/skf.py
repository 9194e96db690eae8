"""The bearing's life beside SKF's published examples, and why a_SKF is another factor.

Sources
-------
[1] SKF catalogue, example 1, bearing 6309.
[2] SKF Bearing Calculator report, bearing 6309.
[3] SKF Rolling bearings 2018, centrifugal pump: NU 311 ECP, 7312 BECBP.
[4] ISO 281:2007, clause 9.3.
"""

from __future__ import annotations

import math

from coupling_design.parts.bearing.life import (
    basic_rating_life,
    fatigue_load_limit,
    life_modification_factor,
)
from coupling_design.parts.bearing.lubrication import (
    reference_viscosity,
    viscosity_at_temperature,
)
from coupling_design.parts.bearing.parameters import Bearing, BearingType
from studies.judgement import Contrast
from tests.verification.comparison import Comparison

RPM = math.pi / 30

# fmt: off
# SKF's examples: their kappa, eta_c P_u / P, a_SKF and, by hand, ISO's ball formula.
SKF_FACTORS = (
    ("6309 (catalogue, example 1)",  2.45, 0.8 * 1.34 / 10,   8.0,  5.52),
    ("6309 (Bearing Calculator)",    2.08, 0.55 * 1.34 / 4,  20.7, 13.20),
    ("7312 BECBP pair (pump)",       1.8,  0.2 * 6.4 / 11.52, 5.0,  4.55),
)
# fmt: on


def _bearing(
    name: str, kind: str, C_kN: float, D_pw_mm: float, C_0_kN: float
) -> Bearing:
    return Bearing(
        name=name,
        designation=name,
        type=BearingType(kind),
        dynamic_load_rating=C_kN * 1e3,
        static_load_rating=C_0_kN * 1e3,
        pitch_diameter=D_pw_mm * 1e-3,
        stress_coefficient=3.62e6,
        minimum_stress=800e6,
    )


# The static ratings of SKF's bearings play no part in what is compared.
SKF_6309 = _bearing("6309", "radial_ball", 55.3, 72.5, 1.0)
NU_311 = _bearing("NU 311 ECP", "radial_roller", 156, 87.5, 1.0)
NU2326 = _bearing("NU2326", "radial_roller", 920, 205, 1230)


def comparisons() -> list[Comparison]:
    """Return C/P, L10 and viscosity of SKF's examples, and a_ISO with its inputs."""
    return [*lives(), *conditions()]


def lives() -> list[Comparison]:
    """Return C/P and L10 of SKF's examples."""
    report, pump = "SKF report on 6309", "SKF Rolling bearings 2018, NU 311 ECP"
    catalogue = "SKF catalogue, example 1, 6309"
    millions = float(basic_rating_life(10e3, SKF_6309)) / 1e6
    of_6309 = SKF_6309.dynamic_load_rating / 4e3
    of_pump = NU_311.dynamic_load_rating / 3.29e3
    rows = (
        ("L10, ball", catalogue, 169.0, millions, "1e6 rev", 0.5, ""),
        ("L10h, ball", catalogue, 940.0, hours(10e3, 3000, SKF_6309), "h", 5.0, ""),
        ("C/P, ball", report, 13.8, of_6309, "-", 0.05, ""),
        ("L10h, ball", report, 24_500.0, hours(4e3, 1800, SKF_6309), "h", 50.0, ""),
        ("C/P, roller", pump, 47.0, of_pump, "-", 0.5, ""),
        (
            "L10h, roller, 3000 rpm",
            "C/P of SKF's NU 311 ECP, by hand",
            2.14e6,
            hours(3.29e3, 3000, NU_311),
            "h",
            5e3,
            "SKF's own figure was not found",
        ),
    )
    return [Comparison(*row) for row in rows]


def hours(load: float, speed_rpm: float, bearing: Bearing) -> float:
    """Return L10 in hours."""
    return float(basic_rating_life(load, bearing)) / (60 * speed_rpm)


def conditions() -> list[Comparison]:
    """Return the oil's viscosity of [2], and a_ISO of [4] with SKF's inputs."""
    at_80 = float(viscosity_at_temperature(353.15, 120e-6, 12e-6)) * 1e6
    return [
        Comparison(
            "viscosity at 80 degrees C of 120 and 12 mm^2/s at 40 and 100",
            "SKF report on 6309, kappa nu_1 = 2.08 x 10.4",
            2.08 * 10.4,
            at_80,
            "mm^2/s",
            0.11,
            "its factors have three digits",
        ),
        *(
            Comparison(
                f"a_ISO, radial ball, kappa = {kappa:g}, e_C C_u / P = {x:.3f}",
                "ISO 281:2007 clause 9.3, by hand",
                by_hand,
                iso_factor(kappa, x),
                "-",
                0.005,
                f"with SKF's inputs for {name}",
            )
            for name, kappa, x, _, by_hand in SKF_FACTORS
        ),
    ]


def contrasts() -> list[Contrast]:
    """Return why SKF's factors are not compared: another model, in numbers."""
    ratios = [skf / iso_factor(kappa, x) for _, kappa, x, skf, _ in SKF_FACTORS]
    found = [
        Contrast(
            f"How much does lubrication lengthen the life of {name}?",
            "SKF, a_SKF",
            skf,
            "ISO 281, a_ISO",
            iso_factor(kappa, x),
            "-",
            "ISO 281",
            f"Same kappa = {kappa:g} and same e_C C_u / P = {x:.3f}; a_SKF is "
            f"{skf / iso_factor(kappa, x):.2f} times a_ISO. Over the three examples "
            f"the ratio is {min(ratios):.2f} to {max(ratios):.2f}, so that no one "
            "factor turns one into the other: SKF's is a model of its own.",
        )
        for name, kappa, x, skf, _ in SKF_FACTORS
    ]
    for n, skf in ((3000.0, 8.15), (1800.0, 10.4)):
        ours = float(reference_viscosity(n * RPM, SKF_6309)) * 1e6
        found.append(
            Contrast(
                f"Which viscosity does 6309 need at {n:g} rpm?",
                "SKF's diagram",
                skf,
                "ISO 281, nu_1",
                ours,
                "mm^2/s",
                "ISO 281",
                f"ISO asks for {ours / skf:.2f} times SKF's value, so its kappa is "
                "lower by that.",
            )
        )
    return found


def iso_factor(kappa: float, load_ratio: float) -> float:
    """Return a_ISO of a radial ball bearing at e_C C_u / P."""
    load = fatigue_load_limit(SKF_6309) / load_ratio
    return float(life_modification_factor(load, kappa, 1.0, SKF_6309))

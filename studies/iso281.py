"""The bearing's life beside ISO 281:2007 and ASTM D341.

Sources
-------
[1] ISO 281:2007: table 12, clause 9.3, Annexes A (grease) and B.
[2] Advances in Mechanical Engineering 2023, doi 10.1177/16878132231190062.

"By hand" is worked from the printed constants, apart from this program. A published
worked example of ISO's own with kappa, e_C, C_u and a_ISO was not found.
"""

from __future__ import annotations

from itertools import product

from coupling_design.parts.bearing.life import (
    fatigue_load_limit,
    life_modification_factor,
    reliability_factor,
)
from coupling_design.parts.bearing.lubrication import (
    contamination_factor,
    reference_viscosity,
    viscosity_at_temperature,
    viscosity_ratio,
)
from coupling_design.parts.bearing.parameters import Cleanliness
from studies.skf import NU2326, RPM, SKF_6309
from tests.verification.comparison import Comparison

BY_HAND = "ISO 281:2007 {}, by hand"

# fmt: off
# [1] clause 9.3, radial roller, by hand with the constants as printed.
LOAD_RATIOS = (0.05, 0.2, 0.5, 1.0)  # e_C C_u / P
ROLLER_TABLE = {
    # kappa: a_ISO
    0.15: (0.1101, 0.1183, 0.1276,  0.1381),
    0.3:  (0.1295, 0.1575, 0.1941,  0.2424),
    0.5:  (0.1653, 0.2443, 0.3737,  0.5947),
    0.8:  (0.2371, 0.4759, 1.0439,  2.5576),
    1.0:  (0.2797, 0.6505, 1.7141,  5.3106),
    2.0:  (0.3374, 0.9337, 3.0813, 12.9267),
    4.0:  (0.4048, 1.3350, 5.5869, 32.9195),
}
# [1] table 12.
RELIABILITY = {0.90: 1.0, 0.95: 0.64, 0.96: 0.55, 0.97: 0.47, 0.98: 0.37, 0.99: 0.25}
# [1] Annex A, grease, D_pw = 205 mm, by hand: e_C at kappa = 1 and at 0.3.
GREASE = {
    "high":           (0.88474, 0.62985),
    "normal":         (0.65095, 0.28707),
    "slight_typical": (0.22487, 0.09917),
    "severe":         (0.11786, 0.05198),
    "very_severe":    (0.03590, 0.01583),
}
# fmt: on


def comparisons() -> list[Comparison]:
    """Return everything that is compared."""
    groups = (factors, continuity, reliabilities, dirt, viscosities)
    return [row for group in groups for row in group()]


def factors() -> list[Comparison]:
    """Return a_ISO of roller bearings against the table, and their C_u."""
    C_u = fatigue_load_limit(NU2326)
    found = [
        Comparison(
            f"a_ISO, radial roller, kappa = {kappa:g}, e_C C_u / P = {x:g}",
            BY_HAND.format("clause 9.3"),
            ROLLER_TABLE[kappa][column],
            float(life_modification_factor(C_u / x, kappa, 1.0, NU2326)),
            "-",
            5.1e-5,
        )
        for kappa, (column, x) in product(ROLLER_TABLE, enumerate(LOAD_RATIOS))
    ]
    return [
        *found,
        Comparison(
            "C_u of NU2326",
            BY_HAND.format("Annex B"),
            120_938.6,
            float(C_u),
            "N",
            0.05,
        ),
    ]


def continuity() -> list[Comparison]:
    """Return the steps of a_ISO where the printed coefficients change."""
    found = []
    for (name, bearing), (kappa, roller, ball) in product(
        (("roller", NU2326), ("ball", SKF_6309)),
        ((0.4, 1e-5, 3e-3), (1.0, 1e-9, 1e-9)),
    ):
        load = fatigue_load_limit(bearing)
        below, above = (
            float(life_modification_factor(load, k, 1.0, bearing))
            for k in (kappa * (1 - 1e-13), kappa)
        )
        found.append(
            Comparison(
                f"step of a_ISO at kappa = {kappa:g}, radial {name}, relative",
                "ISO 281:2007 clause 9.3, continuous but for its printed digits",
                0.0,
                above / below - 1,
                "-",
                roller if name == "roller" else ball,
            )
        )
    return found


def reliabilities() -> list[Comparison]:
    """Return a_1 against the table of 2007."""
    return [
        Comparison(
            f"a_1 at {100 * reliability:g} %",
            "ISO 281:2007 table 12",
            published,
            float(reliability_factor(reliability)),
            "-",
            0.0,
        )
        for reliability, published in RELIABILITY.items()
    ]


def dirt() -> list[Comparison]:
    """Return e_C of greased bearings."""
    return [
        Comparison(
            f"e_C, grease, {name.replace('_', ' to ')} contamination, "
            f"kappa = {kappa:g}, D_pw = 205 mm",
            BY_HAND.format("Annex A"),
            published,
            float(contamination_factor(kappa, 0.205, Cleanliness(name))),
            "-",
            5.1e-6,
        )
        for name, values in GREASE.items()
        for kappa, published in zip((1.0, 0.3), values, strict=True)
    ]


def viscosities() -> list[Comparison]:
    """Return nu_1, kappa and the viscosity at a temperature."""
    rows = [
        (f"nu_1 at {n:g} rpm, D_pw = {d:g} mm", "clause 9.3", hand, n, bearing)
        for n, d, hand, bearing in (
            (3000.0, 72.5, 9.65, SKF_6309),
            (1800.0, 72.5, 12.46, SKF_6309),
            (1000.0, 205.0, 9.939, NU2326),
            (100.0, 205.0, 68.76, NU2326),
        )
    ]
    found = [
        Comparison(
            name,
            BY_HAND.format(where),
            hand,
            float(reference_viscosity(n * RPM, bearing)) * 1e6,
            "mm^2/s",
            0.005,
        )
        for name, where, hand, n, bearing in rows
    ]
    kappa = float(viscosity_ratio(39.6e-6, 1000 * RPM, NU2326))
    at_80 = float(viscosity_at_temperature(353.15, 120e-6, 12e-6)) * 1e6
    return [
        *found,
        Comparison(
            "kappa of NU2326 at 1000 rpm", "paper's inputs", 3.984, kappa, "-", 5e-4
        ),
        Comparison(
            "viscosity at 80 degrees C of 120 and 12 mm^2/s at 40 and 100",
            "ASTM D341, by hand",
            21.55,
            at_80,
            "mm^2/s",
            0.005,
        ),
    ]

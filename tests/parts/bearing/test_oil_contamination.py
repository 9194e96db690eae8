"""Contamination of oil, ISO 281:2007 Annex A, by hand and by its guide values."""

import pytest

from coupling_design.parts.bearing.lubrication import (
    OIL_CONTAMINATION,
    contamination_factor,
)
from coupling_design.parts.bearing.parameters import Cleanliness, OilCleanliness

CLEANEST_FIRST = list(OilCleanliness)


def test_by_hand():
    """kappa = 1, D_pw = 205 mm: 0.0288 x 205^0.55 x (1 - 1.6329 / 205^(1/3))."""
    # 205^0.55 = 18.6838; 205^(1/3) = 5.89637; 0.0288 x 18.6838 = 0.538093
    found = contamination_factor(1.0, 0.205, OilCleanliness.FILTERED_17_14)
    assert found == pytest.approx(0.538093 * (1 - 1.6329 / 5.89637), rel=1e-5)


def test_the_first_factor_stops_at_one():
    """0.0864 x 205^0.55 = 1.6143 counts as 1."""
    found = contamination_factor(1.0, 0.205, OilCleanliness.FILTERED_13_10)
    assert found == pytest.approx(1 - 0.5663 / 5.89637, rel=1e-5)


@pytest.mark.parametrize(
    ("cleanliness", "lowest", "highest"),
    [
        # Table 13, D_pw >= 100 mm: high 0.9 to 0.8, normal 0.8 to 0.6, typical 0.4 to
        # 0.2; a bearing of 200 mm with a film of kappa = 1.
        (OilCleanliness.FILTERED_13_10, 0.8, 0.91),
        (OilCleanliness.FILTERED_15_12, 0.6, 0.8),
        (OilCleanliness.FILTERED_19_16, 0.2, 0.4),
        (OilCleanliness.UNFILTERED_21_18, 0.0, 0.1),
    ],
)
def test_guide_values(cleanliness, lowest, highest):
    assert lowest <= contamination_factor(1.0, 0.2, cleanliness) <= highest


@pytest.mark.parametrize("kappa", [0.1, 0.5, 1.0, 4.0])
@pytest.mark.parametrize("kind", ["oil_filtered", "oil_unfiltered"])
def test_dirtier_oil_leaves_less(kappa, kind):
    factors = [
        contamination_factor(kappa, 0.205, each)
        for each in CLEANEST_FIRST
        if each.startswith(kind)
    ]
    assert factors == sorted(factors, reverse=True)


@pytest.mark.parametrize("code", ["13_10", "15_12", "17_14", "19_16"])
def test_an_on_line_filter_is_never_worse(code):
    filtered, unfiltered = (
        contamination_factor(1.0, 0.205, OilCleanliness(f"oil_{kind}_{code}"))
        for kind in ("filtered", "unfiltered")
    )
    assert filtered >= unfiltered


def test_grease_is_no_better_than_the_oil_of_the_same_first_constant():
    grease = contamination_factor(1.0, 0.205, Cleanliness.HIGH)
    assert grease <= contamination_factor(1.0, 0.205, OilCleanliness.UNFILTERED_13_10)


def test_every_class_has_its_constants():
    assert set(OIL_CONTAMINATION) == set(OilCleanliness)

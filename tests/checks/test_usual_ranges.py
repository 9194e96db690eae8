"""By tests/inputs/base.yaml: 1.27 kN m at 1500 rpm, inertias 2.5, 0.08 and 3 kg m^2."""

from dataclasses import replace

import pytest

from coupling_design.checks.usual_ranges import USUAL_RANGES, outside_usual_ranges


@pytest.fixture
def base(tiny):
    return tiny()


def test_a_usual_set(base):
    assert list(outside_usual_ranges(base)) == []


@pytest.mark.parametrize("row", USUAL_RANGES, ids=lambda row: row.path)
@pytest.mark.parametrize(
    ("border", "factor", "said"),
    [
        ("lowest", 1.0, 0),
        ("highest", 1.0, 0),
        ("lowest", 1 - 1e-9, 1),
        ("highest", 1 + 1e-9, 1),
    ],
)
def test_a_border_is_inside(row, border, factor, said, base, monkeypatch):
    value = factor * getattr(row, border)
    monkeypatch.setattr(
        "coupling_design.checks.usual_ranges.USUAL_RANGES",
        (replace(row, of=lambda case: value),),
    )
    told = list(outside_usual_ranges(base))
    assert len(told) == said
    for each in told:
        assert each.startswith(f"{base.place(row.path)}: {row.quantity} is ")
        assert row.reason in each


def test_what_each_row_reads(base):
    read = {row.path: row.of(base) for row in USUAL_RANGES}
    expected = {
        "duty.rated_torque": 199.5,  # 1.27 x 157.08
        "duty.working_speed.highest": 1500.0,
        "shutdown.initial_speed": 750.0,
        "driveline.generator_inertia": 0.3450,  # 0.5 x 5.58 x 157.08^2 / 199491
        "driveline.coupling_inertia": 0.014337,  # 0.08 / 5.58
        "driveline.coupling.torsional_stiffness": 0.10583,  # 1.27 / 12
        "lubrication.viscosity": 25.0,
    }
    assert read == {
        path: pytest.approx(value, rel=3e-4) for path, value in expected.items()
    }


@pytest.mark.parametrize(("ratio", "said"), [(0.41, 0), (0.39, 1), (2.4, 0), (2.6, 1)])
def test_static_over_dynamic_rating(base, ratio, said):
    first, second = base.bearings
    odd = replace(first, static_load_rating=ratio * first.dynamic_load_rating)
    told = list(outside_usual_ranges(replace(base, bearings=(odd, second))))
    assert len(told) == said
    for each in told:
        assert f"bearings[0].dynamic_load_rating: Drive end has C_0 / C = {ratio}" in (
            each
        )


def test_rows_are_ranges_with_a_reason():
    assert all(0 < row.lowest < row.highest and row.reason for row in USUAL_RANGES)

from dataclasses import replace

import pytest

from coupling_design.checks.crank import too_few_inertias


@pytest.fixture
def with_crank(quick):
    return replace(quick, crank_mode=200.0)


def test_a_soft_coupling_is_far_below(with_crank):
    assert too_few_inertias(with_crank, 39.9) is None


def test_five_times_is_the_border(with_crank):
    assert too_few_inertias(with_crank, 40.0) is None
    told = too_few_inertias(with_crank, 40.1)
    assert "Three inertias are too few for 40.1 Hz." in told
    assert "This engine's first crank mode is about 200 Hz" in told
    assert "good to a factor of 1.5" in told
    assert "the plan lies within five times of it" in told


def test_a_plan_above_the_crank(with_crank):
    assert "the plan lies above it" in too_few_inertias(with_crank, 201.0)


def test_without_an_engine_only_what_no_engine_has_is_told(quick):
    """No crank of a set is above 700 Hz: a fifth of it is 140 Hz."""
    assert too_few_inertias(quick, 140.0) is None
    told = too_few_inertias(quick, 140.1)
    assert "No engine's first crank mode is above 700 Hz" in told
    assert "the case does not describe the engine" in told


@pytest.mark.parametrize("name", ["16v280", "16v280_catalogue", "16v280_engine"])
def test_the_plan_at_188_hz_is_told_of(shipped, name):
    """The plan of the shipped set lies above crank modes of engines of its size."""
    told = too_few_inertias(shipped(f"{name}.yaml"), 188.0)
    assert "ask for a torsional calculation of the whole chain" in told
    assert ("about 54.5 Hz" in told) == (name == "16v280_engine")


@pytest.mark.parametrize(
    ("written", "expected"), [("16v280", None), ("16v280_engine", 54.5)]
)
def test_only_a_described_engine_has_a_crank_mode(shipped, written, expected):
    assert shipped(f"{written}.yaml").crank_mode == (
        expected and pytest.approx(expected, rel=1e-3)
    )

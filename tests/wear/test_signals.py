"""What the figures show is what the flow counted."""

import dataclasses

import numpy as np
import pytest

WAYS = ["high_stiffness", "elastic", "none"]


@pytest.fixture(params=WAYS)
def outcome(request, outcomes):
    return outcomes[request.param]


def shown(outcome):
    """Return each history with the performance that a rollout found for it."""
    other = outcome.chosen or outcome.nearest
    performances = outcome.baseline.performance, other.performance
    return list(zip(outcome.histories, performances, strict=True))


def test_the_present_run_down_comes_first(outcome):
    roles = [history.role for history in outcome.histories]
    assert roles == ["present", "chosen" if outcome.chosen else "nearest"]


def test_damage_ends_where_the_flow_says(outcome):
    for history, performance in shown(outcome):
        ends = [bearing.damage[-1] for bearing in history.bearings]
        assert ends == pytest.approx(performance.damages, rel=1e-6)


def test_damage_never_falls(outcome):
    for history in outcome.histories:
        assert all((np.diff(b.damage) >= 0).all() for b in history.bearings)


def test_peaks_are_those_of_the_flow(outcome):
    for history, performance in shown(outcome):
        force = np.abs(history.driveline.transmission_force).max()
        assert force == pytest.approx(performance.peak_transmission_force, rel=1e-6)
        loads = [bearing.combined_load.max() for bearing in history.bearings]
        assert loads == pytest.approx(performance.peak_combined_load, rel=1e-6)


def test_trend_and_collisions_are_the_force(outcome):
    for history in outcome.histories:
        both = history.force_trend + history.collision_force
        np.testing.assert_allclose(both, history.driveline.transmission_force)


def test_modified_life_is_the_product_of_its_factors(outcome):
    # ISO 281:2007, table 12: a_1 = 0.64 for the 95 % of the case.
    for bearing in outcome.histories[0].bearings:
        np.testing.assert_allclose(
            bearing.modified_rating_life,
            0.64 * bearing.life_modification_factor * bearing.basic_rating_life,
        )


def test_every_signal_has_a_value_for_each_step(outcome):
    steps = outcome.case.shutdown.n_steps
    for history in outcome.histories:
        for bearing in history.bearings:
            signals = dataclasses.asdict(bearing)
            assert signals.pop("minimum_load") > 0
            assert {value.shape for value in signals.values()} == {(steps,)}
            assert all(np.isfinite(value).all() for value in signals.values())


def test_a_chosen_coupling_that_no_step_mapped_has_its_plane(outcomes):
    outcome = outcomes["high_stiffness"]
    if outcome.chosen_map is None:
        pytest.skip("no machine code here: the plane is left out")
    assert outcome.chosen_map.name.startswith(outcome.chosen.coupling_type)
    stiffness = outcome.chosen.performance.torsional_stiffness
    low, *_, high = outcome.chosen_map.torsional_stiffness
    assert low * (1 - 1e-9) <= stiffness <= high


def test_no_plane_without_a_design(outcomes):
    assert outcomes["none"].chosen_map is None

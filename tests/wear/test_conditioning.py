import pytest

from coupling_design.wear.conditioning import conditioning, standing_digits


@pytest.mark.parametrize(
    ("change", "digits"),
    [
        (0.0, 6),
        (1e-9, 6),
        (5e-6, 5),
        (6e-6, 4),
        (5e-4, 3),
        (5.1e-4, 2),
        (5e-3, 2),
        (0.05, 1),
        (0.5, 1),
        (3.0, 1),
    ],
)
def test_half_a_unit_of_the_last_digit_may_move(change, digits):
    assert standing_digits(change) == digits


@pytest.fixture(scope="module")
def rattling(quick, evaluator):
    examined = evaluator(quick, "rubber", "key")
    performance = examined.performance(5e3, 1e-4)
    return examined, performance, conditioning(examined, performance)


def test_change_by_step_is_that_of_half_the_step(rattling):
    examined, performance, found = rattling
    halved = examined.refined.performance(5e3, 1e-4)
    damage_ratio = halved.damage / performance.damage
    peak_ratio = halved.peak_transmission_force / performance.peak_transmission_force
    assert found.damage_change_by_step == pytest.approx(damage_ratio - 1)
    assert found.peak_change_by_step == pytest.approx(peak_ratio - 1)


def test_change_by_start_is_that_of_a_billionth_of_a_milliradian(rattling):
    examined, performance, found = rattling
    moved = examined.performance(5e3, 1e-4, start_offset=1e-12)
    assert found.damage_change_by_start == moved.damage / performance.damage - 1


def test_digits_are_those_of_the_larger_change(rattling):
    _, _, found = rattling
    changes = found.damage_change_by_start, found.damage_change_by_step
    assert found.digits == standing_digits(max(map(abs, changes)))


def test_conditioning_costs_three_rollouts(quick, evaluator):
    """One crank angle as it is, with its start moved, and at half the step."""
    examined = evaluator(quick, "rubber", "tight_fit")
    performance = examined.performance(5e3, 0.0)
    conditioning(examined, performance)
    assert examined.rollouts == 1
    assert examined.scan.rollouts + examined.refined.scan.rollouts == 3

import dataclasses

import pytest

from coupling_design.wear.conditioning import are_chaotic, chaotic
from coupling_design.wear.sensitivity import (
    Move,
    Sensitivity,
    reduction_range,
    sensitivity,
)

SPEED, CONTACT = "initial speed", "contact stiffness"
PRESENT = Sensitivity(
    4.0,
    100.0,
    (
        Move(SPEED, 0.97, 3.0, 98.0),
        Move(SPEED, 1.03, 3.8, 97.0),
        Move(CONTACT, 0.5, 5.0, 120.0),
        Move(CONTACT, 2.0, 4.0, 90.0),
    ),
)
CHOSEN = Sensitivity(
    2.0, 50.0, (Move(SPEED, 0.97, 1.8, 50.0), Move(SPEED, 1.03, 2.09, 50.5))
)


def test_reach_by_hand():
    assert PRESENT.reach(CONTACT) == pytest.approx((0.0, 0.25, -0.10, 0.20))


def test_what_moves_one_way_only_reaches_from_zero():
    """Both speeds do less damage than the case's own."""
    assert PRESENT.reach(SPEED) == pytest.approx((-0.25, 0.0, -0.03, 0.0))


def test_each_input_is_named_once():
    assert PRESENT.names == (SPEED, CONTACT)


def test_span_in_words():
    assert PRESENT.span(SPEED) == "-3% to +3%"
    assert PRESENT.span(CONTACT) == "x 0.5 to x 2"


def test_the_largest_change_counts_and_two_digits_always_stand():
    assert PRESENT.damage_change == pytest.approx(0.25)
    assert PRESENT.digits == 2


def test_the_reduction_when_the_same_input_moves_for_both():
    """1 - 1.8 / 3, 1 - 2.09 / 3.8; what the chosen one lacks leaves it at 2.0."""
    by_hand = [1 - 1.8 / 3.0, 1 - 2.09 / 3.8, 1 - 2.0 / 5.0, 1 - 2.0 / 4.0]
    assert reduction_range(PRESENT, CHOSEN) == pytest.approx(
        (min(by_hand), max(by_hand))
    )


def test_an_amplitude_moves_as_a_case_with_another_amplitude(quick, evaluator):
    one = evaluator(quick, "rubber", "key")
    found = sensitivity(one, one.performance(2e3, 1e-4))
    name = f"amplitude of order {quick.driveline.excitation[0].order:g}"
    moved = next(m for m in found.moves if (m.name, m.factor) == (name, 1.1))

    first, *others = quick.driveline.excitation
    louder = dataclasses.replace(first, amplitude=1.1 * first.amplitude)
    driveline = dataclasses.replace(quick.driveline, excitation=(louder, *others))
    other = evaluator(
        dataclasses.replace(quick, driveline=driveline), "rubber", "key"
    ).performance(2e3, 1e-4)
    assert moved.damage == pytest.approx(other.damage, rel=1e-6)
    assert moved.peak == pytest.approx(other.peak_transmission_force, rel=1e-6)


def test_a_faster_start_runs_to_rest(quick, evaluator):
    """A higher speed takes longer: as a case of that speed that runs longer."""
    one = evaluator(quick, "rubber", "key")
    found = sensitivity(one, one.performance(2e3, 1e-4))
    moved = next(m for m in found.moves if (m.name, m.factor) == (SPEED, 1.03))

    shutdown = dataclasses.replace(
        quick.shutdown,
        initial_speed=1.03 * quick.shutdown.initial_speed,
        duration=1.03 * quick.shutdown.duration,
    )
    other = evaluator(
        dataclasses.replace(quick, shutdown=shutdown), "rubber", "key"
    ).performance(2e3, 1e-4)
    assert moved.damage == pytest.approx(other.damage, rel=1e-6)


class MadeUp:
    """Its damage moves with the start by a given share."""

    def __init__(self, shares):
        self.shares = shares

    @property
    def scan(self):
        return self

    def performances(self, points, start_offset=0.0):
        moved = [1.0 + (share if start_offset else 0.0) for share in self.shares]
        return [Damage(value) for value in moved[: len(points)]]


@dataclasses.dataclass(frozen=True)
class Damage:
    damage: float
    torsional_stiffness: float = 1.0
    key_gap: float = 0.0


def test_chaotic_is_what_a_nudge_moves_by_more_than_a_thousandth():
    points = [(1.0, 0.0)] * 3
    assert are_chaotic(MadeUp((0.0, -2e-3, 9e-4)), points) == (False, True, False)
    assert chaotic(MadeUp((2e-3,)), Damage(1.0))
    assert not chaotic(MadeUp((1e-9,)), Damage(1.0))

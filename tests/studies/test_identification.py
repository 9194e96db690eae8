import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from coupling_design.case import load_case
from coupling_design.parts.bearing.parameters import Cleanliness
from studies.identification import explanation, model, trade_off
from studies.identification.identifiability import Identifiability, describe, ranges
from studies.identification.jacobian import differences
from studies.identification.parameters import (
    NAMES,
    QUANTITIES,
    SMOOTH_CONTACT,
    from_unit,
    named_sets,
    shipped,
    to_unit,
)
from studies.identification.rows import Rows, markdown
from studies.identification.search import (
    Archive,
    Region,
    global_search,
    local_fit,
)
from studies.identification.targets import (
    HALF,
    LINEAR_BEYOND,
    TARGETS,
    misfit,
    misfit_of_the_others,
    phases,
    residuals,
    targets_of,
    targets_over_phases,
)
from studies.machine import (
    high_stiffness,
    present,
    present_point,
    present_tightly_fitted,
    required_stiffness,
)

CASE = Path(__file__).parents[2] / "cases" / "16v280.yaml"
REGION = Region(SMOOTH_CONTACT, (Cleanliness.SLIGHT_TYPICAL, Cleanliness.SEVERE))
# What the paper prints, or something within what it allows.
# fmt: off
PAPER = np.array([
    0.00405, 90.21, -2.0, 19.68, 0.0, 0.0, 33.926, -43.19,
    120.0, 120.0, 40.0, 10.0, -1.0, 30.0, 0.0, 12.0,
])
# fmt: on


@pytest.fixture(scope="module")
def case():
    return load_case(CASE)


@pytest.fixture(scope="module")
def short(case):
    """Return the case with a run-down of a tenth of a second from one crank angle."""
    shutdown = replace(case.shutdown, duration=0.1, crank_angles=1)
    return replace(case, shutdown=shutdown)


def unlike(inputs, **changes):
    """Return inputs with some values multiplied."""
    values = list(inputs.values)
    for name, factor in changes.items():
        values[NAMES.index(name)] *= factor
    return replace(inputs, values=tuple(values))


@pytest.mark.parametrize("name", named_sets())
def test_bounds_contain_every_set(name):
    shares = to_unit(np.array([named_sets()[name].inputs.values]))

    assert np.all((shares >= 0) & (shares <= 1 + 1e-12))


def test_shares_of_the_bounds_come_back():
    values = np.array([entry.inputs.values for entry in named_sets().values()])

    assert from_unit(to_unit(values)) == pytest.approx(values, rel=1e-12, abs=1e-12)


def test_bounds_are_those_of_the_search():
    ends = from_unit(np.array([np.zeros(len(NAMES)), np.ones(len(NAMES))]))

    shown = [
        [q.from_si(x) for q, x in zip(QUANTITIES, row, strict=True)] for row in ends
    ]
    assert shown[0] == pytest.approx([q.lowest for q in QUANTITIES])
    assert shown[1] == pytest.approx([q.highest for q in QUANTITIES])


def test_the_shipped_set_is_the_case(case):
    line, (four, eight) = case.driveline, case.driveline.excitation

    assert shipped().cleanliness is case.lubrication.cleanliness
    assert four.phase == 0
    assert shipped().values == pytest.approx(
        (
            case.shutdown.initial_speed,
            line.coupling.torsional_stiffness,
            line.coupling.damping_law.damping_factor,
            four.amplitude,
            eight.amplitude,
            eight.phase,
            line.engine_resistance.viscous,
            line.engine_resistance.friction,
            line.generator_resistance.friction,
            line.generator_resistance.viscous,
            line.connection.contact_stiffness,
        ),
        rel=1e-10,
    )


def assert_as_the_evaluator(case):
    """Hold the batch against the evaluators that the report is made with."""
    found = model.run(case, [shipped()], variants=model.MORE_VARIANTS)
    k, gap = present_point(case)
    stiffest = model.stiffest_elastic(case, case.shutdown.initial_speed)
    expected = {
        "present": present(case).performance(k, gap),
        "half": present(case).performance(k / 2, gap),
        "stiffest": present(case).performance(stiffest, gap),
        "gap 0": present(case).performance(k, 0.0),
        "gap 0.3": present(case).performance(k, 0.3e-3),
        "tight": present_tightly_fitted(case).performance(k, 0.0),
        "high stiffness": high_stiffness(case).performance(
            required_stiffness(case), 0.0
        ),
    }
    for variant, performance in expected.items():
        totals = (
            *performance.damages,
            performance.peak_transmission_force,
            *performance.peak_combined_load,
        )
        ours = [found[variant, name][0] for name in model.TOTALS]
        assert ours == pytest.approx(totals, rel=1e-9), variant


def test_a_batch_gives_what_the_evaluator_gives(short):
    assert_as_the_evaluator(short)


@pytest.mark.slow
def test_the_whole_run_down_gives_what_the_evaluator_gives(case):
    shutdown = replace(case.shutdown, crank_angles=1)
    assert_as_the_evaluator(replace(case, shutdown=shutdown))


def test_each_candidate_stays_in_its_place(short):
    candidates = [
        shipped(),
        shipped().of_class(Cleanliness.SEVERE),
        unlike(shipped(), stiffness=0.9, order_4=1.2),
        named_sets()["middle"].inputs,
        unlike(shipped(), contact_stiffness=2.0).of_class(Cleanliness.NORMAL),
    ]

    together = targets_of(short, candidates)
    alone = np.vstack([targets_of(short, [each]) for each in candidates])
    assert together == pytest.approx(alone, rel=1e-12)
    assert len({row.tobytes() for row in together}) == len(candidates)


def test_the_extras_are_those_of_the_history(short):
    found = model.run(short, [shipped()])
    history = present(short).driveline(*present_point(short))

    from coupling_design.events.recording import simulate

    signals = simulate(history, short.shutdown)
    torque = np.abs(signals.coupling_torque)
    at = int(torque.argmax())
    assert found["present", "peak_coupling_torque"][0] == pytest.approx(torque[at])
    speed = found["present", "speed_at_peak"][0]
    assert speed == pytest.approx(signals.generator_speed[at])
    assert found["present", "turning_time"][0] == pytest.approx(0.1)


def test_no_residual_where_the_paper_is_met():
    assert residuals(PAPER) == pytest.approx(np.zeros(len(TARGETS)), abs=1e-9)
    assert misfit(PAPER) == pytest.approx(0)


@pytest.mark.parametrize("i", range(len(TARGETS)))
def test_residuals_are_positive_above_and_negative_below(i):
    target, above, below = TARGETS[i], PAPER.copy(), PAPER.copy()
    above[i] = target.highest + 2 * target.tolerance
    below[i] = target.lowest - 3 * target.tolerance

    if math.isfinite(target.highest):
        assert residuals(above)[i] == pytest.approx(2)
        assert misfit(above) == pytest.approx(4)
    if math.isfinite(target.lowest):
        assert residuals(below)[i] == pytest.approx(-3)


def test_far_residuals_count_linearly():
    def at(tolerances):
        values = PAPER.copy()
        values[HALF] -= tolerances * TARGETS[HALF].tolerance
        return float(misfit(values))

    assert at(LINEAR_BEYOND) == pytest.approx(36)
    assert at(LINEAR_BEYOND + 1) == pytest.approx(48)
    assert at(LINEAR_BEYOND + 2) == pytest.approx(60)


def test_the_others_leave_half_the_stiffness_out():
    values = PAPER.copy()
    values[HALF] = 0.0

    assert misfit_of_the_others(values) == pytest.approx(0)


def test_a_diverged_candidate_is_the_worst():
    values = np.vstack([PAPER, np.full(len(TARGETS), np.nan)])

    assert misfit(values).tolist() == pytest.approx([0, 1e6], abs=1e-9)


def test_phases_are_even_over_a_period(short):
    """Orders 4 and 8 repeat after a quarter turn; gravity goes round once."""
    crank, gravity = phases(short, 4).T

    assert crank == pytest.approx(np.arange(4) * np.pi / 8)
    assert sorted(gravity) == pytest.approx(np.arange(4) * np.pi / 2)


def test_averages_start_at_each_phase(short):
    found = targets_over_phases(short, [shipped(), named_sets()["middle"].inputs], 3)

    again = targets_of(short, [shipped().started_at(*phases(short, 3)[2])])
    assert found.shape == (2, 3, len(TARGETS))
    assert found[0, 2] == pytest.approx(again[0])


def test_points_of_the_search_come_back():
    for inputs in (shipped(), named_sets()["smooth severe"].inputs):
        [again] = REGION.decode(REGION.encode(inputs)[np.newaxis])
        assert again.values == pytest.approx(inputs.values, rel=1e-9)
        assert again.cleanliness is inputs.cleanliness


def test_the_search_starts_from_the_sets_and_does_not_lose_them(short):
    archive = Archive(short, REGION)
    found = global_search(archive, misfit, seed=3, seconds=0.0, label="test")

    known = targets_of(short, REGION.decode(np.array(REGION.known())))
    assert misfit(targets_of(short, [found])) <= misfit(known).min()
    low, high = np.array(REGION.dimensions).T
    points = np.array(archive.points)
    assert np.all((points >= low - 1e-12) & (points <= high + 1e-12))


def test_a_seed_gives_the_same_search_again(short):
    once, again = (Archive(short, REGION) for _ in range(2))
    for archive in (once, again):
        global_search(archive, misfit, seed=3, seconds=0.0, label="test")

    assert np.array_equal(once.points, again.points)


def test_from_scratch_forgets_the_sets(short):
    archive = Archive(short, replace(REGION, from_scratch=True))
    global_search(archive, misfit, seed=3, seconds=0.0, label="test")

    known = REGION.known()
    assert known
    assert not any(np.allclose(p, k) for p in archive.points for k in known)


def test_the_local_fit_ends_at_its_time(short):
    assert local_fit(short, shipped(), REGION, 1, seconds=-1.0) == shipped()


def test_differences_are_exact_for_a_straight_line():
    slopes = np.array([[1.0, 2.0, -3.0], [0.5, 0.0, 4.0]])
    point, low, high = np.array([0.5, 0.0, 1.0]), np.zeros(3), np.ones(3)

    found = differences(lambda x: x @ slopes.T, point, low, high, 0.1)
    assert found == pytest.approx(slopes)


def test_an_input_is_determined_by_what_moves_the_results():
    # One result moves with the first input alone, three times as far as its spread
    # over the bounds' deviation: 9 / (1 + 9) of the variance goes.
    jacobian = np.zeros((len(NAMES), len(NAMES)))
    jacobian[0, 0] = 3.0
    results, strengths, directions = np.linalg.svd(jacobian)
    found = Identifiability(shipped(), jacobian, strengths, directions, results)

    assert found.determined == pytest.approx([0.9] + [0.0] * 10)
    assert found.deviation[0] == pytest.approx(math.sqrt(0.1 / 12))
    assert found.n_pinned == 1
    low, high = ranges(found)[0]
    assert high == pytest.approx(520)
    assert low == pytest.approx(520 - 120 * math.sqrt(0.1 / 12))


def test_a_direction_names_its_largest_first():
    words = describe(np.array([0.1, -0.9, 0.4]), ("a", "b", "c"))

    assert words == "-0.90 b, +0.40 c"


def test_the_linear_passage():
    # 2^(1/6) = 1.1225; (43.19 + 90.21) / 43.19 = 3.0887.
    assert explanation.passage_growth() == pytest.approx(1.1225, abs=5e-5)
    assert explanation.needed_growth() == pytest.approx(3.0887, abs=5e-5)
    exponent = explanation.needed_exponent(3.0887)
    assert explanation.passage_growth(exponent) == pytest.approx(3.0887)


def test_the_front_takes_the_best_that_reaches_a_level():
    found = trade_off.front_of(
        [
            trade_off.Point(1e8, 0.0, others, shipped(), tuple(values))
            for others, values in (
                (0.0, np.where(np.arange(len(PAPER)) == HALF, 12.0, PAPER)),
                (4.0, np.where(np.arange(len(PAPER)) == HALF, 31.0, PAPER)),
                (1.0, np.where(np.arange(len(PAPER)) == HALF, 33.0, PAPER)),
            )
        ]
    )

    front = {point.level: point.others for point in found}
    assert front == {0: 0, 5: 0, 10: 0, 15: 1, 20: 1, 25: 1, 30: 1}


def test_a_stored_front_comes_back(tmp_path):
    inputs = named_sets()["middle"].inputs
    point = trade_off.Point(5e8, 20.0, 8.25, inputs, tuple(PAPER.tolist()))
    trade_off.write_front([point], "a command", tmp_path / "front.csv")

    [again] = trade_off.read_front(tmp_path / "front.csv")
    assert again.inputs.values == pytest.approx(inputs.values, rel=1e-9)
    assert again.inputs.cleanliness is inputs.cleanliness
    assert (again.contact, again.level, again.others) == (5e8, 20.0, 8.25)
    assert again.values == pytest.approx(PAPER)
    assert trade_off.command_of(tmp_path / "front.csv").startswith("Made by: a command")


def test_the_shipped_front_keeps_its_bounds_and_adds_up():
    for point in trade_off.read_front():
        shares = to_unit(np.array([point.inputs.values]))
        assert np.all((shares > -1e-9) & (shares < 1 + 1e-9))
        assert point.inputs["contact_stiffness"] <= point.contact * (1 + 1e-9)
        assert point.rise >= point.level
        others = float(misfit_of_the_others(np.array(point.values)))
        assert others == pytest.approx(point.others, rel=0.02, abs=0.02)


def test_a_table_in_markdown():
    rows = Rows("title", ("a", "b", "c"), (("1", "2", "3"),))

    assert markdown(rows, omitted=["b"]) == "| a | c |\n| --- | --- |\n| 1 | 3 |"

import pytest

from coupling_design.search.program import DesignSpace, Objective
from coupling_design.search.scan import best_first, grid, local_minima


def test_the_grid_reaches_both_bounds():
    points = grid(DesignSpace((1e3, 3e5), (1e-5, 3e-4)), 7, 3)
    stiffnesses, gaps = zip(*points, strict=True)
    assert len(points) == 21
    assert (min(stiffnesses), max(stiffnesses)) == (1e3, 3e5)
    assert (min(gaps), max(gaps)) == (1e-5, 3e-4)


@pytest.mark.parametrize("high", [0.541e6, 2.70e6, 400e6, 7.3, 1e3 / 3])
def test_no_rounding_passes_the_upper_bound(high):
    points = grid(DesignSpace((high / 9, high), (0.0, 0.0)), 32, 1)
    assert max(stiffness for stiffness, _ in points) == high


def test_the_grid_is_even_by_ratio():
    (a, _), (b, _), (c, _) = grid(DesignSpace((1.0, 100.0), (0.0, 0.0)), 3, 1)
    assert (a, b, c) == pytest.approx((1.0, 10.0, 100.0))


def test_a_fixed_gap_gives_one_row():
    points = grid(DesignSpace((1.0, 2.0), (1e-4, 1e-4)), 5, 4)
    assert len(points) == 5
    assert {gap for _, gap in points} == {1e-4}


def test_a_fixed_stiffness_gives_one_column():
    assert grid(DesignSpace((2.0, 2.0), (0.0, 0.0)), 5, 1) == ((2.0, 0.0),)


@pytest.fixture
def program(landscape, force_limit):
    return landscape(lambda k, gap: k, Objective.DAMAGE, [force_limit(100.0)])


def test_best_first_puts_least_damage_first(program, perform):
    scan = [perform(damage=damage, peak=50.0) for damage in (3e-9, 1e-9, 2e-9)]
    assert [p.damages[0] for p in best_first(program, scan)] == [1e-9, 2e-9, 3e-9]


def test_best_first_puts_the_feasible_first(program, perform):
    over = perform(damage=1e-12, peak=101.0)
    inside = perform(damage=1.0, peak=99.0)
    assert best_first(program, [over, inside]) == [inside, over]


def test_the_infeasible_come_by_their_violation(program, perform):
    far, near = perform(damage=1e-12, peak=200.0), perform(damage=1.0, peak=101.0)
    assert best_first(program, [far, near]) == [near, far]


def damages(program, perform, *values):
    scan = [perform(damage=value, peak=50.0) for value in values]
    return [p.damages[0] for p in local_minima(program, scan)]


def test_valleys_are_lower_than_both_neighbours(program, perform):
    assert damages(program, perform, 3, 1, 2, 5, 4, 6) == [1, 4]


def test_an_end_may_be_a_valley(program, perform):
    assert damages(program, perform, 1, 2, 3) == [1]
    assert damages(program, perform, 3, 2, 1) == [1]


def test_a_flat_floor_is_one_valley(program, perform):
    assert damages(program, perform, 3, 2, 2, 3) == [2]


def test_a_point_over_its_limit_is_no_valley(program, perform):
    scan = [perform(damage=damage, peak=50.0) for damage in (1e-3, 2e-3)]
    scan.insert(1, perform(damage=1e-9, peak=150.0))
    assert scan[1] not in local_minima(program, scan)

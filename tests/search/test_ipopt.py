import casadi as ca
import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from coupling_design.errors import SimulationError
from coupling_design.search import ipopt as solve
from coupling_design.search.ipopt import optimise
from coupling_design.search.program import Objective
from coupling_design.search.scan import best_first, grid
from coupling_design.search.valleys import smallest_load

DAMAGE, PEAK, STIFFNESS = Objective.DAMAGE, Objective.PEAK, Objective.STIFFNESS
TIE = 1e-5


def scan_of(program, n=12, n_gaps=4):
    return program.evaluator.performances(grid(program.space, n, n_gaps))


def solved(program, starts=3, n=12):
    return optimise(program, scan_of(program, n), starts)


def bowl(k, gap):
    """A valley at ln stiffness = 2.1."""
    return (k - 2.1) ** 2


def two_valleys(k, gap):
    """Floors near 1 and 3.5, the second 0.2 lower."""
    return ((k - 1) * (k - 3.5)) ** 2 - 0.08 * k


def test_a_smooth_valley_is_found_to_its_floor(landscape):
    found = solved(landscape(bowl, DAMAGE))
    assert np.log(found.performance.torsional_stiffness) == pytest.approx(2.1, abs=1e-3)
    assert found.method == "ipopt"
    assert found.solver_status == "Solve_Succeeded"


def test_the_residual_of_a_smooth_interior_floor_is_small(landscape):
    assert solved(landscape(bowl, DAMAGE)).kkt_residual < 1e-4


def test_nothing_holds_an_interior_floor(landscape):
    assert solved(landscape(bowl, DAMAGE)).active_constraints == ()


def test_all_starts_agree_on_the_only_valley(landscape):
    found = solved(landscape(bowl, DAMAGE), starts=3)
    assert (found.starts, found.starts_agreeing) == (3, 3)


def test_starts_in_another_valley_do_not_agree(landscape):
    found = solved(landscape(two_valleys, DAMAGE), starts=2)
    assert np.log(found.performance.torsional_stiffness) == pytest.approx(3.5, abs=0.05)
    assert (found.starts, found.starts_agreeing) == (2, 1)


def test_a_gap_that_is_free_is_a_variable(landscape):
    valley = landscape(
        lambda k, gap: (k - 2.1) ** 2 + (gap - 0.13) ** 2 * 50,
        DAMAGE,
        gap=(2e-5, 2e-4),
    )
    found = solved(valley)
    assert found.performance.key_gap == pytest.approx(0.13e-3, rel=0.01)
    assert np.log(found.performance.torsional_stiffness) == pytest.approx(2.1, abs=1e-2)


def test_starts_with_the_gap_free_are_spread_over_the_valleys(landscape):
    """Where the gap hardly matters, the best points of a scan share one stiffness."""
    flat = landscape(
        lambda k, gap: two_valleys(k, gap) + 0.01 * gap, DAMAGE, gap=(2e-5, 2e-4)
    )
    found = solved(flat, starts=2)
    assert np.log(found.performance.torsional_stiffness) == pytest.approx(3.5, abs=0.05)
    assert found.starts_agreeing == 1


def test_a_bound_that_holds_the_point_is_named(landscape):
    found = solved(landscape(lambda k, gap: -k, DAMAGE))
    assert found.performance.torsional_stiffness == pytest.approx(100.0, rel=1e-3)
    assert found.active_constraints == ("torsional stiffness at its upper bound",)


def test_a_gap_at_its_bound_is_named(landscape):
    rising = landscape(lambda k, gap: bowl(k, gap) + 9 * gap, DAMAGE, gap=(2e-5, 2e-4))
    assert solved(rising).active_constraints == ("key gap at its lower bound",)


def test_a_limit_that_holds_the_point_is_named(landscape, force_limit):
    """Damage falls and peak rises with stiffness; the peak is e^3 at ln k = 3."""
    limited = landscape(
        lambda k, gap: -k, DAMAGE, [force_limit(np.exp(3.0))], lambda k, gap: k
    )
    found = solved(limited)
    assert np.log(found.performance.torsional_stiffness) == pytest.approx(3, abs=1e-3)
    assert found.active_constraints == ("peak",)
    assert limited.is_feasible(found.performance)


def test_the_lowest_stiffness_that_keeps_a_limit(landscape, force_limit):
    """Peak e^(4 - k) keeps e^2 from ln k = 2 on."""
    limited = landscape(
        bowl, STIFFNESS, [force_limit(np.exp(2.0))], lambda k, gap: 4 - k
    )
    found = solved(limited)
    assert np.log(found.performance.torsional_stiffness) == pytest.approx(2, abs=1e-3)
    assert limited.is_feasible(found.performance)


def test_with_nothing_feasible_the_nearest_is_told(landscape, force_limit):
    """Peak e^(1 + (k - 2)^2) is never below e, over a limit of 1."""
    hopeless = landscape(
        bowl, DAMAGE, [force_limit(1.0)], lambda k, gap: 1 + (k - 2) ** 2
    )
    scan = scan_of(hopeless)
    found = optimise(hopeless, scan, 2)
    assert not hopeless.is_feasible(found.performance)
    nearest = min(hopeless.violation(p) for p in scan)
    assert hopeless.violation(found.performance) <= nearest


def test_an_optimum_says_what_it_cost(landscape):
    program = landscape(bowl, DAMAGE)
    scan = scan_of(program)
    before = program.evaluator.rollouts
    found = optimise(program, scan, 2)
    assert found.scan_points == 12
    assert 0 < found.rollouts <= program.evaluator.rollouts - before


@given(st.lists(st.floats(-3, 3), min_size=3, max_size=3), st.floats(0.3, 3.0))
@settings(max_examples=20, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_the_winner_is_never_worse_than_the_scan(landscape, force_limit, waves, limit):
    def damage(k, gap):
        return sum(a * ca.sin((i + 1) * k) for i, a in enumerate(waves))

    program = landscape(damage, DAMAGE, [force_limit(limit)], lambda k, gap: 1 - k / 2)
    scan = scan_of(program)
    found = optimise(program, scan, 2).performance
    best = best_first(program, scan)[0]
    assert program.is_feasible(found) >= program.is_feasible(best)
    if program.is_feasible(best):
        assert float(program.value(found)) <= float(program.value(best)) + TIE


def test_without_iterations_the_scan_stands(landscape, monkeypatch):
    """Ipopt pushes the start off its bound and gets no step to come back."""
    monkeypatch.setitem(solve._IPOPT, "max_iter", 0)
    found = solved(landscape(lambda k, gap: -k, DAMAGE))
    assert found.method == "scan"
    assert found.solver_status == "Maximum_Iterations_Exceeded"
    assert found.performance.torsional_stiffness == 100.0
    assert found.kkt_residual is None


def test_where_derivatives_fail_the_scan_stands(landscape):
    program = landscape(two_valleys, DAMAGE)

    def diverges(stiffness, gap):
        raise SimulationError("the run-down left finite numbers")

    program.evaluator.totals_and_jacobian = diverges
    scan = scan_of(program)
    found = optimise(program, scan, 2)
    assert found.method == "scan"
    assert found.performance == best_first(program, scan)[0]


def test_where_derivatives_are_not_numbers_the_scan_stands(landscape):
    program = landscape(two_valleys, DAMAGE)
    program.evaluator.totals_and_jacobian = lambda *point: (
        np.full(5, np.nan),
        np.full((5, 2), np.nan),
    )
    scan = scan_of(program)
    found = optimise(program, scan, 2)
    assert found.method == "scan"
    assert found.performance == best_first(program, scan)[0]


def kinked(k, gap):
    """Two peaks that take turns: lowest where they meet, at ln k = 2.3."""
    return ca.fmax(1 + 2 * (k - 2.3), 1 - 0.5 * (k - 2.3))


def test_the_smallest_load_is_found_at_a_kink(landscape, force_limit):
    program = landscape(bowl, PEAK, [force_limit(1.0)], kinked)
    found = smallest_load(program, scan_of(program), 2)
    assert np.log(found.performance.torsional_stiffness) == pytest.approx(2.3, abs=2e-3)
    assert found.performance.peak_transmission_force == pytest.approx(np.e, rel=5e-3)
    assert found.method == "bounded search"


def test_the_smallest_load_is_no_larger_than_the_scans(landscape, force_limit):
    program = landscape(
        bowl, PEAK, [force_limit(1.0)], lambda k, gap: ca.sin(9 * k) + k / 9
    )
    scan = scan_of(program)
    found = smallest_load(program, scan, 3)
    assert found.performance.peak_transmission_force <= min(
        p.peak_transmission_force for p in scan
    )


def test_the_smallest_load_at_a_bound_is_found(landscape, force_limit):
    program = landscape(bowl, PEAK, [force_limit(1.0)], lambda k, gap: k)
    found = smallest_load(program, scan_of(program), 1)
    assert found.performance.torsional_stiffness == 1.0
    assert found.active_constraints == ("torsional stiffness at its lower bound",)


def test_a_rollout_that_diverges_is_not_told_by_casadi(landscape, capfd):
    program = landscape(bowl, DAMAGE)
    program.evaluator.totals_and_jacobian = lambda *point: (
        np.full(5, np.nan),
        np.full((5, 2), np.nan),
    )
    found = solved(program, starts=1)
    assert found.solver_status == "Invalid_Number_Detected"
    assert capfd.readouterr() == ("", "")

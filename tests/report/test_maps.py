"""The map over stiffness and gap, thinned to fit a page."""

from dataclasses import replace

from coupling_design.report.console.console import plain_text
from coupling_design.report.console.maps import render_map, spread
from coupling_design.search.design_map import CoarseStep
from tests.report.conftest import MAP


def test_spread_keeps_both_ends():
    assert spread(12, 6) == (0, 2, 4, 7, 9, 11)


def test_spread_shows_all_there_is():
    assert spread(3, 5) == (0, 1, 2)


def test_map_says_how_much_of_it_is_shown():
    assert "36 rollouts, 18 of them shown" in plain_text(render_map(MAP), 80)


def test_map_shows_damage_and_peak_at_its_corner():
    text = plain_text(render_map(MAP), 80)
    assert "0.2800" in text
    assert "0.0140" in text  # D x 1e6 = (2 + 11 + 1) e-3
    assert "63.00" in text  # 50 + 2 + 11 kN


def test_map_says_that_it_has_the_cases_own_step():
    assert "All at the case's own time step." in plain_text(render_map(MAP), 80)


def test_map_says_how_far_a_longer_step_is_off():
    coarse = CoarseStep(4, 4e-4, 48, damage_error=5.3e-4, peak_error=1.9e-4)
    text = plain_text(render_map(replace(MAP, coarse=coarse)), 200)
    assert "the time step is 0.0004 s, 4 times the case's own" in text
    assert "At 48 points" in text
    assert "damage differs by at most 0.05 %, peak F_c by at most 0.02 %" in text

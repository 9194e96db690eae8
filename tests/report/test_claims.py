"""What the report says of a result as a whole, and of its two fatigue limits."""

from dataclasses import replace

import pytest

from coupling_design.checks.fatigue_limits import FatigueLimits
from coupling_design.parts.criterion import not_checked
from coupling_design.report.console.console import plain_text
from coupling_design.report.console.report import render_outcome

LINE = "square root, a line contact's law"
ROLLER = FatigueLimits("Bearing 1", 48_838.56, 120_940.0, LINE, False)


@pytest.fixture(params=[80, 100, 120])
def said(request):
    return lambda outcome: " ".join(
        plain_text(render_outcome(outcome), request.param).replace("│", " ").split()
    )


def test_both_fatigue_limits_and_which_decides(outcome, said):
    text = said(replace(outcome, fatigue_limits=(ROLLER,)))
    assert "Bearing 1: F_min 48.84 kN, from S_min and K1, and C_u 120.9 kN" in text
    assert "F_min decides, by the method" in text
    assert LINE in text


def test_bearings_that_are_alike_are_told_of_once(outcome, said):
    both = (ROLLER, replace(ROLLER, bearing="Bearing 2"))
    text = said(replace(outcome, fatigue_limits=both))
    assert "Bearing 1 and Bearing 2: F_min 48.84 kN" in text
    assert text.count("are both fatigue limits of one bearing") == 1


def test_a_ball_by_the_law_of_rollers_is_told_how_to_write_it(outcome, said):
    ball = replace(ROLLER, is_a_ball_by_the_line_law=True)
    text = said(replace(outcome, fatigue_limits=(ball,)))
    assert "write K1 in MPa/N^(1/3), which is S_min / F_min^(1/3)" in text


def test_warnings_stand_at_the_top(outcome, said):
    text = said(replace(outcome, warnings=("The run-down ends too soon.",)))
    top, _, _ = text.partition("Asked")
    assert "Read first - The run-down ends too soon." in top


def test_a_cut_off_stop_is_a_limit_of_validity(outcome, said):
    text = said(replace(outcome, remarks=("Present coupling: ends at 6 rpm.",)))
    _, _, limits = text.partition("Limits of validity")
    assert "- Present coupling: ends at 6 rpm." in limits


def test_a_reason_stands_in_place_of_a_near_miss(no_design, said):
    assert "Nearest came" in said(no_design)
    text = said(replace(no_design, reasons=("The rotor's weight exceeds F_min.",)))
    assert "No design meets the limits. The rotor's weight exceeds F_min." in text
    assert "Nearest came" not in text


def test_what_was_not_checked_is_named(outcome, said):
    missing = not_checked("disc: short circuit", unit="N*m", missing="no T_Kmax2")
    chosen = replace(outcome.chosen, criteria=(*outcome.chosen.criteria, missing))
    text = said(replace(outcome, chosen=chosen))
    assert "Not checked, for want of a limit or a load: disc: short circuit." in text

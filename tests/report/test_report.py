import io
import re
from dataclasses import replace

import pytest
from rich.console import Console

from coupling_design.machine.words import LoadLimitReading
from coupling_design.report.console.console import plain_text
from coupling_design.report.console.report import render_outcome

WIDTHS = (80, 100, 120)


def flat(text):
    """Return a report's words in one line, without borders and line breaks."""
    return " ".join(re.sub(r"[│╭╮╰╯─]", " ", text).split())


@pytest.fixture(scope="module")
def report(outcome):
    return plain_text(render_outcome(outcome))


@pytest.mark.parametrize("width", WIDTHS)
@pytest.mark.parametrize("name", ["outcome", "no_design"])
def test_fits_and_loses_nothing(name, width, request):
    text = plain_text(render_outcome(request.getfixturevalue(name)), width)
    assert max(map(len, text.splitlines())) <= width
    assert "…" not in text
    assert "\x1b" not in text
    assert not re.search(r"[ \t]+$", text, re.MULTILINE)


@pytest.mark.parametrize("width", WIDTHS)
@pytest.mark.parametrize(
    "fact",
    [
        "cases/16v280.yaml",
        "Take diaphragm (high stiffness plan), 192.8 MN*m/rad, tight fit, gap 0 mm.",
        "Damage per run-down falls by 37 % (31 to 40 % when inputs move) against",
        "judged over 8 crank angles at the start, each with another direction of",
        "over the crank angle 69.80 to 70.17",
        "if inputs move initial speed -3% to -3%: D -1.8 to +0.0 %, peak -0.0 to",
        "F_c would reach 33.91 kN on average over the crank angle, 59.52 kN at most.",
        "its start settled vibration of the engine turned without fuel",
        "Load limit read strictly (combined load): FAIL; F_c may then reach 28.90 kN.",
        "rated 35 kN*m x service factor 1.3; peak 70 kN*m",
        "transmission_force: the force at the key",
        "Step 3: Bearing load - FAIL",
        "D x 1e6 = 0.00405",
        "Maximum_Iterations_Exceeded",
        "best verified point of the scan; Ipopt gave nothing better",
        "starts agreed 2 of 3",
        "32 scan points, 87 rollouts",
        "KKT residual 1.3e-8",
        "held by natural frequency",
        "4 digits of the damage stand; the damage moves by +1.2e-10 (relative) when "
        "the start is shifted by 1e-12 rad and by -2.1e-5 when the time step is halved",
        "33.93 <= 36.12 +6.07 kN PASS",
        "75.001 <= 75.000 -1e-3 kN*m FAIL",
        "T_KN 63 kN*m, T_Kmax 110 kN*m, n_max 2000 rpm",
        "Summary: the chosen coupling against its limits",
        "54.30 <= 48.84 -11.19 kN FAIL",
        "Vibratory torque T_KW is not checked.",
        "the largest stable one is 0.000414 s",
        "engine at rest after 11.96 no rest s",
        "Limits of validity",
        "Run time 43.3 s, 123 run-downs",
    ],
)
def test_says(outcome, width, fact):
    assert fact in flat(plain_text(render_outcome(outcome), width))


def test_present_and_chosen_stand_side_by_side(report):
    assert "peak transmission force F_c 70.17 33.93 kN" in flat(report)
    assert "damage, the paper's unit (D x 1e6) 0.0041 0.002562 -" in flat(report)


def test_summary_begins_with_what_the_type_carries(report):
    summary = flat(report).partition("Summary: the chosen coupling")[2]
    assert summary.index("rated torque") < summary.index("natural frequency")
    assert "steel-spring: peak torque" not in summary


@pytest.mark.parametrize("width", WIDTHS)
def test_lists_every_assumption_whole(outcome, width):
    text = plain_text(render_outcome(outcome), width)
    rests = flat(text.partition("Rests on")[2])
    for value in outcome.assumptions:
        key = value.path.rpartition(".")[2]
        assert f"{key} {value.text} {value.source}" in rests
        assert set(value.note.split()) <= set(rests.split())
    assert "coupling_types[2].damping (diaphragm)" in rests


def test_an_assumption_at_the_top_of_the_file(outcome):
    value = replace(outcome.assumptions[0], path="reading", text="combined_load")
    text = plain_text(render_outcome(replace(outcome, assumptions=(value,))))
    assert "top level reading combined_load fitted" in flat(text)
    assert "Rests on 1 assumed, fitted or invented value " in flat(text)


def test_text_of_the_case_is_no_markup(report):
    assert "steel-spring [bold]" in report


def test_without_a_design(no_design):
    text = flat(plain_text(render_outcome(no_design)))
    assert "No design meets the limits" in text
    nearest = "Nearest came: peak transmission force 46.69 kN, wanted <= 36.12 kN."
    assert text.count(nearest) == 2
    assert "steel-spring, key 0.5410 0.2800 9.963 70.17" in text
    assert "46.69 <= 36.12 -29.26 kN FAIL" in text
    assert "Step 5: Key gap - SKIPPED" in text
    assert "Take " not in text


def test_the_verdict_of_the_strict_reading(outcome):
    strict = replace(outcome.strict_reading, passes=True, criteria=())
    case = replace(outcome.case, reading=LoadLimitReading.COMBINED_LOAD)
    text = flat(
        plain_text(render_outcome(replace(outcome, case=case, strict_reading=strict)))
    )
    assert "Strict reading of the load limit: PASS" in text
    assert "with the lever of the overhang" in text


def test_damage_that_rises_is_said_to_rise(outcome):
    worse = replace(outcome.chosen, damage_reduction=-0.12)
    text = plain_text(render_outcome(replace(outcome, chosen=worse)))
    assert "rises by 12 %" in text


def test_nothing_assumed(outcome):
    text = plain_text(render_outcome(replace(outcome, assumptions=())))
    assert "No value is assumed, fitted or invented." in text


def test_boxes_fall_back_to_ascii(outcome):
    target = io.BytesIO()
    stream = io.TextIOWrapper(target, encoding="ascii", errors="strict")
    console = Console(file=stream, width=80, color_system=None, _environ={})
    console.print(render_outcome(outcome))
    stream.flush()
    text = target.getvalue().decode("ascii")
    assert max(map(len, text.splitlines())) <= 80
    assert "33.93" in text

"""Small inputs with one thing wrong each: what a design of them says first.

The rows of tests/case/test_inputs.py say what `check` finds without a run-down.
"""

import json
from pathlib import Path

import pytest

from coupling_design.__main__ import main
from coupling_design.flow.design import run_design
from coupling_design.parts.criterion import Verdict

INPUTS = Path(__file__).parents[1] / "inputs"
DEADLY = {
    "bearing_rating_1_N": (
        "damage of one stop",
        "Present coupling: Drive end does not survive one stop: its damage is ",
    ),
    "bearing_ratings_in_N": (
        "largest bearing load over C_0",
        "Present coupling: the largest load of Drive end, 3.728 kN, is above its "
        "static rating C_0 = 0.108 kN.",
    ),
}
# What stands among the warnings of a design; where it begins.
FIRST = {
    "stops_above_resonance": ": the run-down ends at ",
    "resonance_not_met": ":16: shutdown.initial_speed: the run-down does not pass",
    "contact_softer_than_coupling": ":10: driveline.connection.contact_stiffness: ",
    "rated_torque_of_a_toy": ":24: duty.rated_torque: rated power, ",
    "speed_6000_rpm": ":23: duty.working_speed.highest: highest working speed is 6000",
    "engine_misfire_but_motored": ":26: driveline.excitation.engine.misfiring_",
}


@pytest.fixture(scope="session")
def designed(tiny, tiny_effort):
    """Return the outcome of an input, made once and with little effort."""
    made = {}

    def design(name):
        if name not in made:
            made[name] = run_design(tiny(name), effort=tiny_effort)
        return made[name]

    return design


@pytest.mark.parametrize("name", DEADLY)
def test_a_bearing_that_does_not_survive_is_never_recommended(name, designed):
    limit, words = DEADLY[name]
    outcome = designed(name)
    assert outcome.chosen is None
    failing = [each for each in outcome.nearest_criteria if each.name == limit]
    assert [each.verdict for each in failing] == [Verdict.FAIL]
    assert any(each.startswith(words) for each in outcome.warnings)
    assert any(each.startswith("Nearest coupling: ") for each in outcome.warnings)


@pytest.mark.parametrize("name", FIRST)
def test_read_first(name, designed):
    assert any(FIRST[name] in each for each in designed(name).warnings)


def test_without_a_t_kmax2_the_short_circuit_is_not_checked(designed):
    outcome = designed("catalogue_without_T_Kmax2")
    rare = [
        criterion
        for step in outcome.steps
        for criterion in step.criteria
        if "rare torque" in criterion.name or "short circuit" in criterion.name
    ]
    assert rare
    assert {criterion.verdict for criterion in rare} == {Verdict.NOT_CHECKED}


def test_orders_that_are_rounding_only_are_not_listed(tiny):
    """Six cylinders that fire evenly have multiples of 3, whatever the threshold."""
    case = tiny("engine_threshold_zero")
    assert [each.order for each in case.driveline.excitation] == [3, 6, 9, 12]


@pytest.mark.slow
@pytest.mark.parametrize("name", DEADLY)
def test_the_command_says_so(name, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "100")
    assert main(["design", str(INPUTS / f"{name}.yaml"), "--output", "out"]) == 1
    out, err = capsys.readouterr()
    assert "Traceback" not in err
    top = out[: out.index("╰")]
    assert top.index("Read first") < top.index("Asked") < top.index("Answer")
    assert "No design meets the limits." in top
    assert "Take " not in top
    written = json.loads(Path("out/design.json").read_text(encoding="utf-8"))
    assert written["chosen"] is None
    assert written["warnings"]

"""The chosen design as a case: complete, in the user's words, the same numbers."""

import json
from pathlib import Path

import pytest

from coupling_design.__main__ import main
from coupling_design.case import load_case
from coupling_design.errors import DesignError
from coupling_design.flow.design import silent
from coupling_design.report.files.chosen_case import chosen_case_text
from coupling_design.search.workbench import Workbench
from coupling_design.steps.present import evaluate_baseline

QUICK = Path(__file__).parents[1] / "fixtures" / "quick.yaml"
CALM = ["excitation[0].amplitude=20 N*m", "excitation[1].amplitude=6.7 N*m"]


@pytest.fixture(scope="module")
def designed(tmp_path_factory):
    """The results of a stiff, tight design, and of an elastic one by overrides."""

    def design(name, *overrides):
        directory = tmp_path_factory.mktemp(name)
        options = [option for each in overrides for option in ("--set", each)]
        assert main([str(QUICK), "--output", str(directory), *options]) == 0
        return directory

    return {"stiff": design("stiff"), "elastic": design("elastic", *CALM)}


@pytest.mark.parametrize("name", ["stiff", "elastic"])
def test_it_gives_the_same_numbers(designed, name):
    chosen = json.loads((designed[name] / "design.json").read_text())["chosen"]
    case = load_case(designed[name] / "chosen.yaml")
    again = evaluate_baseline(Workbench(case, silent))
    assert again.coupling_type == chosen["coupling_type"]
    assert again.connection == chosen["connection"]
    performance = again.performance
    for key in ("torsional_stiffness", "key_gap", "natural_frequency", "damage",
                "peak_transmission_force"):  # fmt: skip
        assert getattr(performance, key) == pytest.approx(chosen[key], rel=1e-9)
    assert performance.damages == pytest.approx(chosen["damages"], rel=1e-9)


def test_comments_and_units_stay(designed):
    before = QUICK.read_text().splitlines()
    after = (designed["stiff"] / "chosen.yaml").read_text().splitlines()
    lost = [line.split(":")[0].strip() for line in before if line not in after]
    assert lost == ["type", "torsional_stiffness", "kind", "gap"]


def test_overrides_are_in_the_case_and_told(designed):
    case = load_case(designed["elastic"] / "chosen.yaml")
    assert case.driveline.excitation[0].amplitude == 20
    text = (designed["elastic"] / "chosen.yaml").read_text()
    assert "--set driveline.excitation[0].amplitude=20 N*m" in text
    result = json.loads((designed["elastic"] / "design.json").read_text())
    assert result["case"]["overrides"][0].startswith("driveline.excitation[0].ampl")
    assert result["inputs"]["driveline.excitation[0].amplitude"]["value"] == 20
    report = (designed["elastic"] / "report.txt").read_text()
    assert "--set driveline.excitation[0].amplitude=20 N*m" in report


def test_a_file_changed_meanwhile_is_not_mixed_in(designed, outcome_of, tmp_path):
    outcome, file = outcome_of(tmp_path)
    file.write_text(file.read_text() + "\n# changed\n")
    with pytest.raises(DesignError, match="was changed during the run"):
        chosen_case_text(outcome, tmp_path)


@pytest.fixture
def outcome_of():
    from coupling_design import api
    from coupling_design.search.workbench import Effort

    def made(directory):
        file = directory / "case.yaml"
        file.write_text(QUICK.read_text())
        return api.design(api.load(file), effort=Effort(3, 2, 2, 2, 1)), file

    return made

import json
from dataclasses import replace

import numpy
import pytest

from coupling_design.parts.criterion import not_checked
from coupling_design.report.files.json import build_document, document_text
from coupling_design.report.files.json_parts import criterion_part

PERFORMANCE = {
    "torsional_stiffness", "key_gap", "natural_frequency", "damage", "damage_e6",
    "damages", "peak_transmission_force", "peak_combined_load",
}  # fmt: skip


@pytest.fixture(scope="module")
def document(outcome):
    return json.loads(document_text(build_document(outcome)))


def test_round_trip(outcome, document):
    assert document == build_document(outcome)


def test_top_level(document):
    assert list(document) == [
        "schema_version", "units", "case", "software", "inputs", "reading", "baseline",
        "steps", "chosen", "nearest", "nearest_criteria", "strict_reading",
        "fatigue_limits", "catalogue_choice", "assumptions", "warnings", "reasons",
        "remarks", "engine", "rollouts", "coarse_rollouts", "run_time_s",
    ]  # fmt: skip
    assert document["schema_version"] == 1
    assert document["case"]["file"] == "cases/16v280.yaml"
    assert len(document["case"]["sha256"]) == 64
    assert document["reading"] == "transmission_force"
    assert document["run_time_s"] == 43.27


def test_software(document):
    software = document["software"]
    assert software["name"] == "coupling_design"
    assert {"version", "python", "casadi", "numpy", "platform"} <= set(software)
    assert all(isinstance(version, str) for version in software.values())


def test_units_are_of_keys_that_exist(document, with_catalogue):
    def keys(part):
        if isinstance(part, dict):
            for key, value in part.items():
                yield key
                yield from keys(value)
        elif isinstance(part, list):
            for entry in part:
                yield from keys(entry)

    content = {key: value for key, value in document.items() if key != "units"}
    sizes = build_document(with_catalogue)["catalogue_choice"]
    assert set(document["units"]) <= {*keys(content), *keys(sizes)}


def test_baseline_is_si(document):
    baseline = document["baseline"]
    assert set(baseline) >= PERFORMANCE
    assert baseline["torsional_stiffness"] == 541e3
    assert baseline["key_gap"] == 0.28e-3
    assert baseline["natural_frequency"] == 9.963
    assert baseline["damage"] == 4.0512345e-9
    assert baseline["damage_e6"] == pytest.approx(0.0040512345)
    assert baseline["peak_combined_load"] == [97361.0, 28981.0]
    assert baseline["resonance_speed_rpm"] == pytest.approx(125.48, abs=0.01)


def test_steps(document):
    steps = document["steps"]
    assert [step["step"] for step in steps] == [1, 2, 3, 4, 5]
    decisions = [step["decision"] for step in steps]
    assert decisions == ["pass", "pass", "fail", "pass", "pass"]
    [limit] = steps[2]["criteria"]
    assert limit == {
        "name": "peak transmission force",
        "value": 46690.0,
        "limit": 36120.18,
        "sense": "<=",
        "unit": "N",
        "verdict": "fail",
        "passes": False,
        "margin": -0.29263,
        "source": "F_min less the static load (eq. 7)",
    }
    assert steps[0]["optimum"] is None
    assert set(steps[3]["optimum"]) >= PERFORMANCE | {"method", "solver_status"}
    assert steps[3]["optimum"]["conditioning"]["digits"] == 4
    assert steps[2]["optimum"]["kkt_residual"] is None
    assert steps[2]["alternatives"][0]["performance"]["key_gap"] == 0.28e-3


def test_a_limit_that_could_not_be_checked_is_neither_passed_nor_failed():
    part = criterion_part(not_checked("D: power loss", unit="W", missing="no P_KV"))
    assert part["verdict"] == "not checked"
    assert (part["passes"], part["limit"], part["margin"]) == (None, None, None)
    assert part["source"] == "no P_KV"


def test_chances_and_moves_of_inputs(document):
    spread = document["chosen"]["spread"]
    assert spread["damages"] == [[2.4e-9, 2.7e-9], [6.1e-11, 7.0e-11]]
    assert spread["mean_peak"] == 33910.0
    [move] = document["baseline"]["sensitivity"]["moves"]
    assert move == {
        "name": "initial speed", "factor": 0.97, "damage": 3.98e-9, "peak": 70170.0,
    }  # fmt: skip
    assert document["chosen"]["reduction_range"] == [0.312, 0.401]
    bound = document["chosen"]["fuel_cut_at_once"]
    assert bound["peak_transmission_force"] == 59519.7


def test_chosen(document):
    chosen = document["chosen"]
    assert set(chosen) >= PERFORMANCE | {"conditioning"}
    assert chosen["plan"] == "high_stiffness"
    assert chosen["connection"] == "tight_fit"
    assert chosen["damage_reduction"] == pytest.approx(0.36757, abs=1e-5)
    assert chosen["rundown"]["rest_time"] is None


def test_strict_reading(document):
    strict = document["strict_reading"]
    assert strict["reading"] == "combined_load"
    assert strict["passes"] is False
    assert strict["permissible_transmission_force"] == 28896.14
    assert strict["criteria"][0]["name"] == "peak combined load, Bearing 1"


def test_assumptions(outcome, document):
    assert len(document["assumptions"]) == len(outcome.assumptions)
    entry = next(
        entry
        for entry in document["assumptions"]
        if entry["path"] == "driveline.coupling.torsional_stiffness"
    )
    assert entry["text"] == "0.4904 MN*m/rad"
    assert (entry["value"], entry["unit"]) == (490.4e3, "N*m/rad")
    assert entry["source"] == "fitted"


def test_without_a_design(no_design):
    document = json.loads(document_text(build_document(no_design)))
    assert document["chosen"] is None
    assert document["nearest"]["peak_transmission_force"] == 70173.0
    assert document["nearest_criteria"][0]["passes"] is False


def test_numpy_numbers_are_numbers(outcome):
    counted = replace(outcome.steps[4].optimum, starts_agreeing=numpy.int64(2))
    step = replace(outcome.steps[4], optimum=counted)
    text = document_text(build_document(replace(outcome, steps=(step,))))
    assert json.loads(text)["steps"][0]["optimum"]["starts_agreeing"] == 2


@pytest.mark.parametrize("value", [float("nan"), float("inf")])
def test_a_number_that_is_not_finite_is_refused(outcome, value):
    broken = build_document(replace(outcome, run_time=value))
    with pytest.raises(ValueError, match="not JSON compliant"):
        document_text(broken)

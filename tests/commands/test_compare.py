import json
from pathlib import Path

import pytest


@pytest.fixture
def changed(quick, tmp_path):
    text = Path(quick).read_text().replace("gap: 0.10 mm", "gap: 0.15 mm")
    (tmp_path / "changed.yaml").write_text(text)
    return "changed.yaml"


def line_of(text, start):
    return next(line for line in text.splitlines() if line.startswith(start)).split()


def test_two_cases(run, quick, changed):
    code, out, err = run("compare", quick, changed)
    assert (code, err) == (0, "")
    gap = line_of(out, "driveline.connection.gap")
    assert gap == ["driveline.connection.gap", "0.10", "mm", "0.15", "mm"]
    result = line_of(out, "present: key gap")
    assert result[3:] == ["0.1000", "0.1500", "+50.00", "mm"]
    assert line_of(out, "present: damage ")[-2] != "0"


def test_the_same_case(run, quick):
    out = run("compare", quick, quick)[1]
    assert "no value differs" in out
    assert line_of(out, "present: damage ")[-2] == "0"


def result(**changes):
    part = {"coupling_type": "rubber", "torsional_stiffness": 2e3, "damage": 1e-9}
    return {
        "inputs": {"shaft.rotor_weight": {"value": 2200.0, "unit": "N", "text": "a"}},
        "baseline": part,
        "chosen": {**part, "damage": 5e-10},
        **changes,
    }


def test_two_results(run):
    Path("a.json").write_text(json.dumps(result()))
    weight = {"shaft.rotor_weight": {"value": 2400.0, "unit": "N", "text": "b"}}
    Path("b.json").write_text(json.dumps(result(inputs=weight, chosen=None)))
    code, out, _ = run("compare", "a.json", "b.json")
    assert code == 0
    assert line_of(out, "shaft.rotor_weight") == ["shaft.rotor_weight", "a", "b"]
    assert line_of(out, "chosen: damage") == ["chosen:", "damage", "5.00e-10", "-"]


def test_a_result_without_inputs(run):
    Path("a.json").write_text(json.dumps(result(inputs=None)))
    out = run("compare", "a.json", "a.json")[1]
    assert "does not record them" in out


def test_a_case_and_a_result(run, quick):
    Path("a.json").write_text(json.dumps(result()))
    code, out, _ = run("compare", quick, "a.json")
    assert code == 0
    assert "no value differs" in out


@pytest.mark.parametrize(
    ("text", "said"),
    [("{", "cannot be read as JSON"), ("[]", "is no design.json")],
)
def test_what_is_no_result(run, quick, text, said):
    Path("a.json").write_text(text)
    code, _, err = run("compare", quick, "a.json")
    assert code == 2
    assert said in err


def test_a_missing_result(run, quick):
    code, _, err = run("compare", quick, "none.json")
    assert code == 2
    assert "there is no such file" in err

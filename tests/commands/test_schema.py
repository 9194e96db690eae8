import json
from pathlib import Path

import jsonschema
import pytest
import yaml

from coupling_design.case.schema.json_schema import case_schema

ROOT = Path(__file__).parents[2]
SHIPPED = sorted((ROOT / "cases").glob("*.yaml"))
OTHERS = [
    ROOT / "tests" / "fixtures" / "quick.yaml",
    ROOT / "coupling_design" / "case" / "template.yaml",
]


@pytest.fixture(scope="module")
def validator():
    schema = case_schema()
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


@pytest.fixture
def data(quick):
    return yaml.safe_load(Path(quick).read_text())


@pytest.mark.parametrize("file", [*SHIPPED, *OTHERS], ids=lambda path: path.stem)
def test_good_cases_pass(validator, file):
    validator.validate(yaml.safe_load(file.read_text(encoding="utf-8")))


@pytest.mark.parametrize(
    ("section", "key", "value"),
    [
        ("driveline", "engine_inertia", 2.5),
        ("driveline", "engine_inertia", "two kg*m^2"),
        ("driveline", "engine_inertia", {"value": "2.5 kg*m^2", "sauce": "paper"}),
        ("driveline", "engine_inertia", {"source": "paper"}),
        ("driveline", "engine_inertia", {"value": "2.5 kg*m^2", "source": "hearsay"}),
        ("driveline", "engine_inertia", None),
        ("driveline", "motor_inertia", "2.5 kg*m^2"),
        ("lubrication", "cleanliness", "spotless"),
        ("lubrication", "reliability", "high"),
    ],
)
def test_mistakes_are_found(validator, data, section, key, value):
    data[section][key] = value
    [error] = validator.iter_errors(data)
    assert section in error.json_path


def test_a_missing_key_is_found(validator, data):
    del data["duty"]["rated_torque"]
    [error] = validator.iter_errors(data)
    assert "'rated_torque' is a required property" in error.message


def test_a_third_bearing_is_found(validator, data):
    data["bearings"].append(data["bearings"][0])
    assert not validator.is_valid(data)


@pytest.mark.parametrize("order", [4, 4.5, "4.0", {"value": 4, "source": "measured"}])
def test_plain_numbers_need_no_quotes(validator, data, order):
    data["driveline"]["excitation"][0]["order"] = order
    validator.validate(data)


def test_editors_get_descriptions_and_examples():
    text = json.dumps(case_schema())
    assert "a torsional stiffness, such as 0.347 MN*m/rad" in text
    assert "coupling_design__" not in text


def test_to_the_screen(run):
    code, out, _ = run("schema")
    assert code == 0
    assert json.loads(out) == case_schema()


def test_to_a_file(run):
    code, out, _ = run("schema", "--out", "case.schema.json")
    assert (code, out) == (0, "Written: case.schema.json\n")
    assert json.loads(Path("case.schema.json").read_text()) == case_schema()

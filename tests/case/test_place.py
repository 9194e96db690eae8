"""Where a value stands, as messages begin with it."""

from dataclasses import replace


def test_file_line_and_path(load, valid):
    line = valid[: valid.index("rated_torque")].count("\n") + 1
    case = load(valid)
    assert case.place("duty.rated_torque") == f"case.yaml:{line}: duty.rated_torque"


def test_an_entry_of_a_list(load, valid):
    line = valid[: valid.index("static_load_rating")].count("\n") + 1
    path = "bearings[0].static_load_rating"
    assert load(valid).place(path) == f"case.yaml:{line}: {path}"


def test_a_value_that_stands_nowhere(load, valid):
    assert load(valid).place("duty.rare_torque") == "case.yaml: duty.rare_torque"


def test_a_value_without_a_line(load, valid):
    case = load(valid)
    values = tuple(replace(value, line=None) for value in case.provenance)
    bare = replace(case, provenance=values)
    assert bare.place("duty.rated_torque") == "case.yaml: duty.rated_torque"

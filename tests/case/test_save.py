import pytest
import yaml
from hypothesis import given
from hypothesis import strategies as st

from coupling_design.case.edit.overrides import override
from coupling_design.case.edit.text import changed_text, exact_text, moved, quoted
from coupling_design.case.load import read_document
from coupling_design.case.values.kinds import GAP, STIFFNESS


@pytest.fixture
def changed(write, valid):
    """Return the text of the valid case after changes, and the data it should have."""
    document = read_document(write(valid))

    def made(*assignments):
        text = changed_text(valid, document, assignments)
        wanted = override(document, assignments).data
        assert yaml.safe_load(text) == wanted
        return text

    return made


def test_only_the_value_changes(changed, valid):
    text = changed("connection.gap=0.15 mm")
    before, after = valid.splitlines(), text.splitlines()
    [(old, new)] = [(a, b) for a, b in zip(before, after, strict=True) if a != b]
    assert old.replace("0.10 mm", "0.15 mm") == new


@pytest.mark.parametrize(
    "assignment",
    [
        "connection.gap={value: 0.15 mm, source: derived, note: 'a, b'}",
        "driveline.connection.gap=",
        "duty.rare_torque=9 kN*m",
        "excitation[0].amplitude=3 N*m",
        "driveline.engine_resistance={viscous: 1 N*m*s/rad}",
        "design_space.connections={tight_fit: {}}",
        "design_space.connections.tight_fit={}",
        "driveline.coupling.driving_inertia=1 kg*m^2",
        "coupling_types[0].name='a: b # c'",
        "description=a text of several words",
    ],
)
def test_the_text_has_the_wanted_data(changed, assignment):
    changed(assignment)


def test_many_changes(changed):
    changed("gap=", "connection.gap=0.1 mm", "connection.gap=0.2 mm", "name=x")


def test_comments_stay(write):
    text = "# top\nname: a  # of it\n# more\nduty:\n  # why\n  peak_torque: 1 N*m # s\n"
    document = read_document(write(text))
    after = changed_text(text, document, ["name=b", "peak_torque=2 N*m"])
    assert after == text.replace("name: a", "name: b").replace("1 N*m", "2 N*m")


def test_flow_mappings(write):
    text = "duty: {rated_torque: 1 N*m, peak_torque: 2 N*m}\n"
    document = read_document(write(text))
    after = changed_text(text, document, ["rated_torque=", "service_factor=1.2"])
    assert after == "duty: {service_factor: 1.2, peak_torque: 2 N*m}\n"


def test_where_the_text_does_not_serve_the_data_do(write):
    text = "name: a\ndescription: >-\n  one\n  two\n\nreading: x\n"
    document = read_document(write(text))
    after = changed_text(text, document, ["description=c", "reading=y, z"])
    assert yaml.safe_load(after) == {
        "name": "a", "description": "c", "reading": "y, z"
    }  # fmt: skip


def test_catalogues_are_found_from_elsewhere(write, tmp_path):
    document = read_document(write("catalogue: [sizes.yaml, more/own sizes.yaml]\n"))
    away = tmp_path / "reports" / "x"
    assert moved(document, away.relative_to(tmp_path)) == (
        "catalogue[0]='../../sizes.yaml'",
        "catalogue[1]='../../more/own sizes.yaml'",
    )


@given(st.floats(1e-3, 1e12))
def test_a_quantity_reads_back_to_the_last_bit(value):
    kind = STIFFNESS.positive()
    for like in ("0.5 MN*m/rad", "12 kN*m/rad", ""):
        assert kind.parse(exact_text(value, kind, like)) == value


def test_a_quantity_keeps_its_unit():
    assert exact_text(0.28e-3, GAP, "0.3 mm") == "0.28 mm"


@given(st.text(st.characters(codec="ascii", exclude_categories=["Cc"])))
def test_any_text_can_be_written(text):
    assert yaml.safe_load(f"{{a: {quoted(text)}}}") == {"a": text}

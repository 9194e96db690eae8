from pathlib import Path

import pytest

from coupling_design.case import load_case
from coupling_design.case.edit.overrides import override
from coupling_design.case.load import read_document
from coupling_design.case.text.document import parse_text
from coupling_design.errors import CaseError


@pytest.fixture
def changed(write, valid):
    """Load the valid case with some values replaced."""
    file = write(valid)
    return lambda *assignments: load_case(file, assignments)


@pytest.fixture
def refused(changed):
    """Return what is said of assignments that are no good."""

    def sentences(*assignments):
        with pytest.raises(CaseError) as error:
            changed(*assignments)
        return error.value.problems

    return sentences


def test_without_any_nothing_changes(changed):
    assert changed().overrides == ()


@pytest.mark.parametrize(
    "assignment",
    ["driveline.connection.gap=0.12mm", "connection.gap = 0.12 mm", "gap=0.12 mm"],
)
def test_a_value_by_its_path_or_its_end(changed, assignment):
    case = changed(assignment)
    assert case.driveline.connection.gap == 0.12e-3
    [told] = case.overrides
    assert told.startswith("driveline.connection.gap=0.12")


def test_the_file_keeps_its_checksum(changed):
    assert changed("gap=0.12mm").sha256 == changed().sha256


def test_of_two_places_that_of_a_section_the_file_has():
    """An engine may stand for the shutdown and at work; this file has the former."""
    file = Path(__file__).parents[2] / "cases" / "16v280_engine.yaml"
    case = load_case(file, ["engine.mode=fired", "indicated_mean_pressure=8bar"])
    paths = [told.split("=")[0] for told in case.overrides]
    assert paths == [
        "driveline.excitation.engine.mode",
        "driveline.excitation.engine.indicated_mean_pressure",
    ]


def test_entries_of_lists_by_number_and_name(changed):
    name = changed().bearings[1].name
    assert changed("bearings[1].pitch_diameter=1 m").bearings[1].pitch_diameter == 1
    case = changed(f"bearings[{name}].pitch_diameter=2 m")
    assert case.bearings[1].pitch_diameter == 2


def test_words(changed):
    case = changed("reading=combined_load", "cleanliness=high")
    assert case.reading == "combined_load"
    assert case.lubrication.cleanliness == "high"


def test_a_source_may_be_given(changed):
    case = changed("connection.gap={value: 0.12 mm, source: measured}")
    [value] = [v for v in case.provenance if v.path == "driveline.connection.gap"]
    assert (value.value, value.source, value.text) == (0.12e-3, "measured", "0.12 mm")


def test_the_files_source_is_not_that_of_another_value(changed):
    case = changed("connection.gap=0.12 mm")
    [value] = [v for v in case.provenance if v.path == "driveline.connection.gap"]
    assert (value.source, value.note) == (None, "")


def test_no_value_takes_a_key_out(changed):
    fit = "coupling_types[0].connections=[tight_fit]"
    space = "design_space.connections={tight_fit: {}}"
    case = changed("kind=tight_fit", "gap=", fit, space)
    assert case.present_connection == "tight_fit"


def test_the_last_of_two_counts(changed):
    case = changed("gap=0.12mm", "connection.gap=0.13mm")
    assert case.driveline.connection.gap == 0.13e-3
    assert case.overrides == ("driveline.connection.gap=0.13mm",)


def test_a_whole_section(changed):
    damping = "{law: loss_factor, loss_factor: 0.1}"
    case = changed(f"coupling_types[0].damping={damping}")
    assert case.coupling_types[0].damping_law.loss_factor == 0.1


def test_the_original_stays(write, valid):
    document = read_document(write(valid))
    before = document.text(("driveline", "connection", "gap"))
    override(document, ["gap=0.12mm"])
    assert document.text(("driveline", "connection", "gap")) == before
    assert document.overrides == {}


@pytest.mark.parametrize(
    ("assignment", "said"),
    [
        ("gap", "--set gap: expected path=value, such as connection.gap=0.1mm"),
        ("=3", "expected path=value"),
        ("gapp=1 mm", "'gapp' is no key of a case; did you mean driveline.connect"),
        ("xyzzy=1", "'xyzzy' is no key of a case; allowed is any path"),
        ("lowest=1", "may mean duty.working_speed.lowest, coupling_types[0].stiff"),
        ("bearings[7].name=x", "is no key of a case"),
        ("bearings[0]=", "an entry of a list cannot be taken out"),
        ("gap=[1", "the value cannot be read: not YAML"),
        ("gap=*x", "the value cannot be read: not YAML"),
        ("connection={kind: key, kind: key}", "key 'kind' is given twice"),
    ],
)
def test_what_cannot_be_understood(refused, assignment, said):
    [sentence] = refused(assignment)
    assert sentence.startswith(f"--set {assignment}: ")
    assert said in sentence


def test_all_problems_at_once(refused):
    assert len(refused("gapp=1 mm", "reeding=x")) == 2


def test_a_wrong_value_names_the_command_line(refused):
    [sentence] = refused("gap=12 kg")
    assert sentence.startswith("--set driveline.connection.gap=12 kg: found '12 kg'")


def test_inside_a_section_the_path_is_named_too(refused):
    sentences = refused("engine_resistance={viscous: 1 kg}")
    assert all(
        "--set driveline.engine_resistance={viscous: 1 kg}: " in s for s in sentences
    )
    assert any(": driveline.engine_resistance.viscous: found" in s for s in sentences)


def test_a_file_that_is_no_case_says_so_itself():
    document = parse_text("- 1", "x.yaml")
    assert override(document, ["gap=1 mm"]) is document

"""Catalogues of real sizes: what they become, and what is said of faulty ones."""

import hashlib
import math
from pathlib import Path

import pytest

from coupling_design.case import load_case
from coupling_design.errors import CaseError
from coupling_design.line.parameters import ProportionalDamping, RelativeDamping
from coupling_design.machine.coupling_size import CouplingKind
from coupling_design.machine.words import Choice, ConnectionKind, Plan, Source

ROOT = Path(__file__).parents[2]
SIZES = Path(__file__).with_name("sizes.yaml").read_text(encoding="utf-8")
NAMED = "catalogue: [sizes.yaml]\n"


@pytest.fixture
def catalogue(tmp_path):
    """Write a catalogue into the folder of the case."""

    def write(text=SIZES, name="sizes.yaml"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text, encoding="utf-8")

    write()
    return write


def test_a_series_is_a_coupling_type(load, valid, catalogue):
    case = load(valid + NAMED)
    rubber, series = case.coupling_types
    assert rubber.sizes == ()
    assert (series.name, series.description) == ("SR", "soft rubber")
    assert series.plan is Plan.ELASTIC
    assert series.damping_law == RelativeDamping(1.1)
    # Of its own connections the one that the case offers.
    assert series.connections == (ConnectionKind.KEY,)


def test_a_series_spans_its_sizes_and_takes_what_the_least_of_them_takes(
    load, valid, catalogue
):
    series = load(valid + NAMED).coupling_types[1]
    assert [size.name for size in series.sizes] == ["SR 2", "SR 4"]
    assert series.stiffness_range == (12e3, 24e3)
    assert (series.nominal_torque, series.maximum_torque) == (2e3, 5e3)
    assert series.maximum_speed == pytest.approx(2000 * math.pi / 30)


def test_a_size_in_si(load, valid, catalogue):
    small, large = load(valid + NAMED).coupling_types[1].sizes
    assert (small.series, small.kind) == ("SR", CouplingKind.RUBBER)
    assert (small.nominal_torque, small.maximum_torque) == (2e3, 5e3)
    assert (small.rare_maximum_torque, small.vibratory_torque) == (6e3, 600.0)
    assert small.power_loss == 250.0
    assert small.maximum_speed == pytest.approx(2500 * math.pi / 30)
    assert small.torsional_stiffness == 12e3
    assert (small.driving_inertia, small.driven_inertia) == (0.06, 0.02)
    assert small.damping_law == RelativeDamping(1.1)
    assert (small.source, small.note) == ("invented", "guessed")
    assert large.damping_law == ProportionalDamping(0.8, 290.0)
    assert large.vibratory_torque is large.power_loss is large.driven_inertia is None
    assert (large.source, large.note) == ("catalogue", "sheet 7")


def test_the_weakest_source_of_a_series_is_told(load, valid, catalogue):
    case = load(valid + NAMED)
    [told] = [value for value in case.assumptions if value.path == "catalogue.SR"]
    assert (told.source, told.text) == (Source.INVENTED, "2 sizes")
    certain = SIZES.replace("source: invented", "source: measured")
    catalogue(certain)
    assert not any(v.path == "catalogue.SR" for v in load(valid + NAMED).assumptions)


def test_files_are_told_with_their_hash(load, valid, catalogue):
    [file] = load(valid + NAMED).catalogues
    assert (file.file, file.name) == ("sizes.yaml", "Example sizes")
    assert file.sha256 == hashlib.sha256(SIZES.encode()).hexdigest()


def test_paths_count_from_the_case_file(tmp_path, valid, catalogue, monkeypatch):
    (tmp_path / "cases").mkdir()
    catalogue(SIZES.replace("SR", "MY"), "cases/my.yaml")
    case = tmp_path / "cases" / "case.yaml"
    case.write_text(f"{valid}catalogue: [../sizes.yaml, my.yaml]\n", encoding="utf-8")
    monkeypatch.chdir("/")
    assert [t.name for t in load_case(case).coupling_types] == ["rubber", "SR", "MY"]


def without_types(valid):
    start = valid.index("coupling_types:")
    return valid[:start] + valid[valid.index("design_space:") :]


def test_a_catalogue_alone_is_enough(load, valid, catalogue):
    text = without_types(valid).replace("type: rubber", "type: SR") + NAMED
    case = load(text)
    assert [t.name for t in case.coupling_types] == ["SR"]
    assert case.driveline.coupling.damping_law == RelativeDamping(1.1)


def test_neither_types_nor_catalogue(problems, valid):
    [problem] = problems(without_types(valid))
    assert "missing key 'coupling_types'; write a list" in problem
    assert "or name files of real sizes with the key catalogue" in problem


def test_no_catalogue_changes_nothing(load, valid):
    case = load(valid)
    assert case.catalogues == ()
    assert case.choose is Choice.OPTIMUM
    assert case.present_driving_inertia is None
    duty = case.duty
    assert (duty.rare_torque, duty.temperature_factor, duty.start_factor) == (
        None,
        1,
        1,
    )


def test_what_else_a_case_says_of_sizes(load, valid, catalogue):
    text = valid.replace(
        "service_factor: 1.2",
        (
            "service_factor: 1.2\n  rare_torque: 9 kN*m\n  temperature_factor: 1.4\n"
            "  start_factor: 1.3"
        ),
    ).replace(
        "    type: rubber\n", "    type: rubber\n    driving_inertia: 0.5 kg*m^2\n"
    )
    case = load(text + "  choose: catalogue\n" + NAMED)
    duty = case.duty
    assert duty.rare_torque == 9e3
    assert (duty.temperature_factor, duty.start_factor) == (1.4, 1.3)
    assert case.present_driving_inertia == 0.5
    assert case.choose is Choice.CATALOGUE


def test_all_problems_of_case_and_catalogues_at_once(problems, valid, catalogue):
    catalogue(
        SIZES.replace("power_loss: 250 W", "power_los: 250 W")
        .replace("vibratory_torque: {value: 0.6 kN*m", "vibratory_torque: {value: 6 mm")
        .replace("type: rubber", "type: ruber")
    )
    found = problems(
        valid.replace("duration: 5 s", "duration: 5 mm")
        + "catalogue: [sizes.yaml, no.yaml]\n"
    )
    assert len(found) == 5
    assert found[0].startswith("case.yaml:")
    assert "duration: found '5 mm'" in found[0]
    assert "catalogue[1]: found 'no.yaml', but there is no file 'no.yaml'" in found[1]
    assert found[2].startswith("sizes.yaml:5: series[0].type: found 'ruber'")
    assert "did you mean 'rubber'?" in found[2]
    assert found[3].startswith("sizes.yaml:22: series[0].sizes[1].vibratory_torque: ")
    assert "unknown key 'power_los'; did you mean 'power_loss'?" in found[4]


@pytest.mark.parametrize(
    ("before", "after", "sentence"),
    [
        ("maximum_torque: 10 kN*m", "maximum_torque: 3 kN*m",
         "sizes.yaml:14: series[0].sizes[0].maximum_torque: found '3 kN*m', allowed "
         "nominal_torque '4 kN*m' or more"),
        ("rare_maximum_torque: 6 kN*m", "rare_maximum_torque: 4 kN*m",
         "allowed maximum_torque '5 kN*m' or more"),
        ("name: SR 4", "name: SR 2", "name 'SR 2' is given twice"),
        ("    source: catalogue\n", "", "missing key 'source'; write one of paper, "),
        ("law: proportional", "law: proportionall", "did you mean 'proportional'?"),
        ("power_loss: 250 W", "power_loss: 250", "a unit is needed: write a power"),
        ("power_loss: 250 W", "power_loss: 250 J", "that is a torque or energy"),
        ("name: Example sizes", "- 3", "sizes.yaml:"),
    ],
)  # fmt: skip
def test_a_faulty_catalogue(before, after, sentence, problems, valid, catalogue):
    assert before in SIZES
    catalogue(SIZES.replace(before, after, 1))
    found = problems(valid + NAMED)
    assert any(sentence in problem for problem in found), found


def test_a_catalogue_that_holds_something_else(problems, valid, catalogue):
    catalogue("just a word")
    [problem] = problems(valid + NAMED)
    assert problem == (
        "sizes.yaml:1: the file holds no mapping; expected the keys name, "
        "description, series"
    )


def test_a_faulty_catalogue_is_not_blamed_on_the_present_coupling(
    problems, valid, catalogue
):
    catalogue("name: [")
    [problem] = problems(valid.replace("type: rubber", "type: SR") + NAMED)
    assert problem.startswith("sizes.yaml:1: not YAML")


@pytest.mark.parametrize(
    ("before", "after", "sentence"),
    [
        ("name: rubber", "name: SR", "the series 'SR' is there twice"),
        ("type: rubber", "type: RS", "not among the coupling_types and series"),
        ("12 kN*m/rad", "30 kN*m/rad", "allowed 0.012 to 0.024 MN*m/rad, the sizes of"),
        ("    key:\n", "    tight_fit: {}\n    key:\n", None),
    ],
)
def test_case_and_catalogue_together(before, after, sentence, write, valid, catalogue):
    text = valid.replace(before, after, 1) + NAMED
    if sentence and "allowed 0.012" in sentence:
        text = text.replace("type: rubber", "type: SR", 1)
    if sentence is None:
        assert len(load_case(write(text)).coupling_types[1].connections) == 2
        return
    with pytest.raises(CaseError, match=r"case\.yaml") as error:
        load_case(write(text))
    assert any(sentence in problem for problem in error.value.problems)


def test_a_series_in_no_connection_of_the_case(problems, valid, catalogue):
    catalogue(SIZES.replace("[key, tight_fit]", "[tight_fit]"))
    [problem] = problems(valid + NAMED)
    assert "made with tight_fit, but design_space.connections offers key" in problem


def test_choosing_from_no_catalogue(problems, valid):
    [problem] = problems(valid + "  choose: catalogue\n")
    assert "design_space.choose: found 'catalogue', but the case names none" in problem


def test_two_orders_in_the_duty(problems, valid, catalogue):
    text = valid.replace(
        "service_factor: 1.2", "service_factor: 1.2\n  rare_torque: 1 N*m"
    )
    [problem] = problems(text + NAMED)
    assert "duty.rare_torque: found '1 N*m', allowed peak_torque" in problem


def test_every_shipped_entry_names_its_source():
    case = load_case(ROOT / "cases" / "16v280_catalogue.yaml")
    series = [each for each in case.coupling_types if each.sizes]
    assert {size.kind for each in series for size in each.sizes} == {
        CouplingKind.STEEL_SPRING, CouplingKind.RUBBER, CouplingKind.DIAPHRAGM,
    }  # fmt: skip
    assert all(len(each.sizes) >= 5 for each in series)
    assert {size.source for each in series for size in each.sizes} == {"invented"}

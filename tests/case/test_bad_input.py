"""Every kind of bad input: one sentence with file, line, found and allowed."""

import re

import pytest

from coupling_design.case import load_case
from coupling_design.errors import CaseError

# What stands in the valid case, what replaces it, the line that is blamed (the line
# of that text in the faulty file), and words of the sentence.
ONE_FAULT = {
    "negative gap": (
        "gap: 0.10 mm",
        "gap: -0.10 mm",
        "-0.10 mm",
        ["driveline.connection.gap: found '-0.10 mm', allowed 0 mm to 100 mm",
         "total tangential clearance"],
    ),
    "misspelt key": (
        "    gap: 0.10",
        "    gapp: 0.10",
        "gapp",
        ["unknown key 'gapp'; did you mean 'gap'? allowed: kind, radius, gap"],
    ),
    "unknown key far from any": (
        "  duration: 5 s",
        "  duration: 5 s\n  colour: red",
        "colour",
        ["unknown key 'colour'; allowed: initial_speed, duration, time_step"],
    ),
    "unknown top key": (
        "shutdown:",
        "solver: fast\nshutdown:",
        "solver",
        ["solver: unknown key 'solver'; allowed: name, description"],
    ),
    "missing quantity": (
        "  duration: 5 s\n",
        "",
        "shutdown:",
        ["shutdown: missing key 'duration'; write a time, such as 12 s"],
    ),
    "missing text": (
        "  - name: drive end\n    designation",
        "  - designation",
        "6318",
        ["bearings[0]: missing key 'name'; write a text"],
    ),
    "missing section": (
        "shaft:\n  hub_to_bearing_1: 150 mm\n  bearing_1_to_rotor: 300 mm\n"
        "  rotor_to_bearing_2: 300 mm\n  rotor_weight: 2200 N\n",
        "",
        "name: Example",
        ["missing key 'shaft'", "the keys hub_to_bearing_1, bearing_1_to_rotor"],
    ),
    "missing gap of a key": (
        "    gap: 0.10 mm\n",
        "",
        "connection:",
        ["driveline.connection: missing key 'gap'; a key has one"],
    ),
    "missing contact stiffness": (
        "    contact_stiffness: 1e7 N*m/rad\n",
        "",
        "connection:",
        ["missing key 'contact_stiffness'; the present key needs it"],
    ),
    "wrong dimension": (
        "radius: 50 mm",
        "radius: 50 kg",
        "50 kg",
        ["found '50 kg', that is a mass, expected a length, such as 0.28 mm"],
    ),
    "unnamed dimension": (
        "radius: 50 mm",
        "radius: 50 m^3",
        "m^3",
        ["of dimension [length] ** 3, expected a length"],
    ),
    "torque for stiffness": (
        "12 kN*m/rad",
        "12 kN*m",
        "torsional_stiffness",
        ["that is a torque or energy, expected a torsional stiffness",
         "write the angle too"],
    ),
    "Hz for an angular speed": (
        "initial_speed: 750 rpm",
        "initial_speed: 12.5 Hz",
        "Hz",
        ["found '12.5 Hz', that is a frequency (not an angular speed)", "rpm", "2 pi"],
    ),
    "1/min for an angular speed": (
        "initial_speed: 750 rpm",
        "initial_speed: 750 1/min",
        "1/min",
        ["that is a frequency (not an angular speed)", "as rpm"],
    ),
    "bare number": (
        "radius: 50 mm",
        "radius: 50",
        "radius",
        ["driveline.connection.radius: found '50', a unit is needed", "0.28 mm"],
    ),
    "bare number as text": (
        "1e7 N*m/rad",
        "1e7",
        "contact_stiffness",
        ["found '1e7', a unit is needed", "N*m/rad"],
    ),
    "unknown unit": (
        "radius: 50 mm",
        "radius: 50 furlong",
        "furlong",
        ["found '50 furlong', unknown unit 'furlong'; write a length as"],
    ),
    "unreadable unit": (
        "radius: 50 mm",
        "radius: 50 m*/(",
        "radius",
        ["'m*/(' is not a unit that can be read"],
    ),
    "root sign": (
        "23 MPa/N^0.5",
        "23 MPa/√N",
        "√",
        ["'MPa/√N' is not a unit that can be read", "3.62 MPa/N^0.5"],
    ),
    "decimal comma": (
        "gap: 0.10 mm",
        "gap: 0,10 mm",
        "0,10",
        ["found '0,10 mm', write the decimal mark as a point"],
    ),
    "no number": (
        "radius: 50 mm",
        "radius: large",
        "large",
        ["found 'large', expected a length: a number and a unit"],
    ),
    "not a number": (
        "order: 3\n",
        "order: .nan\n",
        ".nan",
        ["found '.nan', allowed are finite numbers"],
    ),
    "nan with a unit": (
        "radius: 50 mm",
        "radius: nan mm",
        "nan mm",
        ["found 'nan mm', expected a length: a number"],
    ),
    "infinite": (
        "rotor_weight: 2200 N",
        "rotor_weight: 1e999 N",
        "1e999",
        ["found '1e999 N', allowed are finite numbers"],
    ),
    "zero speed": (
        "initial_speed: 750 rpm",
        "initial_speed: 0 rpm",
        "0 rpm",
        ["found '0 rpm', allowed 0.00095493 rpm to"],
    ),
    "reliability over 100 %": (
        "reliability: 95 %",
        "reliability: 950 %",
        "950",
        ["found '950 %', allowed 90 % to 100 %"],
    ),
    "reliability between rows": (
        "reliability: 95 %",
        "reliability: 93 %",
        "93 %",
        ["found '93 %', between the rows of ISO 281", "90, 95, 96, 97, 98, 99,"],
    ),
    "misspelt word": (
        "cleanliness: normal",
        "cleanliness: nornal",
        "nornal",
        ["found 'nornal'; did you mean 'normal'? allowed: high, normal, slight_typ"],
    ),
    "word far from any": (
        "type: radial_ball\n    dynamic_load_rating: 151",
        "type: magnetic\n    dynamic_load_rating: 151",
        "magnetic",
        ["bearings[0].type: found 'magnetic'; allowed: radial_roller, radial_ball"],
    ),
    "unknown plan": (
        "plan: elastic",
        "plan: plastic",
        "plastic",
        ["did you mean 'elastic'? allowed: elastic, high_stiffness"],
    ),
    "unknown damping law": (
        "law: relative_damping",
        "law: relativ_damping",
        "law:",
        ["coupling_types[0].damping.law: found 'relativ_damping'",
         "did you mean 'relative_damping'?", "proportional, loss_factor"],
    ),
    "missing damping law": (
        "      law: relative_damping\n",
        "",
        "    damping:",
        ["coupling_types[0].damping: missing key 'law'; allowed: proportional"],
    ),
    "key of another damping law": (
        "      relative_damping: 1.1",
        "      relative_damping: 1.1\n      loss_factor: 0.1",
        "loss_factor",
        ["coupling_types[0].damping.loss_factor: unknown key 'loss_factor'; "
         "allowed: law, relative_damping"],
    ),
    "order given twice": (
        "order: 6",
        "order: 3.0",
        "order: 3.0",
        ["driveline.excitation[1].order: order '3.0' is given twice"],
    ),
    "key given twice": (
        "  duration: 5 s",
        "  duration: 5 s\n  duration: 6 s",
        "duration: 6 s",
        ["shutdown.duration: key 'duration' is given twice, first in line 35"],
    ),
    "list for a mapping": (
        "shutdown:\n  initial_speed: 750 rpm\n  duration: 5 s\n  time_step: 1e-4 s",
        "shutdown:\n  - 750 rpm",
        "shutdown:",
        ["found a list, expected a mapping with the keys initial_speed, duration"],
    ),
    "list for a quantity": (
        "radius: 50 mm",
        "radius: [50 mm]",
        "[50 mm]",
        ["driveline.connection.radius: found a list, expected a length"],
    ),
    "mapping for a list": (
        "connections: [key, spline]",
        "connections: {key: spline}",
        "{key: spline}",
        ["coupling_types[0].connections: found a mapping, expected a list"],
    ),
    "mapping for a text": (
        "name: Example",
        "name: {a: b}",
        "{a: b}",
        ["name: found a mapping, expected a text"],
    ),
    "empty list": (
        "connections: [key, spline]",
        "connections: []",
        "[]",
        ["found an empty list; write at least one entry"],
    ),
    "true for a number": (
        "service_factor: 1.2",
        "service_factor: yes",
        "yes",
        ["duty.service_factor: found 'yes', expected a plain number",
         "YAML reads yes"],
    ),
    "nothing for a quantity": (
        "radius: 50 mm",
        "radius:",
        "radius:",
        ["driveline.connection.radius: found nothing, expected a length"],
    ),
    "nothing for an optional section": (
        "    spline: {minimum_gap: 0.01 mm, maximum_gap: 0.05 mm}",
        "    spline: {minimum_gap: 0.01 mm, maximum_gap: 0.05 mm}\n    tight_fit:",
        "tight_fit:",
        ["design_space.connections.tight_fit: found nothing; write a value or"],
    ),
    "empty name": (
        "name: Example",
        'name: ""',
        "name:",
        ["name: found an empty text; write a name"],
    ),
    "unknown source": (
        "radius: 50 mm",
        "radius: {value: 50 mm, source: papier}",
        "papier",
        ["driveline.connection.radius.source: found 'papier'; did you mean 'paper'?"],
    ),
    "value missing beside its source": (
        "radius: 50 mm",
        "radius: {source: paper}",
        "{source",
        ["driveline.connection.radius: missing key 'value'; write a length"],
    ),
    "note with an unquoted comma": (
        "radius: 50 mm",
        "radius: {value: 50 mm, note: at rest, when cold}",
        "when cold",
        ["unknown key 'when cold' (put a text that holds a comma in quotes)"],
    ),
    "wrong value beside its source": (
        "radius: 50 mm",
        "radius:\n      value: -50 mm\n      source: paper",
        "value: -50 mm",
        ["driveline.connection.radius: found '-50 mm', allowed 0.001 mm to 1e+06 mm"],
    ),
    "unknown coupling type": (
        "type: rubber",
        "type: ruber",
        "ruber",
        ["found 'ruber', which is not among the coupling_types; "
         "did you mean 'rubber'? allowed: rubber"],
    ),
    "stiffness outside its type": (
        "12 kN*m/rad",
        "40 kN*m/rad",
        "40 kN*m/rad",
        ["allowed 8 kN*m/rad to 30 kN*m/rad, the range of coupling type 'rubber'"],
    ),
    "gap outside its connection": (
        "gap: 0.10 mm",
        "gap: 0.28 mm",
        "gap: 0.28 mm",
        ["allowed 0.02 mm to 0.20 mm, the range of a key in design_space"],
    ),
    "present connection its type is not made with": (
        "connections: [key, spline]",
        "connections: [spline]",
        "kind: key",
        ["found 'key', but coupling type 'rubber' is made with: spline"],
    ),
    "connection not offered": (
        "connections: [key, spline]",
        "connections: [key, tight_fit]",
        "tight_fit",
        ["coupling_types[0].connections[1]: found 'tight_fit', which "
         "design_space.connections does not offer; allowed: key, spline"],
    ),
    "a name given twice": (
        "name: other end",
        "name: drive end",
        r"name: drive end(?![\s\S]*name: drive end)",
        ["bearings[1].name: name 'drive end' is given twice"],
    ),
    "working speeds exchanged": (
        "lowest: 1450 rpm",
        "lowest: 1650 rpm",
        "highest: 1550 rpm",
        ["found '1550 rpm', allowed lowest '1650 rpm' or more"],
    ),
    "peak torque below rated": (
        "peak_torque: 3 kN*m",
        "peak_torque: 1 kN*m",
        "peak_torque: 1",
        ["found '1 kN*m', allowed rated_torque '1.3 kN*m' or more"],
    ),
    "stiffness range exchanged": (
        "highest: 30 kN*m/rad",
        "highest: 3 kN*m/rad",
        "highest: 3 kN",
        ["coupling_types[0].stiffness.highest: found '3 kN*m/rad', allowed lowest"],
    ),
    "gap range exchanged": (
        "minimum_gap: 0.02 mm",
        "minimum_gap: 0.5 mm",
        "maximum_gap: 0.20 mm",
        ["found '0.20 mm', allowed minimum_gap '0.5 mm' or more"],
    ),
    "step longer than the run-down": (
        "time_step: 1e-4 s",
        "time_step: 6 s",
        "time_step",
        ["shutdown.time_step: found '6 s', allowed at most the duration '5 s'"],
    ),
    "far too many steps": (
        "time_step: 1e-4 s",
        "time_step: 0.1 µs",
        "time_step",
        ["found '0.1 µs', which makes 5e+07 steps; allowed 5e-07 s or more"],
    ),
    "step that does not divide": (
        "time_step: 1e-4 s",
        "time_step: 0.03 s",
        "time_step",
        ["found '0.03 s', which does not divide the duration; write 0.0299401198 s"],
    ),
}  # fmt: skip

# Words of our libraries and of our own insides, which tell a user nothing.
LEAKS = re.compile(
    r"Input should|pydantic|\bpint\b|Stated|Section|Error|Traceback|Extra inputs|[<>]"
)


@pytest.mark.parametrize("fault", ONE_FAULT)
def test_one_fault_is_one_sentence_with_its_line(fault, valid, problems):
    before, after, blamed, words = ONE_FAULT[fault]
    assert valid.count(before) == 1
    text = valid.replace(before, after)

    found = problems(text)

    assert len(found) == 1, found
    for part in words:
        assert part in found[0]
    assert found[0].startswith(f"case.yaml:{line_of(blamed, text)}: ")
    assert not LEAKS.search(found[0])


def line_of(blamed, text):
    """Return the line of the one place that matches a text or an expression."""
    start = text.find(blamed)
    if start < 0:
        start = re.search(blamed, text).start()
    return text.count("\n", 0, start) + 1


@pytest.mark.parametrize(
    ("content", "sentence"),
    [
        ("", "case.yaml:1: the file is empty"),
        ("# only a comment\n", "case.yaml:1: the file is empty"),
        ("- a\n- b\n", "case.yaml:1: the file holds no mapping; expected the keys"),
        ("\n\njust text\n", "case.yaml:3: the file holds no mapping"),
        ("name: [a\nb: c\n", "case.yaml:2: not YAML at column 2: while parsing"),
        ("name: a\n\tb: c\n", "case.yaml:2: not YAML at column 1"),
        ("a: 1\n---\nb: 2\n", "case.yaml:2: not YAML at column 1"),
        ("? [a]\n: b\n", "case.yaml:1: not YAML at column 3"),
        ("a: &x 1\nb: *x\n", "case.yaml:2: found the alias '*x'; aliases are not used"),
        ("a: b\nc: \x00\n", "case.yaml:2: not YAML: the character #x0000"),
        (
            "[" * 5000 + "]" * 5000,
            "case.yaml:1: lists or mappings are nested too deeply",
        ),
        (b"a: b\nc: \xff\n", "case.yaml:2: not UTF-8: found the byte 0xff"),
    ],
)
def test_what_is_not_a_case_at_all(content, sentence, problems):
    (found,) = problems(content)
    assert found.startswith(sentence)


@pytest.mark.parametrize(
    ("written", "found"),
    [
        ("!!python/name:os.system x", "the tag 'tag:yaml.org,2002:python"),
        ("!!binary '='", "the tag '!!binary'"),
        ("!!int ''", "the tag '!!int'"),
    ],
)
def test_a_tag_is_refused_and_hides_nothing(written, found, problems):
    told = problems(f"name: {written}\nnothing: 1\n")
    assert any("case.yaml:1: name: found the tag" in each for each in told)
    assert any("case.yaml:2: nothing: unknown key" in each for each in told)


def test_a_date_is_a_text_whatever_the_calendar(problems):
    told = problems("description: 2024-02-30\nnothing: 1\n")
    assert not any("description: found" in each for each in told)
    assert any("unknown key 'nothing'" in each for each in told)


@pytest.mark.parametrize(
    ("written", "words"),
    [
        ("1:30", "counts in sixties; write one decimal number"),
        ("1:14", "a ratio of 1:14 is 14"),
        ("010", "counts in eights; write 10"),
        ("0x1F", "no decimal number; write it in tens"),
    ],
)
def test_a_number_that_yaml_counts_otherwise_is_refused(written, words, problems):
    found = problems(f"reliability: {written}\n")
    (told,) = [each for each in found if "reliability: found" in each]
    assert told.startswith(f"case.yaml:1: reliability: found '{written}'")
    assert words in told


def test_a_merge_key_is_refused(problems):
    told = problems("name: a\nshaft: {<<: {x: 1}, y: 2}\n")
    assert any("case.yaml:2: shaft: found the merge key '<<'" in each for each in told)
    assert any("unknown key 'y'" in each for each in told)


def test_missing_file():
    with pytest.raises(CaseError, match=r"cases/none\.yaml: there is no such file"):
        load_case("cases/none.yaml")


def test_directory(tmp_path):
    with pytest.raises(CaseError, match="is a directory"):
        load_case(tmp_path)


def test_name_that_no_file_can_have():
    with pytest.raises(CaseError, match="cannot be read"):
        load_case("a\0b")


def test_all_problems_at_once_in_the_order_of_the_file(valid, problems):
    text = (
        valid.replace("type: rubber", "type: ruber")  # relation
        .replace("gap: 0.10 mm", "gap: -0.10 mm")  # range
        .replace("order: 6", "order: 3")  # twice
        .replace("  duration: 5 s\n", "  duration: 5 s\n  duration: 5 s\n")  # YAML
        .replace("rotor_weight: 2200 N", "rotor_weight: 2200 kg")  # dimension
        .replace("  cleanliness: normal\n", "")  # missing
        .replace("service_factor: 1.2", "service_facto: 1.2")  # unknown
    )

    found = problems(text)

    lines = [int(sentence.split(":")[1]) for sentence in found]
    assert len(found) == 7
    assert lines == sorted(lines)
    assert [sentence.split(": ")[1] for sentence in found] == [
        "driveline.coupling.type",
        "driveline.connection.gap",
        "driveline.excitation[1].order",
        "shutdown.duration",
        "shaft.rotor_weight",
        "lubrication",
        "duty.service_facto",
    ]


def test_relations_speak_although_their_section_is_faulty(valid, problems):
    text = valid.replace("time_step: 1e-4 s", "time_step: 6 s").replace(
        "initial_speed: 750 rpm", "initial_speed: fast"
    )
    assert len(problems(text)) == 2


def test_the_message_is_all_sentences(valid, write):
    text = valid.replace("radius: 50", "radius: -50").replace("order: 6", "order: 0")
    with pytest.raises(CaseError) as error:
        load_case(write(text))
    assert str(error.value).splitlines() == list(error.value.problems)
    assert error.value.exit_code == 2


def test_a_tight_fit_with_a_gap(valid, problems):
    found = problems(valid.replace("kind: key", "kind: tight_fit"))
    assert found[1].startswith(
        "case.yaml:14: driveline.connection.gap: found '0.10 mm', "
        "but a tight_fit has no gap"
    )


def test_a_third_bearing(valid, problems):
    found = problems(valid.replace("lubrication:", "  - {name: third}\nlubrication:"))
    assert found[0].startswith("case.yaml:42: bearings: found a list of 3, allowed")


def test_one_bearing(valid, problems):
    other_end = valid[valid.index("  - name: other end") : valid.index("lubrication:")]
    (found,) = problems(valid.replace(other_end, ""))
    assert found.startswith("case.yaml:42: bearings: found a list of 1, allowed are")

"""An engine's data in place of its orders."""

import math
import re
from copy import deepcopy
from pathlib import Path

import numpy as np
import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st

from coupling_design.case import load_case
from coupling_design.case.load import validate
from coupling_design.case.text.document import parse_text
from coupling_design.engine import Cycle
from coupling_design.errors import CaseError
from coupling_design.machine.words import Source

VALID = Path(__file__).with_name("valid.yaml")
ENGINE = """\
    engine:
      cycle: four_stroke
      mode: motored
      bore: 280 mm
      stroke: 285 mm
      rod_length: 581.63 mm
      reciprocating_mass: 0 kg
      compression_ratio: 12.5
      polytropic_exponent: 1.32
      intake_pressure: {value: 1 bar, source: assumed}
      cylinders: 16
      bank_angle: 50 deg
      firing_order: {value: [1, 5, 7, 3, 8, 4, 2, 6], source: invented}
      reference_speed: 120 rpm
      highest_order: 8
"""
FIRED = "fired\n      indicated_mean_pressure: 18 bar"
TRACED = "fired\n      pressure_trace: trace.csv"


def with_engine(valid, *changes):
    start, end = valid.index("    - order: 3"), valid.index("  engine_resistance")
    text = valid[:start] + ENGINE + valid[end:]
    for before, after in changes:
        assert text.count(before) == 1
        text = text.replace(before, after)
    return text


def amplitudes(case):
    return {o.order: o.amplitude for o in case.driveline.excitation}


def test_orders_are_worked_out(load, valid):
    four, eight = load(with_engine(valid)).driveline.excitation
    assert (four.order, eight.order) == (4.0, 8.0)
    # The project's reconstruction: about 1.6 and 1.4 kN m.
    assert (four.amplitude, eight.amplitude) == pytest.approx(
        (1.58e3, 1.37e3), rel=2e-3
    )
    assert math.degrees(four.phase) == pytest.approx(80.0)


def test_45_degrees_leave_order_8_alone(load, valid):
    case = load(with_engine(valid, ("50 deg", "45 deg")))
    assert list(amplitudes(case)) == [8.0]


def test_provenance_lists_the_engine_and_what_was_derived(load, valid):
    listed = load(with_engine(valid)).provenance
    by_path = {
        value.path.removeprefix("driveline.excitation"): value for value in listed
    }
    assert by_path[".engine.bore"].value == pytest.approx(0.28)
    order = by_path[".engine.firing_order"]
    assert (order.text, order.source) == ("1, 5, 7, 3, 8, 4, 2, 6", Source.INVENTED)
    amplitude = by_path["[0].amplitude"]
    assert (amplitude.unit, amplitude.source) == ("N*m", Source.DERIVED)
    assert amplitude.text == f"{amplitude.value:.6g} N*m"
    assert by_path["[0].phase"].text == "80 deg"
    assert by_path[".engine.peak_pressure"].text == "28.0492 bar"
    assert by_path[".engine.mean_torque"].text == "0 N*m"
    assert len(by_path) == len(listed)


def test_fired_with_one_cylinder_missing(load, valid):
    boosted = ("value: 1 bar", "value: 3.5 bar")
    whole = load(with_engine(valid, boosted, ("motored", FIRED)))
    assert min(amplitudes(whole)) == 4.0
    missing = ("motored", f"{FIRED}\n      misfiring_cylinders: [B3]")
    lame = load(with_engine(valid, boosted, missing))
    assert min(amplitudes(lame)) == 0.5
    # Torque per cylinder: 18 bar x 17.549 l / (4 pi) = 2.514 kN m.
    by_path = {value.path: value.value for value in whole.provenance}
    mean = by_path["driveline.excitation.engine.mean_torque"]
    assert mean == pytest.approx(16 * 2513.7, rel=1e-4)


def test_the_fuel_is_turned_off_by_mode_alone(load, valid):
    off = with_engine(valid, ("motored", FIRED.replace("fired", "motored")))
    assert amplitudes(load(off)) == amplitudes(load(with_engine(valid)))


def test_combustion_and_other_optional_values(load, valid):
    more = (
        "highest_order: 8",
        "highest_order: 8\n      threshold: 90 %\n      expansion_exponent: 1.3\n"
        "      crankcase_pressure: 1.1 bar\n"
        "      combustion: {start: -8 deg, duration: 60 deg, shape: 0.8}",
    )
    case = load(with_engine(valid, ("motored", FIRED), more))
    assert list(amplitudes(case)) == [8.0]


def trace(path, step=1.0, header="crank angle [deg], pressure [bar]\n"):
    """Write a motored trace from -360 to 360 degrees."""
    angles = np.arange(-360.0, 360.0 + step, step)
    travel = 1 - np.cos(np.radians(angles))
    closed = np.abs(angles) < 180
    pressures = np.where(closed, (12.5 / (1 + 11.5 * travel / 2)) ** 1.32, 1.0)
    rows = (f"{a:g}, {p:.6g}" for a, p in zip(angles, pressures, strict=True))
    path.write_text(header + "\n".join(rows), encoding="utf-8")


def test_a_measured_pressure(load, valid, tmp_path):
    trace(tmp_path / "trace.csv", header="# motored\ncrank [deg],pressure [bar]\n")
    case = load(with_engine(valid, ("motored", TRACED)))
    found = amplitudes(case)
    assert found[8.0] == pytest.approx(1.4e3, rel=0.4)
    by_path = {value.path: value.text for value in case.provenance}
    reached = by_path["driveline.excitation.engine.indicated_mean_pressure"]
    assert abs(float(reached.removesuffix("bar"))) < 1e-3


def test_a_trace_in_other_units_is_the_same(load, valid, tmp_path):
    trace(tmp_path / "trace.csv")
    text = with_engine(valid, ("motored", TRACED))
    expected = amplitudes(load(text))
    rows = (tmp_path / "trace.csv").read_text().splitlines()[1:]
    values = [[float(cell) for cell in row.split(",")] for row in rows]
    lines = [f"{math.radians(a)!r},{p * 1e5!r}" for a, p in values]
    (tmp_path / "trace.csv").write_text("angle [rad],p [Pa]\n" + "\n".join(lines))
    assert amplitudes(load(text)) == pytest.approx(expected)


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (None, "trace.csv: there is no such file"),
        (
            "a [deg],p [bar]\n-360,1" + 140_000 * "0",
            "trace.csv:2: found a field of up to 140006 characters, allowed are 131072",
        ),
        ("", "trace.csv:1: the file is empty; begin it with 'crank angle [deg]"),
        ("-360, 1.0\n", "trace.csv:1: found '-360, 1.0', expected two headings"),
        ("a [deg], p [mm]\n", "found '[mm]', that is a length, expected a pressure"),
        ("a [deg], p [bar]\n0, one\n", "trace.csv:2: found '0, one', expected a crank"),
        ("a [deg], p [bar]\n0, -1\n", "trace.csv:2: found '0, -1', expected a crank"),
        ("a [deg], p [bar]\n0;1\n", "trace.csv:2: found '0;1', expected a crank angle"),
        ("a [deg], p [bar]\n0, 1\n20, 1\n", "trace.csv:3: the crank angle is 20 deg"),
        ("a [deg], p [bar]\n0, 1\n-1, 1\n", "trace.csv:3: the crank angle is -1 deg"),
        ("a [deg], p [bar]\n0, 1\n1, 1\n", "span 1 deg; allowed is the whole cycle"),
    ],
)  # fmt: skip
def test_faults_of_a_trace(content, words, problems, valid, tmp_path):
    if content is not None:
        (tmp_path / "trace.csv").write_text(content)
    text = with_engine(valid, ("motored", TRACED))
    [found] = problems(text)
    line = text[: text.index("trace.csv")].count("\n") + 1
    assert found.startswith(
        f"case.yaml:{line}: driveline.excitation.engine.pressure_trace: trace.csv:"
    )
    assert words in found


FAULTS = {
    "engine misspelt": (
        "    engine:\n", "    motor:\n", "driveline.excitation",
        ["missing key 'engine'; write a mapping with the keys cycle, mode, bore"],
    ),
    "missing": (
        "      bore: 280 mm\n", "", "driveline.excitation.engine",
        ["missing key 'bore'; write a length, such as 0.28 mm"],
    ),
    "misspelt": (
        "bore:", "boer:", "driveline.excitation.engine.boer",
        ["unknown key 'boer'; did you mean 'bore'?"],
    ),
    "unit": (
        "280 mm", "280 kg", "driveline.excitation.engine.bore",
        ["found '280 kg', that is a mass, expected a length"],
    ),
    "pressure": (
        "value: 1 bar", "value: -1 bar", "driveline.excitation.engine.intake_pressure",
        ["found '-1 bar', allowed 1e-05 bar to 10000 bar. Pressures are absolute"],
    ),
    "ratio": (
        "12.5", "1", "driveline.excitation.engine.compression_ratio",
        ["found '1', allowed 1.1 to 100"],
    ),
    "word": (
        "motored", "fierd", "driveline.excitation.engine.mode",
        ["found 'fierd'; did you mean 'fired'? allowed: motored, fired"],
    ),
    "short rod": (
        "581.63", "81.63", "driveline.excitation.engine.rod_length",
        ["found '81.63 mm', allowed 0.51 of the stroke '285 mm' or more"],
    ),
    "fired without pressure": (
        "motored", "fired", "driveline.excitation.engine.mode",
        ["found 'fired' with neither of indicated_mean_pressure and pressure_trace"],
    ),
    "fired with two": (
        "motored", FIRED + "\n      pressure_trace: t.csv",
        "driveline.excitation.engine.mode", ["found 'fired' with both of"],
    ),
    "part of a cylinder": (
        "cylinders: 16", "cylinders: 7.5", "driveline.excitation.engine.cylinders",
        ["found '7.5', allowed are whole numbers"],
    ),
    "cylinder twice": (
        "[1, 5, 7", "[5, 5, 7", "driveline.excitation.engine.firing_order",
        ["names each of A1 to B8, or 1 to 8 once"],
    ),
    "order as text": (
        "[1, 5, 7, 3, 8, 4, 2, 6]", "1-5-7",
        "driveline.excitation.engine.firing_order", ["expected a list"],
    ),
    "intervals": (
        "120 rpm", "120 rpm\n      firing_intervals: [90 deg]",
        "driveline.excitation.engine.firing_intervals",
        ["found 1 firing intervals", "one for each of the 8"],
    ),
    "throws": (
        "120 rpm", "120 rpm\n      crank_angles: [0 deg, 90 deg]",
        "driveline.excitation.engine.crank_angles", ["found 2 crank angles"],
    ),
    "throws and intervals": (
        "120 rpm",
        "120 rpm\n      crank_angles: [0 deg]\n      firing_intervals: [0 deg]",
        "driveline.excitation.engine.crank_angles", ["delete one of them"],
    ),
    "angle in a list": (
        "120 rpm", "120 rpm\n      crank_angles: [0 deg, 9 mm]",
        "driveline.excitation.engine.crank_angles[1]",
        ["found '9 mm', that is a length"],
    ),
    "unknown cylinder": (
        "120 rpm", "120 rpm\n      misfiring_cylinders: [A9]",
        "driveline.excitation.engine.misfiring_cylinders",
        ["found 'A9'; allowed: A1, A2"],
    ),
    "no order left": (
        "highest_order: 8", "highest_order: 3",
        "driveline.excitation.engine.highest_order",
        ["found '3', but no order survives up to there; the first that does is 4"],
    ),
    "everything below the threshold": (
        "highest_order: 8", "highest_order: 8\n      threshold: 100 %",
        "driveline.excitation.engine.highest_order", ["lower the threshold"],
    ),
    "less than motored": (
        "motored", FIRED.replace("18 bar", "1 bar") + "\n      expansion_exponent: 1.1",
        "driveline.excitation.engine.indicated_mean_pressure",
        ["found '1 bar', which this combustion cannot reach"],
    ),
}  # fmt: skip


@pytest.mark.parametrize("fault", FAULTS)
def test_one_fault_is_told_in_its_line(fault, problems, valid):
    before, after, path, words = FAULTS[fault]
    found = problems(with_engine(valid, (before, after)))
    assert re.match(rf"case\.yaml:\d+: {re.escape(path)}: ", found[0])
    assert all(word in found[0] for word in words)
    # A misspelt `engine` is a missing and an unknown key.
    assert len(found) == (2 if fault == "engine misspelt" else 1)


def test_neither_list_nor_engine(problems, valid):
    start, end = valid.index("    - order: 3"), valid.index("  engine_resistance")
    [found] = problems(valid[: start - 1] + " loud\n" + valid[end:])
    assert "driveline.excitation: found 'loud', expected a list" in found
    [found] = problems(valid[: valid.index("  excitation")] + valid[end:])
    assert "missing key 'excitation'; write a list" in found
    assert "or a mapping with the keys engine" in found


KEYS = [
    "stroke", "rod_length", "compression_ratio", "intake_pressure", "cylinders",
    "bank_angle", "firing_order", "firing_intervals", "crank_angles", "combustion",
    "indicated_mean_pressure", "pressure_trace", "misfiring_cylinders", "threshold",
    "cycle", "mode", "reciprocating_mass", "reference_speed", "highest_order", "bore",
]  # fmt: skip
JUNK = st.one_of(
    st.none(), st.floats(), st.integers(), st.text(max_size=4), st.lists(st.integers()),
    st.sampled_from([
        "1 m", "1e300 m", "1e-3 m", "10 m", "1e9 Pa", "1 Pa", "5e3 rad/s", "0 kg",
        "1e5 kg", "720 deg", "0 deg", "two_stroke", "fired", "100", "1.1", 0.5, 1, 2,
        ["A1"], ["1", "2"], ["2", "1"], ["720 deg"], ["0 deg", "180 deg"], {"value": 3},
        {"start": "90 deg", "duration": "180 deg", "shape": 10},
        {"start": "-90 deg", "duration": "1 deg", "shape": 0.1},
    ]),
)  # fmt: skip


@settings(max_examples=80, deadline=None)
@given(
    fired=st.booleans(),
    changes=st.dictionaries(st.sampled_from(KEYS), JUNK, max_size=4),
)
def test_junk_never_makes_a_traceback(fired, changes, valid_data):
    data = deepcopy(valid_data)
    engine = data["driveline"]["excitation"]["engine"]
    if fired:
        engine |= {"mode": "fired", "indicated_mean_pressure": "18 bar"}
    engine |= changes
    told = problems_of(yaml.safe_dump(data, sort_keys=False))
    assert all(re.match(r"case\.yaml:\d+: .", problem) for problem in told)


def problems_of(text):
    try:
        validate(parse_text(text, "case.yaml"))
    except CaseError as error:
        return error.problems or ["no problem is told"]
    return []


@pytest.fixture(scope="module")
def valid_data():
    """Return the data of the valid case with an engine."""
    return yaml.safe_load(with_engine(VALID.read_text(encoding="utf-8")))


def test_a_two_stroke_engine_in_line(load, valid):
    changes = [
        ("four_stroke", "two_stroke"), ("cylinders: 16", "cylinders: 3"),
        ("      bank_angle: 50 deg\n", ""), ("[1, 5, 7, 3, 8, 4, 2, 6]", "[1, 3, 2]"),
    ]  # fmt: skip
    case = load(with_engine(valid, *changes))
    assert list(amplitudes(case)) == [3.0, 6.0]
    assert Cycle.TWO_STROKE.turns == 1


def test_a_case_file_may_stand_elsewhere_than_its_trace(valid, tmp_path):
    (tmp_path / "measured").mkdir()
    trace(tmp_path / "measured" / "trace.csv")
    text = with_engine(
        valid, ("motored", TRACED.replace("trace.csv", "measured/trace.csv"))
    )
    (tmp_path / "case.yaml").write_text(text)
    assert 8.0 in amplitudes(load_case(tmp_path / "case.yaml"))

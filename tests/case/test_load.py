"""What a sound case file becomes."""

import dataclasses
import hashlib
import math
from pathlib import Path

import pytest

from coupling_design.case import load_case
from coupling_design.errors import CaseError
from coupling_design.line.parameters import (
    ExcitationOrder,
    KeyedConnection,
    LossFactorDamping,
    ProportionalDamping,
    RelativeDamping,
    Shutdown,
    TightFit,
)
from coupling_design.machine.hub_seat import ConnectionOption
from coupling_design.machine.words import ConnectionKind, LoadLimitReading, Plan, Source
from coupling_design.parts.bearing.parameters import BearingType, Cleanliness

CASES = Path(__file__).parents[2] / "cases"
RPM = 2 * math.pi / 60


@pytest.fixture(scope="module")
def paper():
    return load_case(CASES / "16v280.yaml")


@pytest.mark.parametrize(
    "file", sorted(CASES.glob("*.yaml")), ids=lambda file: file.stem
)
def test_shipped_case_loads_and_every_value_names_its_source(file):
    case = load_case(file)
    assert case.sha256 == hashlib.sha256(file.read_bytes()).hexdigest()
    assert [value.path for value in case.provenance if value.source is None] == []


def test_values_of_the_paper_in_si(paper):
    driveline = paper.driveline
    assert driveline.engine_inertia == 177.65
    assert driveline.coupling_inertia == 2.26
    assert driveline.generator_inertia == 602.60
    assert driveline.connection.radius == pytest.approx(0.100)
    assert driveline.connection.gap == pytest.approx(0.28e-3)
    assert driveline.connection.oil_damping == 100.0
    assert [harmonic.order for harmonic in driveline.excitation] == [4.0, 8.0]
    assert driveline.coupling.damping_law.characteristic_frequency == 290.0
    assert paper.shutdown.n_steps == 120_000
    assert paper.shaft.hub_to_bearing_1 == pytest.approx(0.230)
    assert paper.shaft.rotor_weight == 25436.76
    assert paper.lubrication.viscosity == pytest.approx(39.6e-6)
    assert paper.reliability == pytest.approx(0.99)
    assert paper.duty.working_speed[1] == pytest.approx(1000 * RPM)
    assert paper.reading is LoadLimitReading.TRANSMISSION_FORCE
    for bearing in paper.bearings:
        assert bearing.designation == "NU2326"
        assert bearing.dynamic_load_rating == 920e3
        assert bearing.static_load_rating == 1230e3
        assert bearing.pitch_diameter == pytest.approx(0.205)
        # The paper's smallest load, from its own K1 and S_min.
        smallest = (bearing.minimum_stress / bearing.stress_coefficient) ** 2
        assert smallest == pytest.approx(48838.56, abs=0.005)


def test_every_field(load, valid):
    case = load(valid)
    assert case.name == "Example"
    assert case.description == "a small set"
    assert case.file == "case.yaml"
    assert case.driveline.excitation[1] == ExcitationOrder(6.0, 10.0, 0.0)
    assert case.driveline.coupling.torsional_stiffness == 12e3
    assert case.driveline.coupling.damping_law == RelativeDamping(1.1)
    assert case.driveline.connection == KeyedConnection(
        radius=pytest.approx(0.050),
        gap=pytest.approx(0.1e-3),
        contact_stiffness=1e7,
        oil_damping=10.0,
        smoothing=pytest.approx(1e6),
    )
    assert case.present_coupling_type == "rubber"
    assert case.present_connection is ConnectionKind.KEY
    assert case.shutdown == Shutdown(pytest.approx(750 * RPM), 5.0, 1e-4)
    assert case.bearings[0].name == "drive end"
    assert case.bearings[0].designation == "6318"
    assert case.bearings[0].type is BearingType.RADIAL_BALL
    assert case.lubrication.cleanliness is Cleanliness.NORMAL
    assert case.duty.rated_torque == 1.3e3
    assert case.duty.service_factor == 1.2
    (rubber,) = case.coupling_types
    assert rubber.plan is Plan.ELASTIC
    assert rubber.stiffness_range == (8e3, 30e3)
    assert rubber.maximum_speed == pytest.approx(2500 * RPM)
    assert rubber.connections == (ConnectionKind.KEY, ConnectionKind.SPLINE)
    assert case.connections == (
        ConnectionOption(ConnectionKind.KEY, pytest.approx(2e-5), pytest.approx(2e-4)),
        ConnectionOption(
            ConnectionKind.SPLINE, pytest.approx(1e-5), pytest.approx(5e-5)
        ),
    )


def test_damping_laws(paper):
    laws = [coupling_type.damping_law for coupling_type in paper.coupling_types]
    assert laws == [
        ProportionalDamping(0.821, 290.0),
        ProportionalDamping(0.821, 290.0),
        LossFactorDamping(0.02),
    ]
    assert paper.driveline.coupling.damping_law == laws[0]


def test_a_case_cannot_be_changed(paper):
    with pytest.raises(dataclasses.FrozenInstanceError):
        paper.name = "other"


def tight(text):
    """Return the valid case with a tight fit throughout."""
    start = text.index("    gap: 0.10 mm")
    text = text[:start] + text[text.index("  excitation:") :]
    text = text[: text.index("    key:\n")] + "    tight_fit: {}\n"
    return text.replace("kind: key", "kind: tight_fit").replace(
        "[key, spline]", "[tight_fit]"
    )


def test_a_tight_fit_alone_needs_no_key(load, valid):
    case = load(tight(valid))
    assert case.driveline.connection == TightFit(radius=pytest.approx(0.050))
    assert case.connections == (ConnectionOption(ConnectionKind.TIGHT_FIT, 0.0, 0.0),)
    with pytest.raises(CaseError, match="a key needs contact_stiffness"):
        case.hub_seat.connect(ConnectionKind.KEY, 1e-4)


def test_a_tight_fit_beside_an_offered_key_needs_its_parameters(problems, valid):
    text = tight(valid) + "    key: {minimum_gap: 0.1 mm, maximum_gap: 0.2 mm}\n"
    found = problems(text)
    assert len(found) == 3
    assert "missing key 'oil_damping'; the key in design_space needs it" in found[1]


def test_joint_connects_every_kind(load, valid):
    joint = load(valid).hub_seat
    assert joint.connect(ConnectionKind.SPLINE, 3e-5).gap == 3e-5
    assert joint.connect(ConnectionKind.TIGHT_FIT, 0.0) == TightFit(joint.radius)


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("duration: 5 s", "duration: {value: 5 s, source: measured, note: twice}"),
        ("order: 3\n", "order: {value: 3, source: derived}\n"),
        ("normal", "{value: normal, source: assumed}"),
        ("duration: 5 s", "duration: 5000 ms"),
        ("1e7 N*m/rad", "1.0e+7 N*m/rad"),
        ("service_factor: 1.2", "service_factor: 12e-1"),
        ("reliability: 95 %", "reliability: 0.95"),
        ("maximum_gap: 0.20 mm", "maximum_gap: 200 µm"),
    ],
)
def test_other_ways_to_write_the_same(before, after, load, valid):
    same = {"sha256": "", "provenance": ()}
    expected = dataclasses.replace(load(valid), **same)
    assert dataclasses.replace(load(valid.replace(before, after)), **same) == expected


def test_a_value_on_its_limit_in_another_unit_is_allowed(load, valid):
    text = valid.replace("gap: 0.10 mm", "gap: 0.3 mm")
    case = load(text.replace("maximum_gap: 0.20 mm", "maximum_gap: 300 µm"))
    assert case.driveline.connection.gap == pytest.approx(3e-4)


def test_byte_order_mark_and_windows_line_ends(load, valid):
    case = load(b"\xef\xbb\xbf" + valid.replace("\n", "\r\n").encode())
    assert case.name == "Example"


def test_provenance_of_a_value(paper):
    by_path = {value.path: value for value in paper.provenance}
    gap = by_path["driveline.connection.gap"]
    assert (gap.text, gap.unit, gap.source) == ("0.28 mm", "m", Source.PAPER)
    assert gap.value == pytest.approx(0.28e-3)
    cleanliness = by_path["lubrication.cleanliness"]
    assert (cleanliness.value, cleanliness.unit) == ("slight_typical", "")
    assert by_path["driveline.excitation[1].order"].text == "8.0"


def test_provenance_lists_bare_values_without_a_source(load, valid):
    text = valid.replace("radius: 50 mm", "radius: {value: 50 mm, note: by eye}")
    by_path = {value.path: value for value in load(text).provenance}
    assert by_path["driveline.connection.radius"].note == "by eye"
    assert by_path["driveline.connection.radius"].source is None
    assert by_path["shutdown.duration"].text == "5 s"


def test_assumptions_are_what_rests_on_judgement(paper):
    judged = {Source.ASSUMED, Source.FITTED, Source.INVENTED}
    assert {value.source for value in paper.assumptions} == judged
    paths = [value.path for value in paper.assumptions]
    assert "driveline.coupling.torsional_stiffness" in paths
    assert "driveline.connection.gap" not in paths

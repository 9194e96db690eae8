"""What is to be read first: of a case, and of what a run-down shows."""

import math
from dataclasses import replace
from pathlib import Path

import pytest

from coupling_design.checks.warnings import (
    case_warnings,
    ends_above_resonance,
    run_down_warnings,
    stop_remark,
    weight_above_limit,
)
from coupling_design.line.parameters import ExcitationOrder
from coupling_design.wear.chance import Spread
from coupling_design.wear.performance import Performance

RPM = math.pi / 30
SHIPPED = sorted((Path(__file__).parents[2] / "cases").glob("*.yaml"))


@pytest.fixture
def base(tiny):
    return tiny()


@pytest.fixture
def quiet():
    """A run-down of base.yaml that does nothing worth a word, at rest at its end."""
    return Performance(
        torsional_stiffness=12e3,
        key_gap=1e-4,
        natural_frequency=14.8,
        damages=(1e-9, 1e-10),
        peak_transmission_force=1e3,
        peak_combined_load=(2e3, 1.5e3),
        spread=Spread(8, ((0, 1), (0, 1)), (0, 1), 0.5, 0, final_speed=0.1),
    )


def ending(performance, rpm):
    return replace(
        performance, spread=replace(performance.spread, final_speed=rpm * RPM)
    )


@pytest.mark.parametrize("file", SHIPPED, ids=lambda file: file.stem)
def test_shipped_cases_have_no_warning(file, shipped):
    assert case_warnings(shipped(file.name)) == ()


def test_shipped_cases_are_five():
    assert len(SHIPPED) == 5


@pytest.mark.parametrize("name", ["base", "engine_motored", "engine_fired_with_trace"])
def test_cases_with_nothing_wrong(name, tiny):
    assert case_warnings(tiny(name)) == ()


def test_a_quiet_run_down(base, quiet):
    assert run_down_warnings(base, quiet, "Chosen coupling") == ()
    assert stop_remark(base, quiet) is None


def test_a_life_in_one_stop(base, quiet):
    told = run_down_warnings(base, replace(quiet, damages=(1.0, 0.999)), "It")
    assert told == (
        "It: Drive end does not survive one stop: its damage is 1, 1 is its whole "
        "life.",
    )


def test_above_half_of_c_and_above_c_0(base, quiet):
    """C is 151 kN and C_0 108 kN: half of C is 75.5 kN."""
    loads = {75.4e3: 0, 75.6e3: 1, 107.9e3: 1, 108.1e3: 1}
    for load, said in loads.items():
        loud = replace(quiet, peak_combined_load=(2e3, load))
        told = run_down_warnings(base, loud, "It")
        assert len(told) == said
    assert "Other end, 108.1 kN, is above its static rating C_0 = 108 kN" in told[0]
    loud = replace(quiet, peak_combined_load=(75.6e3, 1e3))
    (half,) = run_down_warnings(base, loud, "It")
    assert "Drive end, 75.6 kN, is above half of C = 151 kN, where ISO 281" in half


def test_cut_off_above_the_resonance(base, quiet):
    """Order 3 is the largest: 60 x 14.8 / 3 = 296 rpm; the run-down begins at 750."""
    assert not ends_above_resonance(base, ending(quiet, 295.0))
    (told,) = run_down_warnings(base, ending(quiet, 297.0), "Present coupling")
    assert told.startswith(
        "Present coupling: the run-down ends at 297 rpm, above the resonance with "
        "order 3 at 296 rpm"
    )


def test_cut_off_before_rest(base, quiet):
    """Rest is below the 0.2 rad/s at which friction turns over, 1.91 rpm."""
    assert stop_remark(base, ending(quiet, 1.9)) is None
    assert "ends at 1.92 rpm, before rest" in stop_remark(base, ending(quiet, 1.92))
    assert stop_remark(base, replace(quiet, spread=None)) is None


def test_the_run_down_begins_below_the_resonance(base):
    def begins(rpm):
        shutdown = replace(base.shutdown, initial_speed=rpm * RPM)
        return case_warnings(replace(base, shutdown=shutdown))

    assert begins(297.0) == ()
    (told,) = begins(295.0)
    assert "base.yaml:16: shutdown.initial_speed: the run-down does not pass" in told
    assert "begins at 295 rpm" in told


def test_the_weight_alone(base):
    """F_min is (1500/23.29)^2 = 4148 N; half of the weight is each bearing's."""

    def with_weight(newtons):
        shaft = replace(base.shaft, rotor_weight=newtons)
        return list(weight_above_limit(replace(base, shaft=shaft)))

    assert with_weight(8290.0) == []
    first, second = with_weight(8300.0)
    assert first == (
        "The rotor's weight on Drive end exceeds F_min: 4.15 kN against 4.148 kN. No "
        "coupling can keep that load limit."
    )
    assert "on Other end" in second


def test_a_contact_softer_than_ten_times_the_coupling(base):
    def contact(ratio):
        line = base.driveline
        connection = replace(line.connection, contact_stiffness=ratio * 12e3)
        return case_warnings(
            replace(base, driveline=replace(line, connection=connection))
        )

    assert contact(10.1) == ()
    (told,) = contact(9.9)
    assert "driveline.connection.contact_stiffness: the contact is 9.9 times" in told


@pytest.mark.parametrize(
    ("order", "said"), [(0.5, 0), (7.5, 0), (24.0, 0), (24.5, 1), (2.4, 1)]
)
def test_orders_that_no_engine_has(base, order, said):
    excitation = (
        base.driveline.excitation[0],
        ExcitationOrder(order=order, amplitude=1.0, phase=0.0),
    )
    line = replace(base.driveline, excitation=excitation)
    told = case_warnings(replace(base, driveline=line))
    assert len(told) == said
    for each in told:
        assert f"driveline.excitation[1].order: order {order:g} is none of an" in each


@pytest.mark.parametrize(
    ("path", "value", "words"),
    [
        ("engine.compression_ratio", "7.9", "7.9 is outside 8 to 24, what engines"),
        ("engine.compression_ratio", "24.1", "24.1 is outside 8 to 24, what engines"),
        ("engine.compression_ratio", "8", ""),
    ],
)
def test_compression_ratio(path, value, words, load_with):
    told = case_warnings(load_with("engine_motored", f"{path}={value}"))
    assert len(told) == bool(words)
    assert all(words in each for each in told)


@pytest.mark.parametrize(("short", "said"), [(14, 1), (16, 0)])
def test_firing_intervals(short, said, load_with):
    """Two of six cylinders a few degrees apart, the others evenly."""
    intervals = f"[{short} deg, {240 - short} deg, 120 deg, 120 deg, 120 deg, 120 deg]"
    told = case_warnings(
        load_with("engine_motored", f"engine.firing_intervals={intervals}")
    )
    words = "firing_intervals: 14 deg is outside 15 to 360 deg, what engines have"
    assert sum(words in each for each in told) == said
    # A first order has come, whose resonance lies above where the run-down begins.
    assert len(told) == said + 1
    assert "Its largest order, 1, meets the present" in told[-1]


def test_what_nothing_uses_is_told_last(load_with):
    told = case_warnings(
        load_with("base", "duty.start_factor=1.2", "working_speed.highest=6000 rpm")
    )
    assert len(told) == 2
    assert told[-1].endswith(
        "duty.start_factor is not used: it weighs the peak torque of catalogue sizes "
        "alone."
    )

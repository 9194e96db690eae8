"""Sizes against their sheets, worked by hand after DIN 740-2."""

import math
from dataclasses import replace

import pytest

from coupling_design.checks.coupling import size_criteria
from coupling_design.line.parameters import ExcitationOrder, Resistance
from coupling_design.machine.candidate import Candidate
from coupling_design.machine.coupling_size import CouplingKind
from coupling_design.machine.duty import ShortCircuit
from coupling_design.machine.words import ConnectionKind
from coupling_design.parts.criterion import Verdict, none_fails
from coupling_design.steps.so_far import connection_option

MOTORED = "; motored orders, the fired are larger"
FREE = Resistance(viscous=0.0, friction=0.0, transition_speed=1.0)


@pytest.fixture
def criteria_of(size_of):
    """Return the criteria of D 3 in a tight fit by name; size and duty changed."""

    def checked(case, size_changes=None, **duty_changes):
        case = replace(case, duty=replace(case.duty, **duty_changes))
        series, size = size_of(case, "D 3")
        size = replace(size, **(size_changes or {}))
        tight = connection_option(case, ConnectionKind.TIGHT_FIT)
        criteria = size_criteria(case, Candidate(series, tight), size)
        return {c.name.removeprefix("D 3: "): c for c in criteria}

    return checked


def test_torques_of_a_steel_size(with_sizes, criteria_of):
    """1.2 x 1.2 = 1.44; 3 x 1.3 = 3.9; 7 kN*m; no S_t for steel."""
    found = criteria_of(
        with_sizes(), start_factor=1.3, temperature_factor=1.4, rare_torque=7e3
    )
    rated = found["rated torque x service factor x S_t"]
    peak = found["peak torque x S_z x S_t"]
    rare = found["rare torque x S_t"]
    assert (rated.value, rated.limit) == (pytest.approx(1440.0), 2500.0)
    assert (peak.value, peak.limit) == (pytest.approx(3900.0), 5000.0)
    assert (rare.value, rare.limit, rare.passes) == (7e3, 6e3, False)
    assert rated.margin == pytest.approx(1 - 1.44 / 2.5)


def test_warmth_weakens_rubber(with_sizes, criteria_of):
    """1.44 x 1.4 = 2.016; 3 x 1.3 x 1.4 = 5.46 kN*m against 5."""
    rubber = {"kind": CouplingKind.RUBBER}
    found = criteria_of(with_sizes(), rubber, start_factor=1.3, temperature_factor=1.4)
    assert found["rated torque x service factor x S_t"].value == pytest.approx(2016.0)
    peak = found["peak torque x S_z x S_t"]
    assert (peak.value, peak.passes) == (pytest.approx(5460.0), False)


def test_speed(with_sizes, criteria_of):
    """900 against 3000 rpm."""
    speed = criteria_of(with_sizes())["highest working speed"]
    assert speed.value == pytest.approx(30 * math.pi)
    assert speed.limit == pytest.approx(100 * math.pi)


@pytest.fixture
def bare(with_sizes):
    """One order, no resistance: J1 = 2.5, J2 + J3 = 0.25 + 3 = 3.25, 600 to 900 rpm."""
    case = with_sizes()
    driveline = replace(
        case.driveline,
        excitation=(ExcitationOrder(2.0, 60.0, 0.0),),
        engine_resistance=FREE,
        generator_resistance=FREE,
    )
    return replace(case, driveline=driveline)


def test_vibratory_torque_and_heat_of_a_soft_size(bare, criteria_of):
    """C_Tdyn = 2000 N m/rad; J_red = 2.5 x 3.25 / 5.75 = 1.41304 kg m^2.

    omega_n = sqrt(2000/1.41304) = 37.622 rad/s, passed at 37.622/2 = 18.811 rad/s =
    179.6 rpm: V_R = sqrt(1 + 1/0.05^2) = 20.025, 60 x 3.25/5.75 = 33.913 N m, in all
    679.1 N m. At 600 rpm (f = 20 Hz, S_f = sqrt 2) omega = 125.664, r = 3.34017,
    V = sqrt(1.0025 / ((1 - 11.1567)^2 + 0.0025)) = 0.098580; T_W = 3.34316 N m,
    x S_f = 4.72794. Twist 3.34316 / (2000 sqrt(1.0025)) = 1.66950e-3 rad; heat
    pi x 0.05 x 2000 x 2.78723e-6 x 20 Hz = 0.017513 W.
    """
    soft = criteria_of(bare, {"torsional_stiffness": 2000.0})
    passage = soft["resonance with order 2, 180 rpm, x S_z x S_t"]
    assert (passage.value, passage.limit) == (pytest.approx(679.1, rel=1e-4), 5e3)
    torque = soft["vibratory torque x S_f x S_t, 600 rpm" + MOTORED]
    assert (torque.value, torque.limit) == (pytest.approx(4.72794, rel=1e-4), 1e3)
    heat = soft["power loss, 600 rpm" + MOTORED]
    assert (heat.value, heat.limit, heat.unit) == (
        pytest.approx(0.017513, rel=1e-3), 500.0, "W",
    )  # fmt: skip


def test_factors_on_the_resonance(bare, criteria_of):
    """679.1 x 1.3 x 1.4 = 1236 N m."""
    changed = {"torsional_stiffness": 2000.0, "kind": CouplingKind.SILICONE}
    found = criteria_of(bare, changed, start_factor=1.3, temperature_factor=1.4)
    passage = found["resonance with order 2, 180 rpm, x S_z x S_t"]
    assert passage.value == pytest.approx(1236.0, rel=1e-3)


def test_a_stiff_size_passes_no_resonance(bare, criteria_of):
    assert not [name for name in criteria_of(bare) if name.startswith("resonance")]


def test_what_a_sheet_does_not_give_is_not_checked(bare, criteria_of):
    """By name, with what is missing, and never passed."""
    silent = {"vibratory_torque": None, "power_loss": None, "rare_maximum_torque": None}
    found = criteria_of(bare, silent, rare_torque=1e9)
    unknown = {
        name: c.source for name, c in found.items() if c.verdict is Verdict.NOT_CHECKED
    }
    assert len(unknown) == 3
    assert unknown["rare torque x S_t"] == "the sheet of the size gives no T_Kmax2"
    assert [name.split(" x ")[0].split(",")[0] for name in unknown] == [
        "rare torque", "vibratory torque", "power loss",
    ]  # fmt: skip
    assert not any(found[name].passes or found[name].fails for name in unknown)
    assert found["rare torque x S_t"].value == 1e9
    assert none_fails(found.values())


def test_without_a_stated_short_circuit_none_is_checked(bare, criteria_of):
    found = criteria_of(bare, rare_torque=None)["short circuit"]
    assert found.verdict is Verdict.NOT_CHECKED
    assert "duty.short_circuit" in found.source


def test_of_the_air_gap_the_engines_share_passes_the_coupling(bare, criteria_of):
    """9 kN m x 2.5 / (2.5 + 3.25) x 1.8 = 7.0435 kN m against T_Kmax2 = 6."""
    event = ShortCircuit(air_gap_torque=9e3, sudden_load_factor=1.8)
    found = criteria_of(bare, rare_torque=None, short_circuit=event)
    share = found["short circuit, air gap x J_e/(J_e + J_g) x S_L x S_t"]
    assert share.value == pytest.approx(7043.478, rel=1e-6)
    assert (share.limit, share.fails) == (6e3, True)


def test_a_bare_torque_says_that_it_is_bare(bare, criteria_of):
    found = criteria_of(bare, rare_torque=7e3)["rare torque x S_t"]
    assert "whatever the inertias" in found.source


def test_motored_orders_are_named_in_the_verdicts_own_line(bare, criteria_of):
    named = [name for name in criteria_of(bare) if "motored orders" in name]
    assert [name.split(",")[0].split(" x ")[0] for name in named] == [
        "vibratory torque", "power loss",
    ]  # fmt: skip
    fired = criteria_of(replace(bare, works_fired=True))
    assert not [name for name in fired if "motored" in name]


def test_the_working_excitation_decides_at_work_and_not_in_the_passage(
    bare, criteria_of
):
    """Twice the torque at work: twice T_W, four times the heat, the same passage."""
    strong = replace(
        bare, stated_working_excitation=(ExcitationOrder(2.0, 120.0, 0.0),)
    )
    soft = {"torsional_stiffness": 2000.0}
    before, after = criteria_of(bare, soft), criteria_of(strong, soft)
    for start, factor in (
        ("vibratory", 2.0),
        ("power loss", 4.0),
        ("resonance", 1.0),
    ):
        old, new = (
            next(c for name, c in each.items() if name.startswith(start))
            for each in (before, after)
        )
        assert new.value == pytest.approx(factor * old.value, rel=1e-9)

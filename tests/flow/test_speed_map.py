"""Campbell diagram and steady vibration of cases, present coupling and chosen."""

import dataclasses
import math

import numpy as np
import pytest

from coupling_design.flow.outcome import ChosenDesign
from coupling_design.flow.speed_map import evaluate_speed_map
from coupling_design.line.parameters import ExcitationOrder
from coupling_design.machine.candidate import Candidate
from coupling_design.machine.words import ConnectionKind, Plan
from coupling_design.speeds.campbell import Position
from coupling_design.steps.limits import (
    high_frequency_constraint,
    isolation_constraints,
)
from coupling_design.steps.present import present_candidate
from coupling_design.steps.so_far import connection_option
from coupling_design.wear.conditioning import Conditioning
from coupling_design.wear.evaluator import Evaluator
from coupling_design.wear.sensitivity import Sensitivity
from coupling_design.wear.signals import Rundown

RPM = math.pi / 30


@pytest.fixture(scope="module")
def present(paper):
    return evaluate_speed_map(paper).present


def chosen_design(case, coupling_type, kind, stiffness, gap=0.0):
    """Return a design as a run of the flow would hand it over."""
    type_ = next(t for t in case.coupling_types if t.name == coupling_type)
    candidate = Candidate(type_, connection_option(case, kind))
    return ChosenDesign(
        plan=type_.plan,
        coupling_type=coupling_type,
        connection=kind.value,
        performance=Evaluator(case, candidate).outline(stiffness, gap),
        rundown=Rundown(1.0, 1.0, None, 1.0, 0.0, 0.0),
        conditioning=Conditioning(0.0, 0.0, 0.0, 6),
        damage_reduction=0.0,
        criteria=(),
        sensitivity=Sensitivity(1.0, 1.0, ()),
        reduction_range=(0.0, 0.0),
    )


@pytest.fixture(scope="module")
def stiff(paper):
    """The 16V280 with a diaphragm coupling of 192.8 MN m/rad, tightly fitted."""
    chosen = chosen_design(paper, "diaphragm", ConnectionKind.TIGHT_FIT, 192.8e6)
    return evaluate_speed_map(paper, chosen).chosen


def test_critical_speeds_of_the_16v280(present):
    """9.3956 Hz by order 4: 9.3956 * 60 / 4 = 140.93 rpm; by order 8, 70.47 rpm.

    Margins (400 - 140.93) / 400 = 64.77 % and 82.38 %.
    """
    assert present.natural_frequencies[0] == pytest.approx(9.396, abs=5e-4)
    eighth, fourth = present.critical_speeds[:2]
    assert (eighth.order, fourth.order) == (8, 4)
    assert fourth.speed / RPM == pytest.approx(140.9, abs=0.05)
    assert eighth.speed / RPM == pytest.approx(70.5, abs=0.05)
    assert fourth.separation_margin == pytest.approx(0.6477, abs=5e-5)
    assert eighth.separation_margin == pytest.approx(0.8238, abs=5e-5)


def test_forbidden_bands_of_the_16v280(present):
    # sqrt 2 * 140.934 = 199.311 rpm and half of it: below 400 rpm, so isolated.
    borders = [band.border / RPM for band in present.forbidden_bands]
    assert borders == pytest.approx([199.311, 99.656], abs=1e-3)
    assert not any(band.reaches_working_speed for band in present.forbidden_bands)


def test_vibratory_torque_at_resonance_of_the_16v280(present):
    """Two masses, the key in series, by hand.

    J23 / J of 974.5 N m is 974.5 * 604.86 / 782.51 = 753.27 N m. c = 0.821 * 490 400 /
    290 = 1388.34; k in series with the key 490 400 / (1 + 0.4904 / 19.69) = 478 482;
    the coupling has k_s / k of the twist, so damps c (k_s / k)^2 = 1321.68.
    w = 59.034: 2 D = 1321.68 * 59.034 / 478 482 = 0.163065; V = 1 / 2 D = 6.1325 with
    the damper's part sqrt(1 + 0.163^2) = 1.0132: 753.27 * 6.2135 = 4680 N m. The oil
    in the key and the hub's inertia are left out: to 1 %.
    """
    vibration = present.vibration
    at = np.searchsorted(vibration.speeds, present.critical_speeds[1].speed)
    assert vibration.vibratory_torque[0, at] == pytest.approx(4680, rel=0.01)


def test_stiff_plan_of_the_16v280(stiff):
    """By hand: w_n^2 = 192.8e6 / J, J = 177.65 * 604.86 / 782.51 = 137.3187 kg m^2.

    w_n = 1184.92, f_n = 188.586 Hz; order 8: 1414.39 rpm, 41.44 % above 1000 rpm; the
    band of order 8 begins at 1414.39 / sqrt 2 = 1000.13 rpm, of order 4 at 2000.26.
    """
    [frequency] = stiff.natural_frequencies
    assert frequency == pytest.approx(188.586, abs=2e-3)
    eighth, fourth = stiff.critical_speeds
    assert eighth.speed / RPM == pytest.approx(1414.39, abs=0.02)
    assert fourth.speed / RPM == pytest.approx(2828.79, abs=0.04)
    assert eighth.position is Position.ABOVE
    assert eighth.separation_margin == pytest.approx(0.41439, abs=2e-5)
    borders = [band.border / RPM for band in stiff.forbidden_bands]
    assert borders == pytest.approx([2000.26, 1000.13], abs=0.02)
    assert {band.plan for band in stiff.forbidden_bands} == {Plan.HIGH_STIFFNESS}
    assert not any(band.reaches_working_speed for band in stiff.forbidden_bands)


def test_too_soft_a_stiff_coupling_reaches_its_band(paper):
    chosen = chosen_design(paper, "diaphragm", ConnectionKind.TIGHT_FIT, 190e6)
    fourth, eighth = evaluate_speed_map(paper, chosen).chosen.forbidden_bands
    assert eighth.reaches_working_speed
    assert not fourth.reaches_working_speed


@pytest.mark.parametrize("stiffness", [0.3e6, 2e6, 2.5e6, 8e6])
def test_bands_agree_with_step_2(paper, stiffness):
    candidate = present_candidate(paper)
    outline = Evaluator(paper, candidate).outline(stiffness)
    coupling = dataclasses.replace(
        paper.driveline.coupling, torsional_stiffness=stiffness
    )
    driveline = dataclasses.replace(paper.driveline, coupling=coupling)
    bands = evaluate_speed_map(dataclasses.replace(paper, driveline=driveline))
    reached = [band.reaches_working_speed for band in bands.present.forbidden_bands]
    limits = isolation_constraints(paper)
    assert reached == [not limit.criterion(outline).passes for limit in limits]


@pytest.mark.parametrize("stiffness", [150e6, 192e6, 193e6, 300e6])
def test_bands_agree_with_step_4(paper, stiffness):
    kind = ConnectionKind.TIGHT_FIT
    chosen = chosen_design(paper, "diaphragm", kind, stiffness)
    bands = evaluate_speed_map(paper, chosen).chosen.forbidden_bands
    reached = any(band.reaches_working_speed for band in bands)
    limit = high_frequency_constraint(paper)
    assert reached is not limit.criterion(chosen.performance).passes


def test_the_chart(paper):
    chart = evaluate_speed_map(paper)
    assert chart.chosen is None
    assert chart.orders.tolist() == [4.0, 8.0]
    assert chart.speeds / RPM == pytest.approx([0, 1100])
    # 1100 rpm is 18.333 turns a second.
    assert chart.order_lines[:, 1] == pytest.approx([73.3333, 146.6667], abs=1e-4)


def test_names(paper, present, stiff):
    assert (present.name, present.label) == ("present", "steel-spring, key")
    assert (stiff.name, stiff.label) == ("chosen", "diaphragm, tight fit")
    k = paper.driveline.coupling.torsional_stiffness
    assert (present.torsional_stiffness, stiff.torsional_stiffness) == (k, 192.8e6)


def test_operating_points_of_the_16v280(present):
    low, high, in_range, of_all = present.operating_points
    assert low.speed / RPM == pytest.approx(400)
    assert high.speed / RPM == pytest.approx(1000)
    # Above resonance it falls with speed.
    assert in_range.speed == low.speed
    assert of_all.speed / RPM == pytest.approx(140.9, abs=2)
    assert of_all.vibratory_torque_sum > 30 * in_range.vibratory_torque_sum


@pytest.mark.parametrize("name", ["16v280.yaml", "8l_marine.yaml", "small_genset.yaml"])
def test_shipped_cases_work_away_from_resonance(shipped, name):
    coupling = evaluate_speed_map(shipped(name)).present
    assert coupling.separated
    assert coupling.isolated


def test_one_critical_speed_in_the_working_range_is_enough(paper):
    # Order 1 meets 9.3956 Hz at 60 * 9.3956 = 563.7 rpm.
    first = ExcitationOrder(1.0, 100.0, 0.0)
    excitation = (*paper.driveline.excitation, first)
    driveline = dataclasses.replace(paper.driveline, excitation=excitation)
    coupling = evaluate_speed_map(
        dataclasses.replace(paper, driveline=driveline)
    ).present
    [inside] = [c for c in coupling.critical_speeds if not c.passes]
    assert inside.speed / RPM == pytest.approx(563.7, abs=0.1)
    assert inside.position is Position.INSIDE
    assert not coupling.separated
    assert not coupling.isolated
    assert coupling.operating_points[2].speed / RPM == pytest.approx(563.7, rel=0.03)

"""A hand-made outcome of five steps, and one that ends without a design."""

from dataclasses import replace
from pathlib import Path

import pytest

from coupling_design.case import load_case
from coupling_design.flow.outcome import ChosenDesign, DesignOutcome, LoadReading
from coupling_design.flow.size_choice import CatalogueChoice, SizeTrial
from coupling_design.line.parameters import LossFactorDamping
from coupling_design.machine.coupling_size import (
    CatalogueFile,
    CouplingKind,
    CouplingSize,
)
from coupling_design.machine.words import Plan
from coupling_design.parts.criterion import Criterion, Sense, Verdict
from coupling_design.search.design_map import DesignMap
from coupling_design.search.optimum import Optimum
from coupling_design.steps.baseline import Baseline
from coupling_design.steps.step_result import Alternative, Decision, StepResult
from coupling_design.wear.chance import Spread
from coupling_design.wear.conditioning import Conditioning
from coupling_design.wear.performance import Performance
from coupling_design.wear.sensitivity import Move, Sensitivity
from coupling_design.wear.signals import Rundown

CASE = Path(__file__).parents[2] / "cases" / "16v280.yaml"
PRESENT = Performance(
    541e3, 0.28e-3, 9.963, (4.0512345e-9, 7.5e-11), 70173.0, (97361.0, 28981.0),
    Spread(
        8, ((3.9e-9, 4.2e-9), (7.1e-11, 7.9e-11)), (69800.0, 70173.0), 70000.0, 3
    ),
)  # fmt: skip
STIFF = Performance(
    192.80e6, 0.0, 188.563, (2.5621e-9, 6.62e-11), 33926.07, (54301.0, 21043.0),
    Spread(
        8, ((2.4e-9, 2.7e-9), (6.1e-11, 7.0e-11)), (33900.0, 33926.07), 33910.0, 0
    ),
)  # fmt: skip
MOVED = Sensitivity(
    4.0512345e-9, 70173.0, (Move("initial speed", 0.97, 3.98e-9, 70170.0),)
)
STEADY = Sensitivity(
    2.5621e-9, 33926.07, (Move("initial speed", 0.97, 2.5622e-9, 33926.0),)
)
FIRM = Conditioning(1.2e-10, -2.1e-5, 3.1e-5, 4)
SHAKY = Conditioning(4.4e-3, 7.1e-3, 2e-2, 2)
RUNDOWN = Rundown(13.14, 61870.0, 11.96, 45.91, 0.08, 0.325)
CARRIES = Criterion(
    "diaphragm: rated torque x service factor", 45.5e3, 63e3, Sense.AT_MOST,
    "N*m", Verdict.PASS, 0.27778, "nominal torque T_KN of the type",
)  # fmt: skip
TOO_SMALL = Criterion(
    "steel-spring: peak torque", 75.001e3, 75e3, Sense.AT_MOST,
    "N*m", Verdict.FAIL, -1.3333e-5, "maximum torque T_Kmax of the type",
)  # fmt: skip
FREQUENCY = Criterion(
    "natural frequency", 188.563, 188.5618, Sense.AT_LEAST,
    "Hz", Verdict.PASS, 6.4e-6, "sqrt 2 times the highest excitation (paper, step 4)",
)  # fmt: skip
FORCE = Criterion(
    "peak transmission force", 33926.07, 36120.18, Sense.AT_MOST,
    "N", Verdict.PASS, 0.060745, "F_min less the static load (eq. 7)",
)  # fmt: skip
STRICT = Criterion(
    "peak combined load, Bearing 1", 54301.0, 48838.56, Sense.AT_MOST,
    "N", Verdict.FAIL, -0.11185,
    "F_min = (S_min / K1)^2 (eq. 7; with the shaft's lever)",
)  # fmt: skip
TOO_HIGH = replace(FORCE, value=46690.0, verdict=Verdict.FAIL, margin=-0.29263)
OPTIMUM = Optimum(
    objective="damage",
    performance=STIFF,
    connection="tight_fit",
    coupling_type="diaphragm",
    method="ipopt",
    solver_status="Solve_Succeeded",
    starts=3,
    starts_agreeing=2,
    scan_points=32,
    rollouts=87,
    kkt_residual=1.3e-8,
    active_constraints=("natural frequency",),
    held_by="natural frequency",
    conditioning=FIRM,
)
SCANNED = replace(
    OPTIMUM,
    performance=replace(PRESENT, key_gap=0.05e-3),
    method="scan",
    solver_status="Maximum_Iterations_Exceeded",
    kkt_residual=None,
    active_constraints=(),
    held_by="no constraint and no bound: an inner minimum, larger at each bound",
    conditioning=None,
)
MAP = DesignMap(
    "steel-spring, key",
    torsional_stiffness=tuple(0.25e6 + 0.05e6 * i for i in range(12)),
    key_gap=(0.0, 0.14e-3, 0.28e-3),
    damage=tuple(tuple(1e-9 * (i + j + 1) for j in range(12)) for i in range(3)),
    peak_transmission_force=tuple(
        tuple(1e3 * (50 + i + j) for j in range(12)) for i in range(3)
    ),
)
NEAREST = replace(
    OPTIMUM, performance=PRESENT, connection="key", coupling_type="steel-spring"
)
STEPS = (
    StepResult(
        1,
        "Coupling types",
        "Which types carry the torque?",
        Decision.PASS,
        criteria=(CARRIES, TOO_SMALL),
        alternatives=(
            Alternative("diaphragm", True, None, "100 to 400 MN*m/rad"),
            Alternative("steel-spring [bold]", False, None, "too small"),
        ),
        findings=("1 of 2 types carries the torque.",),
        caveats=("Vibratory torque T_KW is not checked.",),
    ),
    StepResult(2, "Vibration isolation", "Is it isolated?", Decision.PASS),
    StepResult(
        3,
        "Bearing load",
        "Which stiffness does the least damage while the peak load stays below its "
        "limit, at the present gap?",
        Decision.FAIL,
        criteria=(TOO_HIGH,),
        alternatives=(
            Alternative(
                "steel-spring: smallest peak at the present gap",
                False,
                PRESENT,
                "1.293 of the limit, from 32 scanned stiffnesses",
            ),
        ),
        optimum=SCANNED,
        maps=(MAP,),
    ),
    StepResult(
        4,
        "High-stiffness plan",
        "How stiff must it be?",
        Decision.PASS,
        criteria=(FREQUENCY, FORCE),
        optimum=OPTIMUM,
    ),
    StepResult(
        5,
        "Key gap",
        "What is the smallest gap?",
        Decision.PASS,
        criteria=(FREQUENCY, FORCE),
        optimum=OPTIMUM,
    ),
)


@pytest.fixture(scope="session")
def case():
    return replace(load_case(CASE), file="cases/16v280.yaml")


@pytest.fixture(scope="session")
def outcome(case):
    return DesignOutcome(
        case=case,
        baseline=Baseline(
            PRESENT, "key", "steel-spring", RUNDOWN, SHAKY, 1e-4, 4.14e-4, MOVED
        ),
        steps=STEPS,
        chosen=ChosenDesign(
            plan=Plan.HIGH_STIFFNESS,
            coupling_type="diaphragm",
            connection="tight_fit",
            performance=STIFF,
            rundown=replace(RUNDOWN, rest_time=None),
            conditioning=FIRM,
            damage_reduction=1 - 2.5621e-9 / 4.0512345e-9,
            criteria=(CARRIES, FREQUENCY, FORCE),
            sensitivity=STEADY,
            reduction_range=(0.312, 0.401),
            fuel_cut_at_once=replace(STIFF, peak_transmission_force=59519.7),
        ),
        strict_reading=LoadReading("combined_load", (STRICT,), False, 28896.14),
        nearest=None,
        nearest_criteria=(),
        assumptions=case.assumptions,
        engine="CasADi's virtual machine",
        rollouts=123,
        run_time=43.27,
    )


@pytest.fixture(scope="session")
def no_design(outcome):
    skipped = replace(
        STEPS[4],
        decision=Decision.SKIPPED,
        criteria=(),
        optimum=None,
        findings=("No coupling meets the limits: there is no gap to reduce.",),
    )
    return replace(
        outcome,
        steps=(*STEPS[:3], replace(STEPS[3], decision=Decision.FAIL), skipped),
        chosen=None,
        nearest=NEAREST,
        nearest_criteria=(TOO_HIGH,),
    )


SHEET = CouplingSize(
    name="DP 80",
    series="DP",
    kind=CouplingKind.DIAPHRAGM,
    nominal_torque=80e3,
    maximum_torque=140e3,
    rare_maximum_torque=None,
    vibratory_torque=25e3,
    power_loss=1.2e3,
    maximum_speed=188.49555921538757,
    torsional_stiffness=235e6,
    damping_law=LossFactorDamping(0.02),
    driving_inertia=7.6,
    driven_inertia=3.4,
    source="invented",
    note="an example",
)
REAL = replace(
    STIFF,
    torsional_stiffness=235e6,
    natural_frequency=210.7,
    damages=(2.7e-9, 6.7e-11),
)
CHOICE = CatalogueChoice(
    files=(CatalogueFile("catalogues/my.yaml", "0" * 64, "My [bold] sizes"),),
    plan="high_stiffness",
    connection="tight_fit",
    ideal_type="diaphragm",
    ideal=STIFF,
    trials=(
        SizeTrial(
            replace(SHEET, name="DP 50"),
            None,
            (replace(FREQUENCY, verdict=Verdict.FAIL),),
            passes=False,
            remark="fails: natural frequency",
        ),
        SizeTrial(SHEET, REAL, (CARRIES, FREQUENCY, FORCE), True, "meets every limit"),
    ),
    selected=SizeTrial(
        SHEET, REAL, (CARRIES, FREQUENCY, FORCE), True, "meets every limit"
    ),
    price=2.7e-9 / 2.5621e-9 - 1,
    price_of_stiffness=-0.00131,
    is_chosen=False,
    findings=("Each size was rolled out on its own.",),
)


@pytest.fixture(scope="session")
def with_catalogue(outcome):
    """The ideal stays chosen; the best real size stands beside it."""
    return replace(outcome, catalogue_choice=CHOICE)


@pytest.fixture(scope="session")
def real_size(with_catalogue):
    """The best real size is the chosen design."""
    case = with_catalogue.case
    series = replace(case.coupling_types[2], name="DP").with_sizes((SHEET,))
    case = replace(
        case,
        coupling_types=(*case.coupling_types, series),
        catalogues=CHOICE.files,
    )
    chosen = replace(
        with_catalogue.chosen, coupling_type="DP", size="DP 80", performance=REAL
    )
    choice = replace(CHOICE, is_chosen=True)
    return replace(with_catalogue, case=case, chosen=chosen, catalogue_choice=choice)


@pytest.fixture(scope="session")
def no_size(with_catalogue):
    """No real size keeps the limits."""
    choice = replace(
        CHOICE,
        trials=CHOICE.trials[:1],
        selected=None,
        price=None,
        price_of_stiffness=None,
    )
    return replace(with_catalogue, catalogue_choice=choice)

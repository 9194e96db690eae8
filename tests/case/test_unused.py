"""A value that nothing uses is said, by its path; one that is used is not."""

from pathlib import Path

import pytest

from coupling_design.case import load_case

INPUTS = Path(__file__).parents[1] / "inputs"
CASES = Path(__file__).parents[2] / "cases"
ENGINE = "driveline.excitation.engine"
COMBUSTION = f"{ENGINE}.combustion={{start: -5 deg, duration: 70 deg, shape: 1}}"
FUEL = ["indicated_mean_pressure", "combustion", "pressure_trace"]
TIGHT = (
    "driveline.connection.kind=tight_fit",
    "driveline.connection.gap=",
    "coupling_types[0].connections=[tight_fit]",
)
SIZES = "catalogue=[sizes.yaml]"


def unused(name, *overrides):
    return [path for path, _ in load_case(INPUTS / f"{name}.yaml", overrides).unused]


@pytest.mark.parametrize(
    ("overrides", "said"),
    [
        ([], []),
        (["duty.temperature_factor=1.4"], ["duty.temperature_factor"]),
        (["duty.start_factor=1.4"], ["duty.start_factor"]),
        (["duty.rare_torque=10 kN*m"], ["duty.rare_torque"]),
        (
            ["driveline.coupling.driving_inertia=1 kg*m^2"],
            ["driveline.coupling.driving_inertia"],
        ),
        ([SIZES, "duty.temperature_factor=1.4", "duty.start_factor=1.2"], []),
        ([SIZES, "duty.rare_torque=10 kN*m"], []),
    ],
)
def test_of_duty_and_sizes(overrides, said):
    assert unused("base", *overrides) == said


@pytest.mark.parametrize("sizes", [(), (SIZES,)])
def test_a_rare_torque_beside_a_short_circuit(sizes):
    short = "duty.short_circuit={air_gap_torque: 9 kN*m, sudden_load_factor: 1.8}"
    found = unused("base", short, "duty.rare_torque=10 kN*m", *sizes)
    assert found == ["duty.rare_torque"]
    assert unused("base", short, *sizes) == ([] if sizes else ["duty.short_circuit"])


def test_the_contact_of_a_tight_fit_where_nothing_else_is_offered():
    keys = ["contact_stiffness", "oil_damping", "smoothing"]
    expected = [f"driveline.connection.{key}" for key in keys]
    alone = (*TIGHT, "design_space.connections.key=")
    assert unused("base", *alone) == expected
    assert unused("base") == []


def test_fuel_of_a_motored_engine():
    found = unused(
        "engine_misfire_but_motored",
        f"{ENGINE}.pressure_trace=trace.csv",
        f"{ENGINE}.indicated_mean_pressure=10 bar",
        COMBUSTION,
    )
    keys = [*FUEL, "misfiring_cylinders"]
    assert found == [f"driveline.excitation.engine.{key}" for key in keys]


def test_the_same_fuel_where_the_engine_fires_at_work():
    work = "duty.excitation={engine: {mode: fired}}"
    trace = "driveline.excitation.engine.pressure_trace=trace.csv"
    assert unused("engine_motored", trace, work) == []
    assert unused("engine_motored", trace) == [trace.partition("=")[0]]


def test_fuel_of_an_engine_that_is_motored_at_work():
    work = "duty.excitation={engine: {mode: motored, misfiring_cylinders: [1]}}"
    found = unused("engine_motored", work)
    assert found == ["duty.excitation.engine.misfiring_cylinders"]


def test_combustion_beside_a_trace():
    found = unused("engine_fired_with_trace", COMBUSTION)
    assert found == ["driveline.excitation.engine.combustion"]


def test_every_reason_is_a_clause():
    (_, why), *_ = load_case(INPUTS / "engine_misfire_but_motored.yaml").unused
    assert why == "the engine is motored, its fuel is off"


@pytest.mark.parametrize("file", sorted(CASES.glob("*.yaml")), ids=lambda f: f.stem)
def test_shipped_cases_use_all_they_state(file):
    assert load_case(file).unused == ()

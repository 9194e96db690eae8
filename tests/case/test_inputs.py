"""Small inputs with one thing wrong each: what is said of it, where, and the exit code.

Made from tests/inputs/base.yaml; the first line of each says what was changed. What a
run-down must show first is in tests/fixtures/test_inputs.py.
"""

import re
import shutil
from pathlib import Path

import pytest

from coupling_design.__main__ import main

INPUTS = Path(__file__).parents[1] / "inputs"

# Line, path and words of each problem; all of the file.
REFUSED = {
    "K1_1e-300": [
        (19, "bearings[0].stress_coefficient", "found '1e-300 MPa/N^0.5', allowed"),
        (20, "bearings[1].stress_coefficient", "found '1e-300 MPa/N^0.5', allowed"),
    ],
    "amplitude_1e300": [
        (12, "driveline.excitation[0].amplitude", "found '1e300 N*m', allowed"),
    ],
    "base_sixty_number": [
        (13, "driveline.excitation[1].order", "which YAML 1.1 counts in sixties"),
    ],
    "engine_ratio_as_1_to_14": [
        (19, "driveline.excitation.engine.compression_ratio", "a ratio of 1:14 is 14"),
    ],
    "engine_trace_long_field": [
        (26, "driveline.excitation.engine.pressure_trace",
         "trace_long_field.csv:2: found a field of up to 140006 characters, allowed"),
    ],
    "engine_trace_peak_elsewhere": [
        (26, "driveline.excitation.engine.pressure_trace",
         "whose largest pressure lies 190 deg after firing top dead centre; allowed"),
    ],
    "factors_below_one": [
        (27, "duty.temperature_factor", "found '0.6', allowed 1 to 20. A factor of"),
        (28, "duty.start_factor", "found '0.5', allowed 1 to 20. A factor of DIN"),
    ],
    "inertia_1e-300": [
        (7, "driveline.coupling_inertia", "found '1e-300 kg*m^2', allowed"),
    ],
    "merge_key": [(21, "lubrication", "found the merge key '<<'")],
    "negative_permissible_force": [
        (19, "bearings[0].stress_coefficient", "F_min is 625 N, no more than the 1100"),
        (20, "bearings[1].stress_coefficient", "F_min is 625 N, no more than the 1100"),
    ],
    "octal_number": [
        (12, "driveline.excitation[0].order", "which YAML 1.1 counts in eights; write"),
    ],
    "one_step": [(16, "shutdown.time_step", "allowed are 100 or more: write a")],
    "order_1e300": [(12, "driveline.excitation[0].order", "found '1e300', allowed")],
    "psi_8": [
        (34, "coupling_types[0].damping.relative_damping",
         "found '8', allowed up to 2 pi; it may be the magnifier M of a sheet: then "
         "psi = 2 pi / M, here 0.785"),
    ],
    "ratings_1e200": [
        (19, "bearings[0].dynamic_load_rating", "found '1e200 kN', allowed"),
        (19, "bearings[0].static_load_rating", "found '1e200 kN', allowed"),
        (20, "bearings[1].dynamic_load_rating", "found '1e200 kN', allowed"),
        (20, "bearings[1].static_load_rating", "found '1e200 kN', allowed"),
    ],
    "service_factor_below_one": [
        (26, "duty.service_factor", "found '0.8', allowed 1 to 20. A factor of DIN"),
    ],
    "speed_with_comma": [
        (23, "duty.working_speed.highest",
         "found '1,500 rpm', thousands take no comma: write 1500 rpm"),
    ],
    "tag_binary": [(2, "name", "found the tag '!!binary'")],
    "tag_bool": [(2, "name", "found the tag '!!bool'")],
    "tag_int_empty": [
        (26, "duty.service_factor", "found ''"),
        (26, "duty.service_factor", "found the tag '!!int'"),
    ],
    "tag_timestamp": [(2, "name", "found the tag '!!timestamp'")],
    "time_step_unstable": [
        (16, "shutdown.time_step", "found 0.0002 s, allowed at most 1.68e-05 s"),
    ],
    "transition_speed_1e-320": [
        (14, "driveline.engine_resistance.transition_speed", "found '1e-320 rad/s'"),
        (15, "driveline.generator_resistance.transition_speed", "found '1e-320 rad/s'"),
    ],
    "two_steps": [(16, "shutdown.time_step", "which makes 2 steps; allowed are 100")],
    "very_slow_natural_frequency": [
        (9, "driveline.coupling.torsional_stiffness", "found '1e-9 N*m/rad', allowed"),
        (33, "coupling_types[0].stiffness.lowest", "found '1e-9 N*m/rad', allowed"),
    ],
    "weight_1e300": [(17, "shaft.rotor_weight", "found '1e300 N', allowed")],
    "working_speed_1e-9": [
        (23, "duty.working_speed.lowest", "found '1e-9 rpm', allowed"),
    ],
    # The date is text; what follows it is told.
    "wrong_date": [
        (14, "driveline.engine_resistance.frction", "did you mean 'friction'?"),
        (25, "duty.peak_torque", "found '3.2 kNm/s', that is a power"),
    ],
}  # fmt: skip
# Line (None: without one), path and words of each warning; all that `check` has.
WARNED = {
    "base": [],
    "engine_motored": [],
    "engine_fired_with_trace": [],
    "engine_threshold_zero": [],
    "catalogue_without_T_Kmax2": [],
    "two_types": [],
    "type_of_catalogue": [],
    # Only a run-down shows what is wrong with these two.
    "bearing_ratings_in_N": [],
    "stops_above_resonance": [],
    "bearing_rating_1_N": [
        (19, "bearings[0].dynamic_load_rating", "has C_0 / C = 9.231e+04, outside"),
        (20, "bearings[1].dynamic_load_rating", "has C_0 / C = 9.231e+04, outside"),
    ],
    "contact_softer_than_coupling": [
        (10, "driveline.connection.contact_stiffness",
         "is 0.167 times as stiff as the present coupling; below 10 times"),
    ],
    "engine_misfire_but_motored": [
        (26, "driveline.excitation.engine.misfiring_cylinders",
         "is not used: the engine is motored, its fuel is off."),
    ],
    "rated_torque_of_a_toy": [
        (24, "duty.rated_torque", "is 1.6 kW, outside 3 to 30000 kW"),
        (8, "driveline.generator_inertia", "is 43.02 s, outside 0.05 to 20 s"),
    ],
    "resonance_not_met": [
        (16, "shutdown.initial_speed",
         "the run-down does not pass the natural frequency. Its largest order, 3, "
         "meets the present coupling's 14.8 Hz at 296 rpm, and it begins at 140 rpm."),
    ],
    "speed_6000_rpm": [
        (23, "duty.working_speed.highest", "is 6000 rpm, outside 60 to 3600 rpm"),
    ],
}  # fmt: skip


@pytest.fixture
def check(tmp_path, monkeypatch, capsys):
    """Return exit code, errors and output of `check` on an input."""
    inputs = tmp_path / "inputs"
    shutil.copytree(INPUTS, inputs)
    (inputs / "trace_long_field.csv").write_text(
        "crank angle [deg],pressure [bar]\n-360,1." + 139_999 * "0" + "\n"
    )
    monkeypatch.chdir(inputs)
    monkeypatch.setenv("COLUMNS", "400")

    def run(name):
        code = main(["check", f"{name}.yaml"])
        captured = capsys.readouterr()
        return code, captured.err, captured.out

    return run


@pytest.mark.parametrize("name", REFUSED)
def test_refused(name, check):
    code, told, _ = check(name)
    assert code == 2
    assert_told(told, name, REFUSED[name])


@pytest.mark.parametrize("name", WARNED)
def test_warned(name, check):
    code, errors, told = check(name)
    assert (code, errors) == (0, "")
    assert_told(told, name, WARNED[name])


def test_every_input_is_here():
    files = {file.stem for file in INPUTS.glob("*.yaml")} - {"sizes"}
    assert files == {*REFUSED, *WARNED}


def assert_told(text, name, expected):
    # `case file  NAME: no problem found` names no line, and begins otherwise.
    sentences = re.findall(rf"^(?:- )?({re.escape(name)}\.yaml:\d.*)$", text, re.M)
    assert len(sentences) == len(expected), text
    for sentence, (line, path, words) in zip(sentences, expected, strict=True):
        assert sentence.startswith(f"{name}.yaml:{line}: {path}")
        assert words in sentence

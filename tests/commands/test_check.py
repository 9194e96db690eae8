from pathlib import Path

CASES = Path(__file__).parents[2] / "cases"


def line_of(text, start):
    return next(line for line in text.splitlines() if line.startswith(start)).split()


def test_each_value_in_si_with_its_line(run, quick):
    code, out, err = run("check", quick)
    assert (code, err) == (0, "")
    gap = line_of(out, "  gap ")
    assert gap == ["gap", "0.10", "mm", "0.0001", "m", "19"]
    assert line_of(out, "  reliability")[-2:] == ["-", "72"]
    assert "no problem found" in out


def test_what_is_not_given_is_listed(run, quick):
    out = run("check", quick)[1]
    listed = out[out.index("Not given") :]
    assert line_of(listed, "  coupling_types[0].description")[1:] == [
        "default:",
        "empty",
    ]
    assert line_of(listed, "  duty.rare_torque")[1:] == ["left", "out"]


def test_an_engines_orders_are_worked_out(run):
    """About 1.6 and 1.4 kN m with 50 degrees between the banks; 45 cancel order 4."""
    case = str(CASES / "16v280_engine.yaml")
    out = run("check", case)[1]
    assert line_of(out, "  driveline.excitation[0].order")[1:] == ["4"]
    assert 1500 < float(line_of(out, "  driveline.excitation[0].amplitude")[1]) < 1700
    assert 1300 < float(line_of(out, "  driveline.excitation[1].amplitude")[1]) < 1450
    cancelled = run("check", case, "--set", "engine.bank_angle=45deg")[1]
    assert line_of(cancelled, "  driveline.excitation[0].order")[1:] == ["8"]


def test_source_and_note(run):
    code, out, _ = run("new", "case.yaml")
    assert code == 0
    code, out, _ = run("check", "case.yaml", "--notes")
    assert code == 0
    assert "derived" in line_of(out, "  duration")
    assert "to standstill with this friction" in out


def test_a_value_from_the_command_line(run, quick):
    code, out, _ = run("check", quick, "--set", "connection.gap=0.15mm")
    assert code == 0
    assert line_of(out, "  gap ")[-3:] == ["0.00015", "m", "--set"]
    assert "driveline.connection.gap=0.15mm" in out


def test_problems_name_the_command_line(run, quick):
    code, out, err = run("check", quick, "--set", "connection.gap=3 kg")
    assert (code, out) == (2, "")
    assert "--set driveline.connection.gap=3 kg: found '3 kg', that is a mass" in err


def test_a_step_that_is_too_large(run, quick):
    code, _, err = run("check", quick, "--set", "time_step=0.01 s")
    assert code == 2
    assert "shutdown.time_step" in err

import csv
from pathlib import Path

import pytest

from coupling_design.case import load_case
from coupling_design.explore.points import present_point
from coupling_design.wear.evaluator import Evaluator


def rows_of(file):
    with Path(file).open() as text:
        return list(csv.DictReader(text))


def numbers(rows, column):
    return [float(row[column]) for row in rows]


def test_stiffness_and_gap_in_order(run, quick):
    code, out, err = run(
        *("sweep", quick, "stiffness=0.5..2x:3", "gap=0..0.2mm:2", "--out", "s.csv")
    )
    assert (code, err) == (0, "")
    rows = rows_of("s.csv")
    stiffness = [1000, 1000, 2500, 2500, 4000, 4000]
    assert numbers(rows, "stiffness [N*m/rad]") == stiffness
    assert numbers(rows, "gap [m]") == [0, 0.2e-3] * 3
    case = load_case(quick)
    evaluator = Evaluator(case, present_point(case).candidate)
    expected = evaluator.performance(2500.0, 0.2e-3)
    assert float(rows[3]["damage [1]"]) == expected.damage
    assert float(rows[3]["peak_transmission_force [N]"]) == (
        expected.peak_transmission_force
    )
    assert "C_Tdyn" in out


def test_any_value_by_its_path(run, quick):
    code, _, _ = run("sweep", quick, "viscosity=20..60mm^2/s:3", "--out", "s.csv")
    assert code == 0
    rows = rows_of("s.csv")
    viscosity = numbers(rows, "lubrication.viscosity [m^2/s]")
    assert viscosity == pytest.approx([20e-6, 40e-6, 60e-6])
    damage = numbers(rows, "damage [1]")
    assert damage == sorted(damage, reverse=True)


def test_words_and_a_second_axis(run, quick):
    run(
        *("sweep", quick, "cleanliness=high, severe", "stiffness=1..4kN*m/rad:2"),
        *("--out", "s.csv"),
    )
    rows = rows_of("s.csv")
    assert [row["lubrication.cleanliness"] for row in rows] == (
        ["high"] * 2 + ["severe"] * 2
    )
    clean, dirty = numbers(rows[:2], "damage [1]"), numbers(rows[2:], "damage [1]")
    assert all(a < b for a, b in zip(clean, dirty, strict=True))


def test_times_the_present_and_equal_ratios(run, quick):
    run("sweep", quick, "initial_speed=0.8,1x", "--out", "a.csv")
    speeds = numbers(rows_of("a.csv"), "shutdown.initial_speed [rad/s]")
    assert len(speeds) == 2
    run("sweep", quick, "stiffness=1..100kN*m/rad:3log", "--out", "b.csv")
    stiffness = numbers(rows_of("b.csv"), "stiffness [N*m/rad]")
    assert stiffness == pytest.approx([1e3, 1e4, 1e5])


def test_netcdf_has_units(run, quick):
    xarray = pytest.importorskip("xarray")
    code, _, _ = run(
        *("sweep", quick, "stiffness=1..2x:2", "duration=0.5s,1s", "--out", "s.nc"),
        *("--set", "gap=0.05mm"),
    )
    assert code == 0
    with xarray.open_dataset("s.nc") as data:
        assert data.damage.dims == ("stiffness", "shutdown.duration")
        assert data.stiffness.units == "N*m/rad"
        assert data.peak_transmission_force.units == "N"
        assert data.attrs["overrides"] == "driveline.connection.gap=0.05mm"
        assert data.attrs["status"] == "complete"


def test_ctrl_c_leaves_what_is_finished(run, quick, monkeypatch):
    def interrupted(plan):
        for count, batch in enumerate(batches(plan)):
            if count:
                raise KeyboardInterrupt
            yield batch

    from coupling_design.explore import sweep

    batches = sweep._batches
    monkeypatch.setattr(sweep, "_batches", interrupted)
    code, out, _ = run("sweep", quick, "viscosity=20..60mm^2/s:3", "--out", "s.csv")
    assert code == 130
    assert "interrupted after 1 of 3 points" in out
    damage = [row["damage [1]"] for row in rows_of("s.csv")]
    assert float(damage[0]) > 0
    assert damage[1:] == ["nan", "nan"]


def test_a_diverging_point_is_nan(run, quick, monkeypatch):
    from coupling_design.errors import SimulationError

    performances = Evaluator.performances

    def diverging(self, points, start_offset=0.0):
        if any(stiffness > 3000 for stiffness, _ in points):
            raise SimulationError("too stiff")
        return performances(self, points, start_offset)

    monkeypatch.setattr(Evaluator, "performances", diverging)
    code, out, _ = run("sweep", quick, "stiffness=0.5..2x:3", "--out", "s.csv")
    assert code == 0
    assert "1 run-downs left finite numbers" in out
    assert rows_of("s.csv")[2]["damage [1]"] == "nan"


@pytest.mark.parametrize(
    ("what", "said"),
    [
        ("stiffness", "expected a range"),
        ("stiffness=0.5..2:3", "a unit is needed"),
        ("stiffness=1kg..2kN*m/rad", "both ends in the same unit"),
        ("stiffness=-1..2x:3", "more than 0"),
        ("stiffness=0..2x:3log", "must lie above zero"),
        ("stiffness=a..b", "cannot be read"),
        ("gap=1..2mm:0", "allowed is 1 value or more"),
        ("gpa=1mm", "'gpa' is no key of a case"),
        ("lubrication.viscosity=1..2kg:2", "that is a mass"),
        ("cleanliness=2x", "is no number"),
        ("time_step=0.01s", "shutdown.time_step"),
    ],
)
def test_mistakes(run, quick, what, said):
    code, out, err = run("sweep", quick, what)
    assert (code, out) == (2, "")
    assert said in err


def test_nothing_is_swept_twice(run, quick):
    code, _, err = run("sweep", quick, "gap=0,0.1mm", "connection.gap=0.1..0.2mm:2")
    assert code == 2
    assert "driveline.connection.gap is swept twice" in err


def test_a_tight_fit_has_no_gap_to_vary(run, quick):
    code, _, err = run(
        *("sweep", quick, "gap=0..0.1mm:2"),
        *("--set", "connection.kind=tight_fit", "--set", "connection.gap="),
    )
    assert code == 2
    assert "no gap to vary" in err

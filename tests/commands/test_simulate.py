import csv
from pathlib import Path

import numpy as np
import pytest

from coupling_design.case import load_case
from coupling_design.explore.points import present_point
from coupling_design.wear.evaluator import Evaluator

SIGNALS = {
    "engine_speed": "rad/s",
    "generator_speed": "rad/s",
    "transmission_force": "N",
    "coupling_torque": "N*m",
    "generator_angle": "rad",
    "combined_load_1": "N",
    "combined_load_2": "N",
    "damage_1": "1",
    "damage_2": "1",
}


@pytest.fixture(scope="module")
def present():
    """What the evaluator says of the present coupling."""
    case = load_case(Path(__file__).parents[1] / "fixtures" / "quick.yaml")
    point = present_point(case)
    evaluator = Evaluator(case, point.candidate)
    return evaluator.performance(point.torsional_stiffness, point.key_gap)


def test_csv_has_units_and_every_step(run, quick, present):
    code, out, _ = run("simulate", quick, "--out", "run.csv")
    assert code == 0
    assert "Written: run.csv" in out
    with Path("run.csv").open() as file:
        rows = list(csv.reader(file))
    assert rows[0] == ["time [s]", *(f"{n} [{u}]" for n, u in SIGNALS.items())]
    assert len(rows) == 1 + 2000
    last = dict(zip(SIGNALS, map(float, rows[-1][1:]), strict=True))
    assert last["damage_1"] == pytest.approx(present.damages[0], rel=1e-6)
    assert last["damage_2"] == pytest.approx(present.damages[1], rel=1e-6)
    forces = np.array([row[3] for row in rows[1:]], dtype=float)
    assert np.abs(forces).max() == pytest.approx(present.peak_transmission_force)


def test_the_table_tells_the_same(run, quick, present):
    out = run("simulate", quick)[1]
    assert f"{present.peak_transmission_force / 1e3:.3f}" in out
    assert "coupling_torque" in out


def test_netcdf(run, quick):
    xarray = pytest.importorskip("xarray")
    assert run("simulate", quick, "--out", "run.nc")[0] == 0
    with xarray.open_dataset("run.nc") as data:
        assert {name: data[name].units for name in data.data_vars} == SIGNALS
        assert data.sizes == {"time": 2000}
        assert data.time.units == "s"
        assert data.attrs["coupling"] == "rubber, key"


def test_parquet(run, quick):
    parquet = pytest.importorskip("pyarrow.parquet")
    assert run("simulate", quick, "--out", "run.parquet")[0] == 0
    schema = parquet.read_schema("run.parquet")
    units = {f.name: f.metadata[b"units"].decode() for f in schema}
    assert units == {"time": "s", **SIGNALS}
    assert schema.metadata[b"title"] == b"Quick"


def test_every_nth_step(run, quick):
    run("simulate", quick, "--out", "run.csv", "--every", "100")
    assert len(Path("run.csv").read_text().splitlines()) == 1 + 20


def test_another_coupling(run, quick):
    out = run(
        *("simulate", quick, "--type", "disc pack", "--connection", "tight_fit"),
        *("--stiffness", "1 MN*m/rad"),
    )[1]
    row = next(line for line in out.splitlines() if "disc pack, tight fit" in line)
    assert row.split()[4:6] == ["1.000", "0"]


def test_times_the_present(run, quick):
    out = run("simulate", quick, "--stiffness", "0.5x", "--gap", "2x")[1]
    row = next(line for line in out.splitlines() if "rubber, key" in line)
    assert row.split()[2:4] == ["0.001000", "0.2000"]


def test_mistakes_are_told_at_once(run, quick):
    code, _, err = run(
        *("simulate", quick, "--stiffness", "3 kg", "--gap", "1"),
        *("--type", "rubbr"),
    )
    assert code == 2
    assert "did you mean 'rubber'?" in err
    assert "--stiffness '3 kg': that is a mass" in err
    assert "--gap '1': a unit is needed" in err


@pytest.mark.parametrize(
    ("file", "said"),
    [("run.xls", "allowed are .csv, .parquet, .nc"), ("no/run.csv", "no such direct")],
)
def test_a_file_that_cannot_be_is_refused_before_the_work(run, quick, file, said):
    code, out, err = run("simulate", quick, "--out", file)
    assert (code, out) == (2, "")
    assert said in err


def test_an_absent_library_is_named(run, quick, monkeypatch):
    monkeypatch.setitem(__import__("sys").modules, "pyarrow", None)
    code, _, err = run("simulate", quick, "--out", "run.parquet")
    assert code == 2
    assert 'pip install "coupling-design[data]"' in err

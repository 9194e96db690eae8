import doctest
import os
import subprocess
import sys
from pathlib import Path

import pytest

from coupling_design import api
from coupling_design.case import load_case

ROOT = Path(__file__).parents[1]
QUICK = ROOT / "tests" / "fixtures" / "quick.yaml"


def test_the_examples_of_the_docstrings(monkeypatch):
    pytest.importorskip("xarray")
    monkeypatch.chdir(ROOT)
    options = doctest.ELLIPSIS | doctest.IGNORE_EXCEPTION_DETAIL
    result = doctest.testmod(api, optionflags=options)
    assert result.attempted > 10
    assert result.failed == 0


def test_importing_it_is_light():
    script = "import sys, coupling_design.api; sys.stdout.write(' '.join(sys.modules))"
    done = subprocess.run(
        [sys.executable, "-c", script],
        capture_output=True,
        text=True,
        check=True,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
    )
    heavy = {"casadi", "numpy", "pydantic", "xarray", "rich", "typer"}
    assert heavy & set(done.stdout.split()) == set()


def test_the_chosen_design_is_saved(tmp_path):
    from coupling_design.search.workbench import Effort

    said = []
    outcome = api.design(api.load(QUICK), said.append, Effort(3, 2, 2, 2, 1))
    assert said[0] == "present coupling"
    api.save_chosen(outcome, tmp_path / "chosen.yaml")
    case = load_case(tmp_path / "chosen.yaml")
    assert case.present_coupling_type == outcome.chosen.coupling_type


def test_a_sweep_with_overrides():
    pytest.importorskip("xarray")
    done = []
    grid = api.sweep(
        QUICK, {"viscosity": "20..60mm^2/s:3"}, {"gap": "0.05 mm"}, done.append
    )
    assert done == [1, 1, 1]
    assert grid["lubrication.viscosity"].units == "m^2/s"
    assert grid.attrs["overrides"] == "driveline.connection.gap=0.05 mm"

import subprocess
import sys
from pathlib import Path

import pytest

QUICK = Path(__file__).parent / "fixtures" / "quick.yaml"
HEAVY = ("casadi", "numpy", "pint", "pydantic", "rich", "scipy", "yaml")


def loaded_by(statement):
    """Return which heavy libraries a fresh interpreter has loaded after a statement."""
    script = f"import sys; {statement}; sys.stdout.write(' '.join(sys.modules))"
    command = [sys.executable, "-c", script]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    return sorted(set(HEAVY) & set(done.stdout.split()))


@pytest.mark.parametrize("module", ["coupling_design", "coupling_design.errors"])
def test_import_loads_nothing_heavy(module):
    assert loaded_by(f"import {module}") == []


def test_a_heavy_import_would_be_seen():
    assert loaded_by("import yaml") == ["yaml"]


def test_a_design_waits_for_no_library_it_can_do_without(tmp_path):
    # pint is for units out of the ordinary; of plotly only its script is read.
    arguments = [str(QUICK), "--output", str(tmp_path)]
    script = f"""if True:
        import sys
        from coupling_design.__main__ import main
        main({arguments})
        sys.stderr.write(" ".join(sys.modules))
    """
    command = [sys.executable, "-c", script]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    loaded = {name.partition(".")[0] for name in done.stderr.split()}
    assert loaded & {"pint", "scipy", "plotly", "xarray", "matplotlib"} == set()
    assert {"numpy", "casadi", "jinja2"} <= loaded

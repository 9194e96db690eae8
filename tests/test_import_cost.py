import subprocess
import sys

import pytest

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

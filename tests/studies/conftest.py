"""The shipped case. Without the extra named studies there is nothing to test here."""

from importlib.util import find_spec
from pathlib import Path

import pytest

from coupling_design.case import load_case

CASE_FILE = Path(__file__).parents[2] / "cases" / "16v280.yaml"

collect_ignore_glob = [] if find_spec("matplotlib") else ["test_*.py"]


@pytest.fixture(scope="session")
def shipped():
    return load_case(CASE_FILE)

"""The shipped case."""

from pathlib import Path

import pytest

from coupling_design.case import load_case

pytest.importorskip("matplotlib", reason="the studies need the extra named studies")

CASE_FILE = Path(__file__).parents[2] / "cases" / "16v280.yaml"


@pytest.fixture(scope="session")
def shipped():
    return load_case(CASE_FILE)

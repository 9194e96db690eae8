from pathlib import Path

import pytest

from coupling_design.case import load_case
from coupling_design.errors import CaseError

VALID = Path(__file__).with_name("valid.yaml")


@pytest.fixture
def valid():
    """Return the text of a small case without fault."""
    return VALID.read_text(encoding="utf-8")


@pytest.fixture
def write(tmp_path, monkeypatch):
    """Write a case file into an empty working directory and return its name."""
    monkeypatch.chdir(tmp_path)

    def write_case(text):
        content = text if isinstance(text, bytes) else text.encode()
        (tmp_path / "case.yaml").write_bytes(content)
        return "case.yaml"

    return write_case


@pytest.fixture
def load(write):
    """Load the case that a text describes."""
    return lambda text: load_case(write(text))


@pytest.fixture
def problems(write):
    """Return the problems that loading a text must raise."""

    def raised(text):
        with pytest.raises(CaseError) as error:
            load_case(write(text))
        return error.value.problems

    return raised

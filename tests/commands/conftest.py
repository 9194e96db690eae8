"""Commands run in this process, on a case whose run-down takes milliseconds."""

from pathlib import Path

import pytest

from coupling_design.__main__ import main

QUICK = Path(__file__).parents[1] / "fixtures" / "quick.yaml"


@pytest.fixture
def quick():
    """The file of the small case."""
    return str(QUICK)


@pytest.fixture
def run(capsys, tmp_path, monkeypatch):
    """Return what runs a command: exit code, output, errors; files go to tmp_path."""
    monkeypatch.chdir(tmp_path)

    def run_command(*arguments):
        code = main([str(each) for each in arguments])
        captured = capsys.readouterr()
        return code, captured.out, captured.err

    return run_command

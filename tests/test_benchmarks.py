import subprocess
import sys
from pathlib import Path

import pytest

from benchmarks.page import page
from benchmarks.table import Row, at_least, at_most, table
from coupling_design.lanes.compiler import CompilerError, find_compiler

ROOT = Path(__file__).parent.parent
METHODS = (
    "the same, SLSQP",
    "the same, Nelder-Mead",
    "the same, differential evolution, against",
    "the same, differential evolution to 1e-3, against",
)
ROWS = (
    "value against scalar C",
    "value and gradient against scalar C",
    "numba against value",
    "batch of 16, value against SIMD C",
    "the same with gradient against SIMD C",
    "two cores against one, batch",
    "the same of SIMD C, two threads",
    "solve_ivp (",
    "the same, t_eval at each step",
    "the same, right-hand side in numba",
    "odeint (LSODA in one call)",
    "ten times the steps, time",
    "ten times the steps, memory",
    "five-step design with its 64 x 32 map, cold [s]",
    "five-step design with its 64 x 32 map, warm [s]",
    "processor time of that, warm [s]",
    "peak memory of that [MB]",
    "import [s]",
    "least damage over stiffness, our search",
    *METHODS,
    "least damage over stiffness and gap, our search",
    *METHODS,
    "CasADi's virtual machine, value",
    "the same, sensitivities in step",
    "CasADi forward",
    "CasADi reverse",
)


def body(text):
    """Return the first column of a Markdown table, without its head."""
    return [line.split("|")[1].strip() for line in text.splitlines()[2:]]


@pytest.mark.parametrize(
    ("row", "verdict"),
    [
        (at_most("a", "a", "1", 1.0, 1.0), "met"),
        (at_most("a", "a", "2", 2.0, 1.0), "**not met**"),
        (at_least("a", "a", "2", 2.0, 1.0), "met"),
        (at_least("a", "a", "1", 1.0, 2.0), "**not met**"),
        (Row("a", "a", "1"), "-"),
    ],
)
def test_a_row_says_whether_its_bound_is_met(row, verdict):
    assert row.verdict == verdict
    assert table([row]).splitlines()[2].endswith(f"| {verdict} |")


def test_a_number_that_the_page_quotes_must_be_there():
    with pytest.raises(KeyError):
        page([Row("a", "a", "1")], {})


@pytest.mark.slow
def test_everything_runs_and_every_row_is_there(tmp_path):
    try:
        find_compiler()
    except CompilerError as error:
        pytest.skip(str(error))
    written = tmp_path / "page.md"
    command = [sys.executable, "-m", "benchmarks", "--quick", "--write", str(written)]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    found = body(done.stdout)
    assert len(found) == len(ROWS)
    for what, expected in zip(found, ROWS, strict=True):
        assert what.startswith(expected)
    text = written.read_text(encoding="utf-8")
    assert done.stdout.strip() in text
    assert "| the 64 x 32 map of step 3 |" in text

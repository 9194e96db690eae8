"""Every command says when a run-down ends before what it is to show."""

from pathlib import Path

import pytest

ABOVE = "above the resonance with"
BEFORE_REST = "before rest"


@pytest.fixture
def short(quick):
    """The small case, stopped while it turns above its resonance."""
    text = Path(quick).read_text(encoding="utf-8")
    Path("short.yaml").write_text(
        text.replace("duration: 1 s", "duration: 0.1 s"), encoding="utf-8"
    )
    return "short.yaml"


def words(text):
    return " ".join(text.split())


def test_simulate(run, quick):
    out = run("simulate", quick, "--set", "shutdown.duration=0.1s")[1]
    assert ABOVE in words(out)
    out = run("simulate", quick)[1]
    assert ABOVE not in words(out)
    assert BEFORE_REST in words(out)
    out = run("simulate", quick, "--set", "shutdown.duration=3s")[1]
    assert BEFORE_REST not in words(out)


def test_sweep(run, quick):
    out = words(run("sweep", quick, "shutdown.duration=0.1,1,3s")[1])
    assert f"1 of 3 points end {ABOVE} the largest order" in out
    assert "Cut off: at some points the set turns at" in out
    assert "Cut off" not in run("sweep", quick, "shutdown.duration=3,4s")[1]


def test_compare(run, quick, short):
    out = words(run("compare", quick, short)[1])
    read_first_a, read_first_b = out.split("Read first, B")
    assert BEFORE_REST in read_first_a
    assert ABOVE not in read_first_a
    assert ABOVE in read_first_b

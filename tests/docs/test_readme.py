"""The lines of Python on the README's first screen print what it says."""

import doctest
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


def example():
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    return re.search(r"```python\n(.*?)```", text, re.DOTALL)[1]


@pytest.mark.slow
def test_the_first_screen_prints_what_it_says(monkeypatch):
    monkeypatch.chdir(ROOT)
    found = doctest.DocTestParser().get_doctest(example(), {}, "README", "README.md", 0)
    assert len(found.examples) >= 8
    runner = doctest.DocTestRunner(verbose=False)
    runner.run(found)
    assert runner.summarize(verbose=False).failed == 0


def test_it_stands_on_the_first_screen():
    before = (ROOT / "README.md").read_text(encoding="utf-8").partition("```python")[0]
    assert before.count("\n") < 15

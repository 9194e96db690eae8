"""The example in the README of `lanes` prints what it says."""

import doctest
import re
from pathlib import Path

from coupling_design import lanes

README = Path(lanes.__file__).with_name("README.md")


def test_the_example_prints_what_it_says(compiler):
    text = re.search(r"```python\n(.*?)```", README.read_text(encoding="utf-8"), re.S)[
        1
    ]
    found = doctest.DocTestParser().get_doctest(text, {}, "README", str(README), 0)
    runner = doctest.DocTestRunner(verbose=False)
    runner.run(found)
    assert runner.summarize(verbose=False).failed == 0

"""Whatever a file holds: a case, or sentences with file and line; never a traceback."""

import re
from copy import deepcopy
from pathlib import Path

import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st

from coupling_design.case.load import validate
from coupling_design.case.text.document import parse_text
from coupling_design.errors import CaseError

VALID = Path(__file__).with_name("valid.yaml").read_text(encoding="utf-8")


def collect(part, path=()):
    """Yield the path of everything in a document."""
    yield path
    children = part.items() if isinstance(part, dict) else ()
    children = enumerate(part) if isinstance(part, list) else children
    for key, child in children:
        yield from collect(child, (*path, key))


JUNK = st.recursive(
    st.none()
    | st.booleans()
    | st.integers()
    | st.floats()
    | st.dates()
    | st.binary(max_size=3)
    | st.text(max_size=8)
    | st.sampled_from(
        ["5 mm", "-5 mm", "1 rpm", "key", "{", "0 N", "1e999 s", "rubber"]
    ),
    lambda inner: (
        st.lists(inner, max_size=3)
        | st.dictionaries(
            st.text(max_size=5)
            | st.integers()
            | st.booleans()
            | st.none()
            | st.sampled_from(["value", "source", "law", "gap"]),
            inner,
            max_size=3,
        )
    ),
    max_leaves=5,
)
DATA = yaml.safe_load(VALID)
PATHS = [path for path in collect(DATA) if path]


def replaced(data, path, value):
    changed = deepcopy(data)
    holder = changed
    for element in path[:-1]:
        holder = holder[element]
    holder[path[-1]] = value
    return changed


@settings(max_examples=60)
@given(path=st.sampled_from(PATHS), junk=JUNK)
def test_junk_anywhere(path, junk):
    text = yaml.safe_dump(replaced(DATA, path, junk), sort_keys=False)
    check(text)


@settings(max_examples=60)
@given(
    start=st.integers(0, len(VALID)), junk=st.text(max_size=5), length=st.integers(0, 9)
)
def test_characters_replaced_anywhere(start, junk, length):
    check(VALID[:start] + junk + VALID[start + length :])


@pytest.mark.parametrize("path", PATHS, ids=str)
def test_anything_left_out(path):
    changed = deepcopy(DATA)
    holder = changed
    for element in path[:-1]:
        holder = holder[element]
    del holder[path[-1]]
    check(yaml.safe_dump(changed, sort_keys=False))


def check(text):
    sentence = re.compile(r"case\.yaml:\d+: .")
    assert all(sentence.match(problem) for problem in problems_of(text))


def problems_of(text):
    try:
        validate(parse_text(text, "case.yaml"))
    except CaseError as error:
        return error.problems or ["no problem is told"]
    return []

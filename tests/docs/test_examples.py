"""What the pages say is printed is what is printed."""

import importlib.util
import re
import shlex
import sys
from pathlib import Path

import pytest

from coupling_design.commands.app import COMMANDS
from coupling_design.lanes.compiler import CompilerError, find_compiler

ROOT = Path(__file__).resolve().parents[2]


def load_tool(name):
    spec = importlib.util.spec_from_file_location(
        f"docs_{name}", ROOT / "docs" / "tools" / f"{name}.py"
    )
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module


examples = load_tool("examples")
case_keys = load_tool("case_keys")
PAGES = [page for page in examples.pages() if examples.blocks(page)]
NAMES = [str(page.relative_to(examples.DOCS)) for page in PAGES]

# Rows of the table in docs/field.md that the tool has an answer to.
ROWS = {1, 2, 3, 4, 5, 6, 7, 9, 10, 11, 12, 14, 15, 16, 17, 19, 21, 22, 23, 24, 25, 26,
        27, 29, 30}  # fmt: skip
_ROW = re.compile(r"^\| (\d+) \|[^|]+\| `([^`]+)` \|", re.MULTILINE)
_QUICK = {"campbell", "check", "new", "schema", "--help"}
_REFUSED = {24}


def field_rows():
    text = (examples.DOCS / "field.md").read_text(encoding="utf-8")
    return {int(number): command for number, command in _ROW.findall(text)}


def quick(command):
    return bool(_QUICK & set(shlex.split(command)))


def check_row(number, command):
    words = shlex.split(command)
    if words[0] == "make":
        makefile = (ROOT / "Makefile").read_text(encoding="utf-8")
        assert f"\n{words[1]}:" in makefile
        return
    with examples.session():
        code, lines = examples.call(words[1:])
    assert code == (2 if number in _REFUSED else 0), lines
    assert lines


@pytest.mark.parametrize("page", PAGES, ids=NAMES)
def test_quick_examples_print_what_the_page_says(page):
    assert examples.problems(page, slow=False) == []


@pytest.mark.slow
@pytest.mark.parametrize("page", PAGES, ids=NAMES)
def test_every_example_prints_what_the_page_says(page):
    """The pages show the close survey, which only machine code affords."""
    try:
        find_compiler()
    except CompilerError as error:
        pytest.skip(str(error))
    assert examples.problems(page, slow=True) == []


@pytest.mark.parametrize("name", COMMANDS)
def test_every_command_has_a_page_with_its_help(name):
    page = examples.DOCS / "commands" / f"{name}.md"
    commands = [block.command for block in examples.blocks(page)]
    assert f"coupling-design {name} --help" in commands
    assert f"commands/{name}.md" in (ROOT / "mkdocs.yml").read_text(encoding="utf-8")


def test_the_field_has_a_command_for_each_row():
    assert set(field_rows()) == ROWS


@pytest.mark.parametrize(
    "number", [n for n, command in field_rows().items() if quick(command)]
)
def test_quick_command_of_a_row(number):
    check_row(number, field_rows()[number])


@pytest.mark.slow
@pytest.mark.parametrize(
    "number", [n for n, command in field_rows().items() if not quick(command)]
)
def test_command_of_a_row(number):
    check_row(number, field_rows()[number])


def test_keys_of_the_case_file_are_those_of_the_schema():
    assert case_keys.PAGE.read_text(encoding="utf-8") == case_keys.page()


@pytest.mark.parametrize(
    ("old", "new", "same"),
    [
        ("peak  34.52 kN", "peak 34.60 kN", True),
        ("peak 34.52 kN", "peak 36.52 kN", False),
        ("peak 34.52 kN", "least 34.52 kN", False),
        ("D 2.19e-9 PASS", "D 2.20e-9 PASS", True),
        ("D 2.19e-9 PASS", "D 2.19e-9 FAIL", False),
        ("Run time 9.4 s", "Run time 24 s", True),
    ],
)
def test_numbers_may_differ_in_their_last_digits_and_words_not(old, new, same):
    block = examples.Block(Path(), 1, (0, 0), f"$ coupling-design x\n{old}\n")
    assert (examples.difference(block, [new]) == "") is same


def test_parts_of_an_output_are_divided_by_cuts():
    lines = ["a", "b", "c", "d", "e"]
    assert examples.shown(lines, [["b", 1], ["d", "e"]]) == [
        "[...]", "b", "[...]", "d", "e"
    ]  # fmt: skip
    with pytest.raises(LookupError, match="no line like 'z'"):
        examples.shown(lines, [["z", 1]])

"""libyaml against PyYAML's own scanner: the same nodes, or PyYAML's are taken."""

from pathlib import Path

import pytest
import yaml

from coupling_design.case.text import nodes

ROOT = Path(__file__).parents[2]
FILES = sorted([*ROOT.glob("cases/*.yaml"), *ROOT.glob("catalogues/*.yaml")])

needs_libyaml = pytest.mark.skipif(
    not yaml.__with_libyaml__, reason="PyYAML was built without libyaml"
)


def place(mark):
    return mark.index, mark.line, mark.column


def tree(node):
    """Return all of a node that the program reads."""
    if node is None:
        return None
    known = type(node), node.tag, place(node.start_mark)
    if isinstance(node, yaml.ScalarNode):
        block = node.style if node.style in ("|", ">") else None
        return *known, place(node.end_mark), block, node.value
    end = place(node.end_mark) if node.flow_style else None
    entries = node.value
    if isinstance(node, yaml.MappingNode):
        entries = [part for pair in entries for part in pair]
    return *known, end, [tree(entry) for entry in entries]


@needs_libyaml
@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_shipped_files_go_to_libyaml(monkeypatch, file):
    text = file.read_text(encoding="utf-8")
    expected = tree(yaml_compose(text))
    monkeypatch.setattr(yaml, "compose", None)
    assert tree(nodes.compose(text)) == expected


@pytest.mark.parametrize(
    "text",
    [
        "",
        "# only a comment\n",
        "a: {value: 1 mm, note: 'it''s'}\nb:\n- x\n- [1, 2]\n",
        "note: >-\n  folded\n  text\n\nnext: |\n  kept\n",
        "größe: 0.28 µm\n",
        "{value: , source: paper}",  # an empty value stands one place further right
        "description: >#-",  # no block scalar to PyYAML
        "? key\n: value",
        "a: !!str 1",
        "\ufeffa: 1",
    ],
)
def test_the_same_nodes_as_pyyaml(text):
    assert tree_or_error(nodes.compose, text) == tree_or_error(yaml_compose, text)


@pytest.mark.parametrize(
    "text", ["a: b: c", "a: [1, 2", "a:\t1\n\tb: 2", "a: 'x", "a: \x07", "a: \ud800"]
)
def test_errors_are_pyyaml_s(text):
    assert tree_or_error(nodes.compose, text) == tree_or_error(yaml_compose, text)


def yaml_compose(text):
    return yaml.compose(text, Loader=yaml.SafeLoader)


def tree_or_error(compose, text):
    try:
        return tree(compose(text))
    except (yaml.YAMLError, ValueError) as error:
        return type(error), str(error)


def test_deep_nesting_is_an_error_and_no_crash():
    with pytest.raises(RecursionError):
        nodes.compose("[" * 100_000 + "1" + "]" * 100_000)


def test_without_libyaml(monkeypatch):
    text = FILES[0].read_text(encoding="utf-8")
    expected = tree(yaml_compose(text))
    monkeypatch.setattr(yaml, "__with_libyaml__", False)
    assert tree(nodes.compose(text)) == expected

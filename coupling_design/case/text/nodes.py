"""A YAML text's nodes, each with the place where it stands.

libyaml, which PyYAML's wheels carry, reads a case ten times as fast as PyYAML's own
scanner. The two differ in a few corners, so only a text without any of these is given
to it; and what it refuses is read again by PyYAML's scanner, whose words for what is
wrong users get.
"""

from __future__ import annotations

import re
from contextlib import suppress
from typing import Any

import yaml
from yaml.composer import Composer
from yaml.constructor import SafeConstructor

# Tabs, other line ends, complex keys, tags, several documents, a comment behind a block
# scalar's mark, and values left out between brackets.
_CORNERS = re.compile(
    r"[\t\x85\u2028\u2029\ufeff?!]|^---|[|>][-+\d]*#|:\s*[,}\]]", re.MULTILINE
)


def compose(text: str) -> yaml.Node | None:
    """Return a text's root node, None of an empty text; else raise yaml.YAMLError."""
    if yaml.__with_libyaml__ and not _CORNERS.search(text):
        with suppress(yaml.YAMLError, ValueError):
            return _compose_quickly(text)
    node: yaml.Node | None = yaml.compose(text, Loader=yaml.SafeLoader)
    return node


def construct(node: yaml.Node) -> Any:
    """Return the plain data of a root node, which is not to be used afterwards."""
    return SafeConstructor().construct_document(node)


def _compose_quickly(text: str) -> yaml.Node | None:
    # PyYAML's composer on libyaml's events. libyaml's own recurses in C: many brackets
    # one in another would overflow the stack and end the process.
    class Loader(Composer, yaml.CSafeLoader):
        def __init__(self) -> None:
            yaml.CSafeLoader.__init__(self, text)
            Composer.__init__(self)

    node: yaml.Node | None = Loader().get_single_node()
    return node

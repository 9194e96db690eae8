"""What YAML 1.1 makes of a text that nobody means: each refused, or read as text.

A node that is at fault becomes a plain text, so that it hides nothing else.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

import yaml
from yaml.resolver import Resolver

from coupling_design.case.text.fault import Path, Problem

_TEXT = "tag:yaml.org,2002:str"
_MERGE = "tag:yaml.org,2002:merge"
_TIMESTAMP = "tag:yaml.org,2002:timestamp"
_NUMBERS = ("tag:yaml.org,2002:int", "tag:yaml.org,2002:float")
_OCTAL = re.compile(r"[+-]?0[0-7_]+")
_OTHER_BASE = re.compile(r"[+-]?0[bxo].*", re.IGNORECASE)
_RESOLVER = Resolver()


def _resolved(text: str) -> str:
    """Return the tag that YAML 1.1 gives a plain text."""
    return str(_RESOLVER.resolve(yaml.ScalarNode, text, (True, False)))  # type: ignore[no-untyped-call]


def misread(node: yaml.ScalarNode, path: Path) -> Iterator[Problem]:
    """Yield what is wrong with a scalar's tag or number."""
    line = node.start_mark.line + 1
    # Plain is None to one of the two parsers, and empty to the other.
    is_plain = not node.style
    wanted = _resolved(node.value) if is_plain else _TEXT
    if node.tag not in (wanted, _TEXT):
        short = node.tag.replace("tag:yaml.org,2002:", "!!")
        node.tag = _TEXT
        yield Problem(
            path,
            f"found the tag '{short}'; tags are not used in a case file, write the "
            "value alone",
            line,
        )
    elif node.tag == _TIMESTAMP:
        node.tag = _TEXT  # a date is a text here, whatever the calendar says
    elif node.tag in _NUMBERS and is_plain:
        reason = _other_base(node.value)
        if reason:
            node.tag = _TEXT
            yield Problem(path, f"found '{node.value}', {reason}", line)


def without_merge_keys(node: yaml.MappingNode, path: Path) -> Iterator[Problem]:
    """Yield each merge key, and take it out of the mapping."""
    merges = [key for key, _ in node.value if key.tag == _MERGE]
    if merges:
        node.value = [pair for pair in node.value if pair[0].tag != _MERGE]
    for key in merges:
        yield Problem(
            path,
            "found the merge key '<<'; it belongs to aliases, which are not used in a "
            "case file: write the values out",
            key.start_mark.line + 1,
        )


def _other_base(text: str) -> str:
    """Return how YAML 1.1 would count a number otherwise than by tens, and a remedy."""
    if ":" in text:
        last = text.rpartition(":")[2]
        return (
            "which YAML 1.1 counts in sixties; write one decimal number (a ratio of "
            f"1:{last} is {last})"
        )
    if _OCTAL.fullmatch(text) and text.strip("+-0_"):
        return f"which YAML 1.1 counts in eights; write {text.lstrip('+-0')}"
    if _OTHER_BASE.fullmatch(text):
        return "which is no decimal number; write it in tens"
    return ""

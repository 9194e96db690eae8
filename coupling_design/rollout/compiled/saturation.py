"""Hyperbolic tangents in groups, as most of them have long come to 1 or -1.

A contact's smoothed edge asks for two, at the near and at the far edge of its gap. Only
one can be within its reach at a time, so the nearer is computed, and all others of the
group are tested for having reached their end, at once.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import product

from coupling_design.rollout.compiled.graph import Graph

Name = Callable[[int], str]


@dataclass(frozen=True)
class Group:
    """Tangents that do not wait for each other: pairs of edges, and single ones."""

    pairs: tuple[tuple[int, int], ...]
    single: tuple[int, ...]


def grouped(graph: Graph, places: tuple[int, ...]) -> Group:
    """Return a group with its pairs: arguments that keep their distance."""
    left, pairs = list(places), []
    while left:
        first = left.pop(0)
        edge = _edge(graph, first)
        partner = next((p for p in left if edge and _edge(graph, p) == edge), None)
        if partner is not None:
            left.remove(partner)
            pairs.append((first, partner))
    paired = {place for pair in pairs for place in pair}
    return Group(tuple(pairs), tuple(p for p in places if p not in paired))


def _edge(graph: Graph, place: int) -> tuple[int, int] | None:
    """Return (scale, moving value) of an argument scale (value +- fixed), or None."""
    argument = graph[graph[place].args[0]]
    if argument.kind != "mul":
        return None
    for scale, distance in (argument.args, argument.args[::-1]):
        value = graph[distance]
        if graph[scale].moves or value.kind not in ("add", "sub"):
            continue
        moving = [arg for arg in value.args if graph[arg].moves]
        if len(moving) == 1:
            return scale, moving[0]
    return None


def group_statements(graph: Graph, group: Group, names: list[Name]) -> list[str]:
    """Return the C statements that compute a group, `names` of each vector's values.

    The test is of all lanes at once; a tangent at its end is 1 or -1 to the last bit
    either way, so lanes do not depend on each other.
    """
    before, after = [], []
    tested: list[tuple[str, str]] = []
    for (one, other), name in product(group.pairs, names):
        a, b = (name(graph[place].args[0]) for place in (one, other))
        v, w = name(one), name(other)
        before += [
            f"const Mask {v}_nearer = less(magnitude({a}), magnitude({b}));",
            f"const Real {v}_near = tanh_of_near(choose({v}_nearer, {a}, {b}));",
            f"const Real {v}_beyond = choose({v}_nearer, {b}, {a});",
        ]
        tested.append((f"{v}_far", f"{v}_beyond"))
        after += [
            f"const Real {v} = choose({v}_nearer, {v}_near, {v}_far);",
            f"const Real {w} = choose({v}_nearer, {v}_far, {v}_near);",
        ]
    tested += [
        (name(place), name(graph[place].args[0]))
        for place, name in product(group.single, names)
    ]
    return [*before, *_tested(tested), *after]


def _tested(tangents: list[tuple[str, str]]) -> list[str]:
    """Return statements for (result, argument) that are likely at their ends."""
    if not tangents:
        return []
    test = f"at_end({tangents[0][1]})"
    for _, argument in tangents[1:]:
        test = f"both({test}, at_end({argument}))"
    ends = " ".join(f"{result} = end_of({x});" for result, x in tangents)
    within = " ".join(f"{result} = tanh_within({x});" for result, x in tangents)
    return [
        f"Real {', '.join(result for result, _ in tangents)};",
        f"if (likely(every({test}))) {{ {ends} }} else {{ {within} }}",
    ]

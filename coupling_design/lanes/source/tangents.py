"""Hyperbolic tangents in groups, as most of them have long come to 1 or -1.

A contact with a gap asks for two, at either edge. Both are odd, so the sign of the
deflection x tells which edge is the near one: that of |x| - p is computed, that of
|x| + p is 1 wherever the gap is wider than the reach of its edges, which does not
change from step to step. All others of a group are tested for having reached their end
at once.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import product

from coupling_design.lanes.graph.graph import Graph

Name = Callable[[int], str]


@dataclass(frozen=True)
class Edges:
    """Two tangents, of scale (x - p) and of scale (x + p)."""

    minus: int
    plus: int
    x: int
    p: int
    scale: int


@dataclass(frozen=True)
class Group:
    """Tangents that do not wait for each other: pairs of edges, and single ones."""

    pairs: tuple[Edges, ...]
    single: tuple[int, ...]


def grouped(graph: Graph, places: tuple[int, ...]) -> Group:
    """Return a group with its pairs."""
    minus = {edge: place for place in places if (edge := edge_of(graph, place, "sub"))}
    plus = {edge: place for place in places if (edge := edge_of(graph, place, "add"))}
    both = [edge for edge in minus if edge in plus]
    pairs = tuple(Edges(minus[edge], plus[edge], *edge) for edge in both)
    paired = {place for pair in pairs for place in (pair.minus, pair.plus)}
    return Group(pairs, tuple(place for place in places if place not in paired))


def edge_of(graph: Graph, place: int, kind: str) -> tuple[int, int, int] | None:
    """Return (x, p, scale) of an argument scale (x +- p), None if it is none.

    p and the scale, a positive constant, do not move.
    """
    argument = graph[graph[place].args[0]]
    if argument.kind != "mul":
        return None
    for scale, distance in (argument.args, argument.args[::-1]):
        value = graph[distance]
        if value.kind != kind or not graph.is_constant(scale):
            continue
        x, p = value.args
        if kind == "add" and not graph[x].moves:
            x, p = p, x
        if graph[x].moves and not graph[p].moves and graph[scale].number > 0:
            return x, p, scale
    return None


def group_statements(graph: Graph, group: Group, names: list[Name]) -> list[str]:
    """Return the C statements that compute a group, `names` of each vector's values.

    The test is of all lanes at once; a tangent at its end is 1 or -1 to the last bit
    either way, so lanes do not depend on each other.
    """
    pairs = [
        line
        for pair in group.pairs
        for write in (_near, _far, _either)
        for name in names
        for line in write(pair, name)
    ]
    single = [
        (name(place), name(graph[place].args[0]))
        for place, name in product(group.single, names)
    ]
    return [*pairs, *_tested(single)]


def _near(pair: Edges, name: Name) -> list[str]:
    v, x, p, scale = (name(n) for n in (pair.minus, pair.x, pair.p, pair.scale))
    return [f"const Real {v}_near = tanh_at_edge({scale} * (magnitude({x}) - {p}));"]


def _far(pair: Edges, name: Name) -> list[str]:
    v, x, p, scale = (name(n) for n in (pair.minus, pair.x, pair.p, pair.scale))
    return [
        f"Real {v}_far = splat(1);",
        f"if (!likely(every(at_end_above({scale} * {p})))) "
        f"{v}_far = tanh_beyond({scale} * (magnitude({x}) + {p}));",
    ]


def _either(pair: Edges, name: Name) -> list[str]:
    v, w, x = (name(n) for n in (pair.minus, pair.plus, pair.x))
    return [
        f"const Real {v} = by_sign({x}, -{v}_far, {v}_near);",
        f"const Real {w} = by_sign({x}, -{v}_near, {v}_far);",
    ]


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

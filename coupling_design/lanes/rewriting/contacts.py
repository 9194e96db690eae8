"""A contact with a gap, its edges smoothed, as one operation.

    x + ((x - p) tanh k (x - p) - (x + p) tanh k (x + p)) / 2

is odd in x, and with l = |x| - p it is l / (1 + exp(-2 k l)) with the sign of x, but
for what the other edge adds where the gap is narrow.
"""

from __future__ import annotations

from collections.abc import Iterator

from coupling_design.lanes.graph.algebra import Algebra
from coupling_design.lanes.graph.graph import Graph
from coupling_design.lanes.source.tangents import edge_of


def find_contacts(graph: Graph, outputs: list[int]) -> tuple[Graph, list[int]]:
    """Return the graph with such contacts as one operation each.

    Those whose tangents have other uses, as in derivatives, stay.
    """
    uses = graph.uses(outputs)
    algebra = Algebra(Graph())
    new: dict[int, int] = {}
    for place in uses:
        value = graph[place]
        contact = _contact(graph, uses, place)
        if contact is None:
            new[place] = algebra.graph.copy_of(value, new)
        else:
            x = new[contact[0]]
            pressed = algebra.graph.place("pressed", tuple(new[c] for c in contact))
            two = algebra.graph.constant(2.0)
            new[place] = algebra.apply("mul", two, algebra.apply("sub", pressed, x))
    return algebra.graph, [new[place] for place in outputs]


def _contact(
    graph: Graph, uses: dict[int, int], place: int
) -> tuple[int, int, int] | None:
    """Return (x, p, k) where a value is the difference of such products, or None."""
    if graph[place].kind != "sub":
        return None
    minus, plus = graph[place].args
    found = set(_edges(graph, uses, minus, "sub")) & set(
        _edges(graph, uses, plus, "add")
    )
    return next(iter(found), None)


def _edges(
    graph: Graph, uses: dict[int, int], place: int, kind: str
) -> Iterator[tuple[int, int, int]]:
    """Yield (x, p, k) of (x -+ p) tanh k (x -+ p), if a value is that."""
    if graph[place].kind != "mul":
        return
    for tangent, distance in (graph[place].args, graph[place].args[::-1]):
        if graph[tangent].kind == "tanh" and uses[tangent] == 1:
            edge = edge_of(graph, tangent, kind)
            if edge is not None and distance in graph[graph[tangent].args[0]].args:
                yield edge

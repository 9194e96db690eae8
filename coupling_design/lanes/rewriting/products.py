"""Gathering the factors of products, so that one exponential serves several powers.

Quotients with a common divisor become products with its inverse.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field

from coupling_design.lanes.graph.algebra import Algebra
from coupling_design.lanes.graph.graph import Graph


@dataclass
class _Factors:
    """A product's factors, above and below the line, and summands of exponents."""

    above: list[int] = field(default_factory=list)
    below: list[int] = field(default_factory=list)
    exponents: list[tuple[int, bool]] = field(default_factory=list)


def gather_products(graph: Graph, outputs: list[int]) -> tuple[Graph, list[int]]:
    """Return the graph with each product's exponentials merged into one.

    Only what is used once takes part: nothing is computed twice.
    """
    return _Gatherer(graph, outputs).run(outputs)


class _Gatherer:
    def __init__(self, graph: Graph, outputs: list[int]) -> None:
        self.old = graph
        self.uses = graph.uses(outputs)
        self.divided_by = Counter(
            graph[place].args[1] for place in self.uses if graph[place].kind == "div"
        )
        self.algebra = Algebra(Graph())
        self.new_places: dict[int, int] = {}

    def run(self, outputs: list[int]) -> tuple[Graph, list[int]]:
        """Rebuild every needed value."""
        for place in self.uses:
            self.new_places[place] = self._rebuilt(place)
        return self.algebra.graph, [self.new_places[place] for place in outputs]

    def _rebuilt(self, place: int) -> int:
        value = self.old[place]
        if not value.args:
            return self.algebra.graph.place(value.kind, (), value.number)
        if value.kind in ("mul", "div"):
            factors = _Factors()
            self._collect(place, factors, is_above=True, is_root=True)
            if len(factors.exponents) > 1 or (factors.exponents and factors.below):
                return self._product(factors)
        args = [self.new_places[arg] for arg in value.args]
        if value.kind == "log":
            return self.algebra.graph.place("log", tuple(args))
        if value.kind == "div" and self.divided_by[value.args[1]] > 1:
            one = self.algebra.graph.constant(1.0)
            inverse = self.algebra.apply("div", one, args[1])
            return self.algebra.apply("mul", args[0], inverse)
        return self.algebra.apply(value.kind, *args)

    def _collect(
        self, place: int, factors: _Factors, *, is_above: bool, is_root: bool = False
    ) -> None:
        """Add the factors of a value to those of the product it stands in."""
        value = self.old[place]
        is_open = is_root or (self.uses[place] == 1 and value.moves)
        if is_open and value.kind in ("mul", "div"):
            first, second = value.args
            self._collect(first, factors, is_above=is_above)
            self._collect(second, factors, is_above=is_above == (value.kind == "mul"))
        elif is_open and value.kind == "exp":
            factors.exponents.append((value.args[0], is_above))
        else:
            (factors.above if is_above else factors.below).append(place)

    def _product(self, factors: _Factors) -> int:
        apply = self.algebra.apply
        exponent = self.algebra.graph.constant(0.0)
        for place, is_above in factors.exponents:
            kind = "add" if is_above else "sub"
            exponent = apply(kind, exponent, self.new_places[place])
        product = apply("exp", exponent)
        for place in sorted(factors.above, key=lambda place: self.old[place].moves):
            product = apply("mul", self.new_places[place], product)
        if not factors.below:
            return product
        below, *others = (self.new_places[place] for place in factors.below)
        for place in others:
            below = apply("mul", below, place)
        return apply("div", product, below)

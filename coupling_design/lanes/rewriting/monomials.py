"""Products of several factors, ordered so that they share as many of them as they can.

Derivatives along several directions are the same slopes times other changes. Written
from left to right each direction multiplies on its own; here the slopes come first,
once.
"""

from __future__ import annotations

from collections import Counter
from itertools import combinations
from typing import Any

from coupling_design.lanes.graph.algebra import Algebra
from coupling_design.lanes.graph.graph import Graph

# A place in the old graph, ("number", value), or ("pair", factor, factor).
Factor = Any
Monomial = list[Factor]


def share_factors(graph: Graph, outputs: list[int]) -> tuple[Graph, list[int]]:
    """Return the graph with its moving products of several factors rearranged."""
    return _Sharer(graph, outputs).run(outputs)


class _Sharer:
    def __init__(self, graph: Graph, outputs: list[int]) -> None:
        self.old = graph
        self.uses = graph.uses(outputs)
        self.algebra = Algebra(Graph())
        self.new_places: dict[int, int] = {}
        self.products: dict[int, Monomial] = {}

    def run(self, outputs: list[int]) -> tuple[Graph, list[int]]:
        """Rebuild every value that is still needed."""
        needed = self._needed(outputs)
        several = [m for m in self.products.values() if _degree(m) > 1]
        _share_pairs(several)
        for place in needed:
            self.new_places[place] = self._rebuilt(place)
        return self.algebra.graph, [self.new_places[place] for place in outputs]

    def _needed(self, outputs: list[int]) -> list[int]:
        """Return what is needed, products taken apart on the way."""
        wanted = set(outputs)
        for place in sorted(self.uses, reverse=True):
            if place not in wanted:
                continue
            value = self.old[place]
            if value.kind == "mul" and value.moves:
                self.products[place] = self._factors(place)
                wanted |= {f for f in self.products[place] if isinstance(f, int)}
            else:
                wanted.update(value.args)
        return sorted(wanted)

    def _factors(self, place: int) -> Monomial:
        """Return the factors of a product, its constants as one number."""
        number, factors, left = 1.0, [], list(self.old[place].args)
        while left:
            arg = left.pop()
            value = self.old[arg]
            if value.kind == "constant":
                number *= value.number
            elif value.kind == "mul" and value.moves and self._opens(arg):
                left.extend(value.args)
            else:
                factors.append(arg)
        return [("number", number), *sorted(factors)] if number != 1.0 else factors

    def _opens(self, place: int) -> bool:
        """Return whether a product in a product is taken apart: it costs nothing."""
        args = self.old[place].args
        return self.uses[place] == 1 or any(map(self.old.is_constant, args))

    def _rebuilt(self, place: int) -> int:
        value = self.old[place]
        if place in self.products:
            return self._product(self.products[place])
        return self.algebra.graph.copy_of(value, self.new_places)

    def _product(self, factors: Monomial) -> int:
        """Return the place of a product, a number last: a sum can take that in."""
        numbers = [f for f in factors if isinstance(f, tuple) and f[0] == "number"]
        places = [self._place(f) for f in factors if f not in numbers]
        product = places[0]
        for place in places[1:]:
            product = self.algebra.apply("mul", product, place)
        for number in numbers:
            product = self.algebra.apply("mul", self._place(number), product)
        return product

    def _place(self, factor: Factor) -> int:
        if isinstance(factor, int):
            return self.new_places[factor]
        if factor[0] == "number":
            return self.algebra.graph.constant(factor[1])
        return self.algebra.apply("mul", *map(self._place, factor[1:]))


def _degree(factors: Monomial) -> int:
    return sum(isinstance(factor, int) for factor in factors)


def _share_pairs(monomials: list[Monomial]) -> None:
    """Replace the pair of factors that most have by one factor, as long as two do."""
    while True:
        count = Counter(pair for m in monomials for pair in _pairs(m))
        if not count:
            return
        pair, times = max(count.items(), key=lambda item: (item[1], str(item[0])))
        if times < 2:
            return
        for factors in monomials:
            if pair in _pairs(factors):
                for factor in pair:
                    factors.remove(factor)
                factors.append(("pair", *pair))


def _pairs(factors: Monomial) -> set[tuple[Factor, Factor]]:
    if len(factors) < 3:
        return set()
    return set(combinations(sorted(factors, key=str), 2))

"""Sums with constant factors, each written as one chain of fused multiply-adds.

Constants that follow each other become one, differences and signs disappear into the
factors, and what is known first is added first.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from coupling_design.lanes.graph.algebra import Algebra
from coupling_design.lanes.graph.graph import Graph


@dataclass
class _Sum:
    """A constant, and a factor for each value."""

    constant: float = 0.0
    factors: dict[int, float] = field(default_factory=dict)

    def add(self, other: _Sum, factor: float) -> None:
        """Add another sum times a factor."""
        self.constant += factor * other.constant
        for place, own in other.factors.items():
            self.factors[place] = self.factors.get(place, 0.0) + factor * own

    @property
    def is_one_value(self) -> bool:
        """Whether it is no more than a value times a factor."""
        return self.constant == 0.0 and len(self.factors) == 1

    @property
    def has_factors_only(self) -> bool:
        """Whether each of its values has a factor, so that another costs nothing."""
        return all(abs(factor) != 1.0 for factor in self.factors.values())


def gather_sums(graph: Graph, outputs: list[int]) -> tuple[Graph, list[int]]:
    """Return the graph with its moving sums gathered.

    A sum within a sum is taken apart where it is used nowhere else and that makes no
    sum longer to compute.
    """
    return _Gatherer(graph, outputs).run(outputs)


class _Gatherer:
    def __init__(self, graph: Graph, outputs: list[int]) -> None:
        self.old = graph
        self.uses = graph.uses(outputs)
        self.algebra = Algebra(Graph())
        self.sums: dict[int, _Sum] = {}
        self.new_places: dict[int, int] = {}

    def run(self, outputs: list[int]) -> tuple[Graph, list[int]]:
        """Rebuild every value that is still needed."""
        for place in self.uses:
            if self.old[place].moves:
                self._gather(place)
        for place in self._needed(outputs):
            self.new_places[place] = self._rebuilt(place)
        return self.algebra.graph, [self.new_places[place] for place in outputs]

    def _gather(self, place: int) -> None:
        """Note a value as a sum, if it is one."""
        value, gathered = self.old[place], _Sum()
        if value.kind == "add":
            self._include(gathered, value.args[0], 1.0)
            self._include(gathered, value.args[1], 1.0)
        elif value.kind == "sub":
            self._include(gathered, value.args[0], 1.0)
            self._include(gathered, value.args[1], -1.0)
        elif value.kind == "neg":
            self._include(gathered, value.args[0], -1.0)
        elif value.kind == "mul" and any(map(self.old.is_constant, value.args)):
            factor, other = sorted(value.args, key=self.old.is_constant, reverse=True)
            self._include(gathered, other, self.old[factor].number)
        else:
            return
        self.sums[place] = gathered

    def _include(self, gathered: _Sum, place: int, factor: float) -> None:
        """Add a value times a factor to a sum, taken apart if that pays."""
        if self.old.is_constant(place):
            gathered.constant += factor * self.old[place].number
        elif place not in self.sums:
            gathered.add(_Sum(0.0, {place: 1.0}), factor)
        elif self.sums[place].is_one_value and self.uses[place] == 1:
            ((inner, own_factor),) = self.sums[place].factors.items()
            self._include(gathered, inner, factor * own_factor)
        elif self._opens(place, factor):
            gathered.add(self.sums[place], factor)
        else:
            gathered.add(_Sum(0.0, {place: 1.0}), factor)

    def _opens(self, place: int, factor: float) -> bool:
        own = self.sums[place]
        if self.uses[place] > 1:
            return own.is_one_value
        return abs(factor) == 1.0 or own.has_factors_only

    def _needed(self, outputs: list[int]) -> list[int]:
        wanted = set(outputs)
        for place in sorted(self.uses, reverse=True):
            if place in wanted:
                gathered = self.sums.get(place)
                wanted.update(gathered.factors if gathered else self.old[place].args)
        return sorted(wanted)

    def _rebuilt(self, place: int) -> int:
        value = self.old[place]
        if place in self.sums:
            return self._chain(self.sums[place])
        return self.algebra.graph.copy_of(value, self.new_places)

    def _chain(self, gathered: _Sum) -> int:
        """Return the place of a sum, its values added in their order."""
        apply, constant = self.algebra.apply, self.algebra.graph.constant
        terms = sorted((p, f) for p, f in gathered.factors.items() if f != 0.0)
        chain = constant(gathered.constant)
        if gathered.constant == 0.0 and terms:
            # A value taken off first would have to change its sign.
            first = next((term for term in terms if term[1] != -1.0), terms[0])
            first = next((term for term in terms if term[1] == 1.0), first)
            terms.remove(first)
            chain = apply("mul", constant(first[1]), self.new_places[first[0]])
        for place, factor in terms:
            value = self.new_places[place]
            if abs(factor) == 1.0:
                chain = apply("add" if factor > 0 else "sub", chain, value)
            else:
                chain = apply("add", chain, apply("mul", constant(factor), value))
        return chain

"""A step as a graph of elementary operations, each kept once."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping

from coupling_design.lanes.graph.value import Value, known_value

_COMMUTATIVE = frozenset({"add", "mul", "fmax", "fmin", "equal", "both", "either"})


class Graph:
    """Values in an order in which each comes after its arguments.

    A value is named by its place in that order.
    """

    def __init__(self) -> None:
        self.values: list[Value] = []
        self._places: dict[tuple[object, ...], int] = {}

    def __getitem__(self, place: int) -> Value:
        """Return the value at a place."""
        return self.values[place]

    def constant(self, number: float) -> int:
        """Return the place of a constant."""
        return self.place("constant", (), number)

    def is_constant(self, place: int, number: float | None = None) -> bool:
        """Return whether a value is a constant, or that constant."""
        value = self.values[place]
        return value.kind == "constant" and number in (None, value.number)

    def args(self, place: int) -> list[Value]:
        """Return the arguments of a value."""
        return [self.values[arg] for arg in self.values[place].args]

    def place(self, kind: str, args: tuple[int, ...], number: float = 0.0) -> int:
        """Return the place of an operation, a new one if it was not there yet."""
        if kind in _COMMUTATIVE:
            args = tuple(sorted(args))
        key = (kind, args, number, math.copysign(1.0, number))
        if key not in self._places:
            known = [self.values[arg] for arg in args]
            self.values.append(known_value(kind, args, known, number))
            self._places[key] = len(self.values) - 1
        return self._places[key]

    def copy_of(self, value: Value, places: Mapping[int, int]) -> int:
        """Return the place of another graph's value; `places` of its arguments here."""
        args = tuple(places[arg] for arg in value.args)
        return self.place(value.kind, args, value.number)

    def needed(self, outputs: Iterable[int]) -> list[int]:
        """Return the places that the outputs depend on, in order."""
        wanted = set(outputs)
        for place in range(len(self.values) - 1, -1, -1):
            if place in wanted:
                wanted.update(self.values[place].args)
        return sorted(wanted)

    def uses(self, outputs: Iterable[int]) -> dict[int, int]:
        """Return how often each needed value is used, as an argument or an output."""
        outputs = list(outputs)
        count = dict.fromkeys(self.needed(outputs), 0)
        for place in (*outputs, *(a for p in count for a in self.values[p].args)):
            count[place] += 1
        return count

"""A graph's values as C expressions."""

from __future__ import annotations

import sys
from collections import Counter
from collections.abc import Callable
from functools import partial

from coupling_design.lanes.graph.graph import Graph
from coupling_design.lanes.graph.value import MASKS, Value
from coupling_design.lanes.source.order import Task
from coupling_design.lanes.source.parts import Parts
from coupling_design.lanes.source.tangents import (
    Name,
    group_statements,
    grouped,
)

_PATTERNS = {
    "add": "{0} + {1}",
    "sub": "{0} - {1}",
    "mul": "{0} * {1}",
    "div": "{0} / {1}",
    "neg": "-{0}",
    "sqrt": "root({0})",
    "fabs": "magnitude({0})",
    "sine": "{0}.sine",
    "cosine": "{0}.cosine",
}
_PAIRS = frozenset({"wave", "turned"})
VECTORS = "abcd"  # those side by side, by a letter at the end of a name
_IN_LANES_HEADER = MASKS | {"choose", "keep"}

_MODERATE = 708  # exp of a number up to this size is neither infinite nor subnormal


class Expressions:
    """C of each value, for one of the vectors that go side by side.

    Numbers are no part of it: they are called by their place in `constants`, one for
    each statement, so that two which happen to be equal make no other source.
    """

    def __init__(self, graph: Graph, outputs: list[int], parts: Parts) -> None:
        self.graph = graph
        self.constants: list[float] = []
        self._slots: dict[tuple[int, int], int] = {}
        self._numbers: dict[int, int] = {}
        self._statement = 0
        self._taken_in = _products_to_fuse(graph, outputs, parts)
        self._absent = set(self._taken_in.values())

    def name(self, place: int, vector: int) -> str:
        """Return how C calls a value."""
        value = self.graph[place]
        if value.kind == "constant":
            return self._constant(place, value.number)
        number = self._numbers.setdefault(place, len(self._numbers))
        letter = VECTORS[0 if value.is_shared else vector]
        return f"{'m' if value.kind in MASKS else 'v'}{number}{letter}"

    def statements(self, task: Task, vectors: range) -> list[str]:
        """Return the C statements that compute a value, or a group of tangents."""
        self._statement = task[0]
        value = self.graph[task[0]]
        if value.kind == "tanh":
            names: list[Name] = [partial(self.name, vector=v) for v in vectors]
            return group_statements(self.graph, grouped(self.graph, task), names)
        if value.kind == "constant" or task[0] in self._absent:
            return []
        kind = "Mask" if value.kind in MASKS else "Real"
        kind = "Wave" if value.kind in _PAIRS else kind
        return [
            f"const {kind} {self.name(task[0], vector)} = "
            f"{self._expression(task[0], vector)};"
            for vector in (vectors[:1] if value.is_shared else vectors)
        ]

    def _expression(self, place: int, vector: int) -> str:
        value = self.graph[place]
        if value.kind == "state":
            return f"s{int(value.number)}{VECTORS[vector]}"
        if value.kind == "parameter":
            row = f"parameters + {int(value.number)} * stride"
            return f"load({row} + {vector} * LANES)"

        def name(place: int) -> str:
            return self.name(place, vector)

        if value.kind in ("add", "sub"):
            product = self._taken_in.get(place)
            if product is not None:
                return self._fused_expression(value, product, name)
        names = [name(arg) for arg in value.args]
        if value.kind in ("fmax", "fmin"):
            return self._extreme(value, names)
        if value.kind in _PATTERNS:
            return _PATTERNS[value.kind].format(*names)
        if value.kind in ("exp", "log"):
            return f"{self._variant(value)}({names[0]})"
        prefix = "" if value.kind in _IN_LANES_HEADER else "lane_"
        return f"{prefix}{value.kind}({', '.join(names)})"

    def _variant(self, value: Value) -> str:
        """Return the function that does for what is known of the argument."""
        argument = self.graph[value.args[0]]
        if value.kind == "log":
            is_normal = argument.lower >= sys.float_info.min
            return "lane_log_of_normal" if is_normal else "lane_log"
        is_moderate = argument.lower >= -_MODERATE and argument.upper <= _MODERATE
        return "lane_exp_of_moderate" if is_moderate else "lane_exp"

    def _extreme(self, value: Value, names: list[str]) -> str:
        """Return the larger or smaller of two; a constant first, it is never NaN."""
        if self.graph.is_constant(value.args[1]):
            names.reverse()
        elif not self.graph.is_constant(value.args[0]):
            return f"lane_{value.kind}({', '.join(names)})"
        return f"{'larger' if value.kind == 'fmax' else 'smaller'}({', '.join(names)})"

    def _fused_expression(
        self, value: Value, product: int, name: Callable[[int], str]
    ) -> str:
        left, right = value.args
        a, b = (name(arg) for arg in self.graph[product].args)
        if product == left:
            return f"fused({a}, {b}, {'-' if value.kind == 'sub' else ''}{name(right)})"
        return f"fused({'-' if value.kind == 'sub' else ''}{a}, {b}, {name(left)})"

    def _constant(self, place: int, number: float) -> str:
        if number in (0.0, 1.0, -1.0, 2.0, 0.5):
            return f"splat({number})"
        slot = self._slots.setdefault((self._statement, place), len(self.constants))
        if slot == len(self.constants):
            self.constants.append(number)
        return f"splat(constants[{slot}])"


def _products_to_fuse(graph: Graph, outputs: list[int], parts: Parts) -> dict[int, int]:
    """Return the product that each sum takes in, by the sum's place.

    A product is taken in by all that use it, sums of its own part, or by none.
    """
    uses, taken = graph.uses(outputs), {}
    for part in (parts.motion, parts.effects, parts.adding):
        members = set(part)
        for place in part:
            if graph[place].kind not in ("add", "sub"):
                continue
            products = [
                arg
                for arg in sorted(set(graph[place].args), reverse=True)
                if arg in members and graph[arg].kind == "mul"
            ]
            if products:
                taken[place] = min(products, key=lambda product: uses[product])
    times = Counter(taken.values())
    return {
        p: product for p, product in taken.items() if times[product] == uses[product]
    }

"""Operations on a graph's values, simplified as they are written down.

What is done rounds a few times more or less than the original, never worse:
a division by what stays the same becomes a product with its inverse, powers become
logarithms and exponentials where the base is known to be positive, and the logarithm of
a product becomes a sum, so that one logarithm serves several powers.
"""

from __future__ import annotations

import math
from collections.abc import Callable

from coupling_design.lanes.graph.graph import Graph
from coupling_design.lanes.graph.value import MASKS

_CONNECTIVES = ("not", "both", "either")
_LARGEST_WHOLE_POWER = 16


class Algebra:
    """Writes operations into a graph."""

    def __init__(self, graph: Graph) -> None:
        self.graph = graph

    def apply(self, kind: str, *args: int) -> int:
        """Return the place of an operation's value, simplified."""
        args = tuple(self._fitting(arg, kind, i) for i, arg in enumerate(args))
        folded = self._fold(kind, args)
        if folded is not None:
            return self.graph.constant(folded)
        rule: Callable[..., int | None] | None = getattr(self, f"_{kind}", None)
        simpler = rule(*args) if rule else None
        return self.graph.place(kind, args) if simpler is None else simpler

    def power(self, base: int, exponent: int) -> int:
        """Return base to the power of exponent."""
        graph = self.graph
        if graph.is_constant(exponent):
            number = graph[exponent].number
            if number == int(number) and abs(number) <= _LARGEST_WHOLE_POWER:
                return self._whole_power(base, int(number))
            if number == 0.5:
                return self.apply("sqrt", base)
        if graph[base].is_positive or (
            graph.is_constant(exponent) and not graph[exponent].number.is_integer()
        ):
            return self.apply("exp", self.apply("mul", exponent, self.log(base)))
        return graph.place("pow", (base, exponent))

    def log(self, place: int) -> int:
        """Return the logarithm, taken apart where that needs no more of them."""
        graph, value = self.graph, self.graph[place]
        if value.kind == "exp":
            return value.args[0]
        if graph.is_constant(place) and value.number > 0:
            return graph.constant(math.log(value.number))
        if not value.is_positive or not self._comes_apart(place):
            return graph.place("log", (place,))
        if value.kind == "sqrt":
            return self.apply("mul", graph.constant(0.5), self.log(value.args[0]))
        if value.kind == "choose":
            condition, a, b = value.args
            return self.apply("choose", condition, self.log(a), self.log(b))
        outer = {"mul": "add", "div": "sub"}.get(value.kind, value.kind)
        return self.apply(outer, *(self.log(arg) for arg in value.args))

    def _comes_apart(self, place: int) -> bool:
        """Return whether log of a value is made of at most one logarithm."""
        value = self.graph[place]
        if value.kind == "sqrt":
            return self.graph[value.args[0]].is_positive
        if value.kind not in ("mul", "div", "fmax", "fmin", "choose"):
            return False
        factors = value.args[1:] if value.kind == "choose" else value.args
        if not all(self.graph[factor].is_positive for factor in factors):
            return False
        free = [self._has_free_log(factor) for factor in factors]
        return all(free) if value.kind == "choose" else any(free)

    def _has_free_log(self, place: int) -> bool:
        value = self.graph[place]
        if not value.is_positive:
            return False
        if value.kind in ("constant", "exp"):
            return True
        if value.kind in ("mul", "div", "fmax", "fmin", "sqrt"):
            return all(self._has_free_log(arg) for arg in value.args)
        if value.kind == "choose":
            return all(self._has_free_log(arg) for arg in value.args[1:])
        return False

    def _whole_power(self, base: int, exponent: int) -> int:
        if exponent < 0:
            power = self._whole_power(base, -exponent)
            return self.apply("div", self.graph.constant(1.0), power)
        if exponent == 0:
            return self.graph.constant(1.0)
        half = self._whole_power(base, exponent // 2) if exponent > 1 else None
        if half is None:
            return base
        square = self.apply("mul", half, half)
        return self.apply("mul", square, base) if exponent % 2 else square

    def number(self, place: int) -> int:
        """Return a yes or no as 1 or 0, a number as it is."""
        if self.graph[place].kind not in MASKS:
            return place
        return self.graph.place("keep", (place, self.graph.constant(1.0)))

    def _fitting(self, arg: int, kind: str, position: int) -> int:
        """Return an argument as the operation wants it, a number or a yes or no."""
        if kind == "mul":
            return arg
        if kind in _CONNECTIVES or (kind in ("choose", "keep") and position == 0):
            if self.graph[arg].kind in MASKS:
                return arg
            is_zero = self.apply("equal", arg, self.graph.constant(0.0))
            return self.graph.place("not", (is_zero,))
        return self.number(arg)

    def _fold(self, kind: str, args: tuple[int, ...]) -> float | None:
        """Return the value of an operation on constants, if it is finite."""
        if kind not in _OF_NUMBERS or not all(map(self.graph.is_constant, args)):
            return None
        try:
            result = _OF_NUMBERS[kind](*(self.graph[arg].number for arg in args))
        except (ArithmeticError, ValueError):
            return None
        return result if math.isfinite(result) else None

    def _add(self, a: int, b: int) -> int | None:
        for one, other in ((a, b), (b, a)):
            if self.graph.is_constant(one, 0.0):
                return other
            if self._is_opposite(one, other):
                (condition, if_true), if_false = (
                    self.graph[one].args,
                    self.graph[other].args[1],
                )
                return self.apply("choose", condition, if_true, if_false)
        return None

    def _is_opposite(self, one: int, other: int) -> bool:
        """Return whether one is kept where, and only where, the other is not."""
        if not self.graph[one].kind == self.graph[other].kind == "keep":
            return False
        negation = self.graph[self.graph[other].args[0]]
        return negation.kind == "not" and negation.args[0] == self.graph[one].args[0]

    def _sub(self, a: int, b: int) -> int | None:
        if self.graph.is_constant(b, 0.0):
            return a
        return self.apply("neg", b) if self.graph.is_constant(a, 0.0) else None

    def _neg(self, a: int) -> int | None:
        return self.graph[a].args[0] if self.graph[a].kind == "neg" else None

    def _mul(self, a: int, b: int) -> int | None:
        for one, other in ((a, b), (b, a)):
            if self.graph[one].kind in MASKS:
                return self.apply("keep", one, self.number(other))
            if self.graph.is_constant(one, 1.0):
                return other
            if self.graph.is_constant(one, -1.0):
                return self.apply("neg", other)
        return None

    def _div(self, a: int, b: int) -> int | None:
        if self.graph.is_constant(b, 1.0):
            return a
        if self.graph[b].moves or (
            self.graph.is_constant(b) and self.graph[b].number == 0
        ):
            return None
        one = self.graph.constant(1.0)
        return None if a == one else self.apply("mul", a, self.apply("div", one, b))

    def _keep(self, condition: int, a: int) -> int | None:
        is_zero = self.graph.is_constant(a, 0.0)
        return a if is_zero else None

    def _choose(self, _: int, a: int, b: int) -> int | None:
        return a if a == b else None

    def _exp(self, a: int) -> int | None:
        return self.graph[a].args[0] if self.graph[a].kind == "log" else None

    def _fmax(self, a: int, b: int) -> int | None:
        if self.graph[a].lower >= self.graph[b].upper or a == b:
            return a
        return b if self.graph[b].lower >= self.graph[a].upper else None

    def _fmin(self, a: int, b: int) -> int | None:
        if self.graph[a].upper <= self.graph[b].lower or a == b:
            return a
        return b if self.graph[b].upper <= self.graph[a].lower else None

    def _less(self, a: int, b: int) -> int | None:
        return self._compare_logs("less", a, b)

    def _less_equal(self, a: int, b: int) -> int | None:
        return self._compare_logs("less_equal", a, b)

    def _compare_logs(self, kind: str, a: int, b: int) -> int | None:
        """Compare the logarithms where they are known anyway, the values not yet."""
        if not all(map(self._has_free_log, (a, b))):
            return None
        if self.graph.is_constant(a) and self.graph.is_constant(b):
            return None
        return self.graph.place(kind, (self.log(a), self.log(b)))


_OF_NUMBERS: dict[str, Callable[..., float]] = {
    "add": lambda a, b: a + b,
    "sub": lambda a, b: a - b,
    "mul": lambda a, b: a * b,
    "div": lambda a, b: a / b,
    "neg": lambda a: -a,
    "exp": math.exp,
    "log": math.log,
    "sqrt": math.sqrt,
    "fabs": abs,
    "fmax": max,
    "fmin": min,
}

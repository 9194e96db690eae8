"""Writing a graph as C: one function that takes many steps, for any number of lanes."""

from __future__ import annotations

import sys
from dataclasses import dataclass, field

from coupling_design.rollout.compiled.graph import Graph
from coupling_design.rollout.compiled.value import MASKS, Value

_PATTERNS = {
    "add": "{0} + {1}",
    "sub": "{0} - {1}",
    "mul": "{0} * {1}",
    "div": "{0} / {1}",
    "neg": "-{0}",
    "sqrt": "root({0})",
    "fabs": "magnitude({0})",
}
_IN_LANES_HEADER = MASKS | {"choose", "keep"}

_MODERATE = 708  # exp of a number up to this size is neither infinite nor subnormal

_FUNCTION = """
void march_lanes(int64_t n_steps, int64_t stride, const double *constants,
                 const double *parameters, const double *states, double *ends)
{{
{before}
    for (int64_t step = 0; step < n_steps; ++step) {{
{inside}
    }}
{after}
}}
"""


@dataclass
class Kernel:
    """C of a march, and the constants it is called with.

    Numbers are no part of the source, so that a step with other numbers finds its
    machine code ready.
    """

    source: str
    constants: list[float] = field(default_factory=list)


def write_kernel(graph: Graph, outputs: list[int]) -> Kernel:
    """Return the C function that repeats a step.

    Values that do not move are computed once, before the first step.
    """
    writer = _Writer(graph, outputs)
    before = [f"Real s{i} = load(states + {i} * stride);" for i in range(len(outputs))]
    inside: list[str] = []
    for place in writer.order:
        line = writer.statement(place)
        if line:
            (inside if graph[place].moves else before).append(line)
    inside += [f"s{i} = {writer.name(place)};" for i, place in enumerate(outputs)]
    after = [f"store(ends + {i} * stride, s{i});" for i in range(len(outputs))]
    source = _FUNCTION.format(
        before=_indent(before, 4), inside=_indent(inside, 8), after=_indent(after, 4)
    )
    return Kernel(source, writer.constants)


class _Writer:
    def __init__(self, graph: Graph, outputs: list[int]) -> None:
        self.graph = graph
        self.order = graph.needed(outputs)
        self.uses = graph.uses(outputs)
        self.constants: list[float] = []
        self._names: dict[int, str] = {}
        self._fused = self._products_to_fuse()

    def name(self, place: int) -> str:
        """Return how C calls a value."""
        value = self.graph[place]
        if value.kind == "constant":
            return self._constant(value.number)
        return f"{'m' if value.kind in MASKS else 'v'}{place}"

    def statement(self, place: int) -> str:
        """Return the C statement that computes a value, or nothing."""
        value = self.graph[place]
        if value.kind == "constant" or place in self._fused:
            return ""
        kind = "Mask" if value.kind in MASKS else "Real"
        return f"const {kind} {self.name(place)} = {self._expression(value)};"

    def _expression(self, value: Value) -> str:
        if value.kind == "state":
            return f"s{int(value.number)}"
        if value.kind == "parameter":
            return f"load(parameters + {int(value.number)} * stride)"
        if value.kind in ("add", "sub"):
            fused = self._fused_expression(value)
            if fused:
                return fused
        names = [self.name(arg) for arg in value.args]
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

    def _products_to_fuse(self) -> dict[int, int]:
        """Return the products used once, in a sum, and the sum they are used in."""
        fused: dict[int, int] = {}
        for place in self.order:
            value = self.graph[place]
            if value.kind in ("add", "sub"):
                for arg in sorted(value.args, reverse=True):
                    product = self.graph[arg]
                    once = self.uses[arg] == 1 and product.moves
                    if product.kind == "mul" and once:
                        fused[arg] = place
                        break
        return fused

    def _fused_expression(self, value: Value) -> str:
        left, right = value.args
        minus = "-" if value.kind == "sub" else ""
        if left in self._fused and left != right:
            a, b = (self.name(arg) for arg in self.graph[left].args)
            return f"fused({a}, {b}, {minus}{self.name(right)})"
        if right in self._fused and left != right:
            a, b = (self.name(arg) for arg in self.graph[right].args)
            return f"fused({minus}{a}, {b}, {self.name(left)})"
        return ""

    def _constant(self, number: float) -> str:
        if number in (0.0, 1.0, -1.0, 2.0, 0.5):
            return f"splat({number})"
        if number not in self.constants:
            self.constants.append(number)
        return f"splat(constants[{self.constants.index(number)}])"


def _indent(lines: list[str], by: int) -> str:
    return "\n".join(" " * by + line for line in lines)

"""A graph back as a CasADi function."""

from __future__ import annotations

from collections.abc import Callable

import casadi as ca

from coupling_design.arithmetic import Scalar
from coupling_design.lanes.graph.graph import Graph
from coupling_design.lanes.graph.instructions import UnknownOperationError, read_step
from coupling_design.lanes.rewriting.products import gather_products

_OF_SYMBOLS: dict[str, Callable[..., Scalar]] = {
    "add": lambda a, b: a + b,
    "sub": lambda a, b: a - b,
    "mul": lambda a, b: a * b,
    "div": lambda a, b: a / b,
    "neg": lambda a: -a,
    "pow": lambda a, b: a**b,
    "less": lambda a, b: a < b,
    "less_equal": lambda a, b: a <= b,
    "equal": lambda a, b: a == b,
    "not": ca.logic_not,
    "both": ca.logic_and,
    "either": ca.logic_or,
    "choose": ca.if_else,
    "keep": lambda condition, a: ca.if_else(condition, a, 0),
}


def with_shared_powers(step: ca.Function) -> ca.Function:
    """Return a step with its powers written through logarithms they share.

    The same up to rounding, and cheaper to differentiate: the derivative of an
    exponential is that exponential, that of a power is another power. A step that
    cannot be read is returned as it is.
    """
    try:
        graph, outputs = gather_products(*read_step(step))
    except UnknownOperationError:
        return step
    state = ca.SX.sym("state", step.size1_in(0))
    parameters = ca.SX.sym("parameters", step.size1_in(1))
    inputs = {"state": state, "parameter": parameters}
    symbols: dict[int, Scalar] = {}
    for place in graph.needed(outputs):
        symbols[place] = _symbol(graph, place, inputs, symbols)
    return ca.Function(
        step.name(),
        [state, parameters],
        [ca.vertcat(*(symbols[place] for place in outputs))],
        ["state", "parameters"],
        ["state_next"],
    )


def _symbol(
    graph: Graph, place: int, inputs: dict[str, ca.SX], symbols: dict[int, Scalar]
) -> Scalar:
    value = graph[place]
    if value.kind == "constant":
        return ca.SX(value.number)
    if value.kind in inputs:
        return inputs[value.kind][int(value.number)]
    operation = _OF_SYMBOLS.get(value.kind) or getattr(ca, value.kind)
    return operation(*(symbols[arg] for arg in value.args))

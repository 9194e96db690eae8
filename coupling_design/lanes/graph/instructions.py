"""Reading a CasADi function's instructions into a graph."""

from __future__ import annotations

import casadi as ca

from coupling_design.lanes.graph.algebra import Algebra
from coupling_design.lanes.graph.graph import Graph

# CasADi's operations by our names; those with rules of their own are in `_operate`.
_KINDS = {
    ca.OP_ADD: "add",
    ca.OP_SUB: "sub",
    ca.OP_MUL: "mul",
    ca.OP_DIV: "div",
    ca.OP_NEG: "neg",
    ca.OP_EXP: "exp",
    ca.OP_SQRT: "sqrt",
    ca.OP_SIN: "sin",
    ca.OP_COS: "cos",
    ca.OP_TANH: "tanh",
    ca.OP_FABS: "fabs",
    ca.OP_SIGN: "sign",
    ca.OP_FMAX: "fmax",
    ca.OP_FMIN: "fmin",
    ca.OP_LT: "less",
    ca.OP_LE: "less_equal",
    ca.OP_EQ: "equal",
    ca.OP_NOT: "not",
    ca.OP_AND: "both",
    ca.OP_OR: "either",
    ca.OP_IF_ELSE_ZERO: "keep",
}
_NAMES = {
    getattr(ca, name): name[3:].lower() for name in dir(ca) if name.startswith("OP_")
}


class UnknownOperationError(Exception):
    """A step holds an operation that has no machine code here."""


def read_step(step: ca.Function) -> tuple[Graph, list[int]]:
    """Return the graph of a step and the places of the next state's entries."""
    step = _scalar_and_dense(step)
    graph = Graph()
    algebra = Algebra(graph)
    places: dict[int, int] = {}
    outputs = [graph.constant(0.0)] * step.nnz_out(0)
    for i in range(step.n_instructions()):
        operation, args = step.instruction_id(i), step.instruction_input(i)
        result = step.instruction_output(i)
        if operation == ca.OP_OUTPUT:
            outputs[result[1]] = algebra.number(places[args[0]])
        elif operation == ca.OP_INPUT:
            kind = ("state", "parameter")[args[0]]
            places[result[0]] = graph.place(kind, (), args[1])
        elif operation == ca.OP_CONST:
            places[result[0]] = graph.constant(step.instruction_constant(i))
        else:
            places[result[0]] = _operate(
                algebra, operation, [places[arg] for arg in args]
            )
    return graph, outputs


def _scalar_and_dense(step: ca.Function) -> ca.Function:
    """Return a step of scalar operations in which every entry has its place."""
    if step.is_a("SXFunction") and step.sparsity_out(0).is_dense():
        return step
    state = ca.SX.sym("state", step.size1_in(0))
    parameters = ca.SX.sym("parameters", step.size1_in(1))
    state_next = ca.densify(step(state, parameters))
    return ca.Function("dense_step", [state, parameters], [state_next])


def _operate(algebra: Algebra, operation: int, args: list[int]) -> int:
    graph = algebra.graph
    if operation in (ca.OP_POW, ca.OP_CONSTPOW):
        return algebra.power(*args)
    if operation == ca.OP_SQ:
        return algebra.apply("mul", args[0], args[0])
    if operation == ca.OP_TWICE:
        return algebra.apply("mul", graph.constant(2.0), args[0])
    if operation == ca.OP_INV:
        return algebra.apply("div", graph.constant(1.0), args[0])
    if operation == ca.OP_LOG:
        return algebra.log(args[0])
    if operation == ca.OP_NE:
        return algebra.apply("not", algebra.apply("equal", *args))
    if operation not in _KINDS:
        name = _NAMES.get(operation, str(operation))
        raise UnknownOperationError(f"no machine code for the operation {name}")
    return algebra.apply(_KINDS[operation], *args)

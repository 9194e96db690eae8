"""Kernels of steps, as written once and kept in the user's cache directory.

To read a step and rewrite it takes some hundredths of a second, to load what came of it
next to none.
"""

from __future__ import annotations

import contextlib
import json
from functools import lru_cache
from importlib import resources
from importlib.metadata import version

import casadi as ca

from coupling_design import lanes
from coupling_design.lanes import graph, rewriting, source
from coupling_design.lanes.graph.instructions import read_step
from coupling_design.lanes.rewriting.contacts import find_contacts
from coupling_design.lanes.rewriting.harmonics import share_harmonics
from coupling_design.lanes.rewriting.monomials import share_factors
from coupling_design.lanes.rewriting.products import gather_products
from coupling_design.lanes.rewriting.sums import gather_sums
from coupling_design.lanes.source.kernel import Kernel, write_kernel
from coupling_design.lanes.store import digest, load_text, save_text

_REWRITING = (
    gather_products,
    share_harmonics,
    find_contacts,
    share_factors,
    gather_sums,
)


def kernel_of(step: ca.Function) -> Kernel:
    """Return the kernel of a step, from the cache or written now.

    Raises UnknownOperationError if a step holds what has no machine code.
    """
    key = digest("\0".join([_writers(), step.serialize()]).encode())
    stored = load_text(key)
    if stored is not None:
        with contextlib.suppress(ValueError, TypeError):
            return Kernel(**json.loads(stored))
    kernel = _written(step)
    save_text(key, json.dumps({"source": kernel.source, "constants": kernel.constants}))
    return kernel


def _written(step: ca.Function) -> Kernel:
    operations, outputs = read_step(step)
    for rewrite in _REWRITING:
        operations, outputs = rewrite(operations, outputs)
    return write_kernel(operations, outputs)


@lru_cache(maxsize=1)
def _writers() -> str:
    """Return what a kernel depends on besides the step: who wrote it."""
    modules = sorted(
        (f"{package.__name__}.{entry.name}", entry.read_text(encoding="utf-8"))
        for package in (lanes, graph, rewriting, source)
        for entry in resources.files(package).iterdir()
        if entry.name.endswith(".py")
    )
    return "\0".join([version("casadi"), *(text for _, text in modules)])

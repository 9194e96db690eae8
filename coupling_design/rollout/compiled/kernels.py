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

from coupling_design.rollout.compiled.contacts import find_contacts
from coupling_design.rollout.compiled.harmonics import share_harmonics
from coupling_design.rollout.compiled.monomials import share_factors
from coupling_design.rollout.compiled.products import gather_products
from coupling_design.rollout.compiled.reading import read_step
from coupling_design.rollout.compiled.store import digest, load_text, save_text
from coupling_design.rollout.compiled.sums import gather_sums
from coupling_design.rollout.compiled.writing import Kernel, write_kernel

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
    graph, outputs = read_step(step)
    for rewrite in _REWRITING:
        graph, outputs = rewrite(graph, outputs)
    return write_kernel(graph, outputs)


@lru_cache(maxsize=1)
def _writers() -> str:
    """Return what a kernel depends on besides the step: who wrote it."""
    modules = sorted(
        (entry.name, entry.read_text(encoding="utf-8"))
        for entry in resources.files(__package__).iterdir()
        if entry.name.endswith(".py")
    )
    return "\0".join([version("casadi"), *(text for _, text in modules)])

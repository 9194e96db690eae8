"""Marching many columns of states at once, with whatever engine there is."""

from __future__ import annotations

import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import casadi as ca
import numpy as np

from coupling_design.arithmetic import FloatArray
from coupling_design.march.record import record
from coupling_design.march.tower import march

Batch = Callable[[FloatArray, FloatArray, int | None], FloatArray]
Column = Callable[[FloatArray, FloatArray], FloatArray]


@dataclass(frozen=True)
class Marcher:
    """A step applied many times to every column of a batch.

    Called with states (n, b) and parameters (m, b), returns the states at the end
    (n, b), column by column in their order, whatever the batch and the threads: as
    many as there are processors if not given. `record` takes one column and returns its
    states at the start of every step, (n, n_steps). `engine` says in words what does
    the work.
    """

    run: Batch
    record: Column
    engine: str
    is_compiled: bool = False

    def __call__(
        self, states: FloatArray, parameters: FloatArray, threads: int | None = None
    ) -> FloatArray:
        """Return the states at the end (n, b)."""
        return self.run(states, parameters, threads)


def virtual_machine_marcher(step: ca.Function, n_steps: int) -> Marcher:
    """Return a marcher on CasADi's virtual machine, one column after another.

    Raises ValueError if there is not at least one step.
    """
    function = march(step, n_steps)

    def one(column: tuple[FloatArray, FloatArray]) -> FloatArray:
        return np.asarray(function(*column), dtype=np.float64).ravel()

    def run(
        states: FloatArray, parameters: FloatArray, threads: int | None
    ) -> FloatArray:
        columns = list(zip(states.T, parameters.T, strict=True))
        # CasADi lets go of Python's lock while it evaluates: threads do help.
        with ThreadPoolExecutor(threads or os.cpu_count()) as pool:
            return np.stack(list(pool.map(one, columns)), axis=1)

    def recorded(states: FloatArray, parameters: FloatArray) -> FloatArray:
        return record(step, n_steps, states, parameters)

    return Marcher(run, recorded, "CasADi's virtual machine")

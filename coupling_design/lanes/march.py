"""A march as machine code.

>>> march = compile_march(step, 120_000)          # doctest: +SKIP
>>> ends = march(states, parameters)              # (n, batch), (m, batch) -> (n, batch)
"""

from __future__ import annotations

import contextlib
import ctypes
import os
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass
from functools import lru_cache
from importlib import resources

import casadi as ca
import numpy as np

from coupling_design.arithmetic import FloatArray
from coupling_design.lanes import source
from coupling_design.lanes.compiler import (
    Compiler,
    CompilerError,
    find_compiler,
)
from coupling_design.lanes.graph.instructions import UnknownOperationError
from coupling_design.lanes.kernels import kernel_of
from coupling_design.lanes.source.kernel import Kernel
from coupling_design.lanes.store import load_library

_DOUBLES = ctypes.POINTER(ctypes.c_double)


@dataclass(frozen=True)
class NotCompiled:
    """Why there is no machine code, in one line."""

    reason: str


@dataclass(frozen=True)
class CompiledMarch:
    """A step applied many times to every column of a batch.

    A column's result is the same to the last bit whatever the batch, its place in it
    and the number of threads. A column that leaves finite numbers ends as infinity or
    NaN, the others are not touched by it.
    """

    kernel: Kernel
    compiler: Compiler
    n_states: int
    n_parameters: int
    n_steps: int

    def __call__(
        self, states: FloatArray, parameters: FloatArray, threads: int | None = None
    ) -> FloatArray:
        """Return the states at the end.

        Parameters
        ----------
        states : at the start, shape (n, batch)
        parameters : shape (m, batch)
        threads : as many as there are processors if not given

        Returns
        -------
        states after n_steps, shape (n, batch)
        """
        self._check(states, parameters)
        library, batch = self._library(), states.shape[1]
        threads = threads or os.cpu_count() or 1
        width = min(_width(library), max(-(-batch // threads), 1))
        ends = np.empty(states.shape)

        def block(first: int) -> None:
            columns = slice(first, first + width)
            ends[:, columns] = _march_block(
                library, self, states[:, columns], parameters[:, columns]
            )

        firsts = range(0, batch, width)
        if len(firsts) == 1:
            block(0)
            return ends
        with ThreadPoolExecutor(threads) as pool:
            list(pool.map(block, firsts))
        return ends

    def record(self, states: FloatArray, parameters: FloatArray) -> FloatArray:
        """Return the states at the start of every step, shape (n, n_steps).

        The march is that of a column alone: states (n, 1), parameters (m, 1).
        """
        self._check(states, parameters)
        history = np.empty((self.n_states, self.n_steps))
        _march_block(self._library(), self, states, parameters, history)
        return history

    def _check(self, states: FloatArray, parameters: FloatArray) -> None:
        expected = (self.n_states, self.n_parameters)
        is_batch = states.ndim == parameters.ndim == 2
        if not is_batch or (len(states), len(parameters)) != expected:
            raise ValueError(
                f"expected states ({self.n_states}, batch) and parameters "
                f"({self.n_parameters}, batch), not {states.shape} and "
                f"{parameters.shape}"
            )
        if states.shape[1] != parameters.shape[1]:
            raise ValueError("as many columns of states as of parameters are needed")

    def _library(self) -> ctypes.CDLL:
        return _load(self.kernel.source, self.compiler)


def compile_march(step: ca.Function, n_steps: int) -> CompiledMarch | NotCompiled:
    """Return the march of a step as machine code, or why there is none.

    Parameters
    ----------
    step : function (state, parameters) -> state
    n_steps : at least 1
    """
    if n_steps < 1:
        raise ValueError(f"a march needs at least one step, not {n_steps}")
    try:
        compiler = find_compiler()
        kernel = kernel_of(step)
        march = CompiledMarch(
            kernel, compiler, step.size1_in(0), step.size1_in(1), n_steps
        )
        march._library()
    except (CompilerError, UnknownOperationError) as error:
        return NotCompiled(str(error))
    return march


def start_compiling(step: ca.Function) -> None:
    """Have the machine code of a step made while something else is done."""
    with contextlib.suppress(CompilerError, UnknownOperationError):
        compiler = find_compiler()
        _loading(kernel_of(step).source, compiler)


def _march_block(
    library: ctypes.CDLL,
    march: CompiledMarch,
    states: FloatArray,
    parameters: FloatArray,
    history: FloatArray | None = None,
) -> FloatArray:
    """Return the ends of as many columns as a call takes, at most."""
    width, widest = states.shape[1], _width(library)
    states, parameters = _padded(states, widest), _padded(parameters, widest)
    constants = np.array(march.kernel.constants, np.float64)
    ends = np.empty_like(states)
    arrays = (constants, parameters, states, ends)
    library.march(
        *(ctypes.c_int64(number) for number in (march.n_steps, width, widest)),
        *(array.ctypes.data_as(_DOUBLES) for array in arrays),
        None if history is None else history.ctypes.data_as(_DOUBLES),
    )
    return ends[:, :width]


def _width(library: ctypes.CDLL) -> int:
    """Return how many columns one call takes."""
    return ctypes.c_int.in_dll(library, "march_width").value


def _padded(columns: FloatArray, width: int) -> FloatArray:
    """Return as many columns, row after row, the last one repeated."""
    missing = width - columns.shape[1]
    padded = np.pad(columns, ((0, 0), (0, missing)), mode="edge")
    return np.ascontiguousarray(padded, dtype=np.float64)


def _load(source: str, compiler: Compiler) -> ctypes.CDLL:
    """Return the library of a kernel, or raise CompilerError."""
    return _loading(source, compiler).result()


@lru_cache(maxsize=64)
def _loading(text: str, compiler: Compiler) -> Future[ctypes.CDLL]:
    """Return the library of a kernel as soon as there is one.

    The compiler is a process of its own: several may be at work.
    """
    headers = [_header("lanes.h"), _header("elementary.h")]
    return _pool().submit(load_library, "\n".join([*headers, text]), compiler)


@lru_cache(maxsize=1)
def _pool() -> ThreadPoolExecutor:
    return ThreadPoolExecutor(os.cpu_count(), "compiling")


@lru_cache(maxsize=2)
def _header(name: str) -> str:
    return (resources.files(source) / name).read_text(encoding="utf-8")

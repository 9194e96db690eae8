"""The peers in C and numba, called like a march: (starts, points) -> ends."""

from __future__ import annotations

import ctypes
import importlib.util
import subprocess
import tempfile
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np

from coupling_design.arithmetic import FloatArray
from coupling_design.lanes.compiler import find_compiler

March = Callable[[FloatArray, FloatArray], FloatArray]

PEERS = Path(__file__).parent / "peers"
_BLOCK = 16  # designs, of SIMD C
FLAGS = ("-O3", "-march=native", "-ffast-math", "-shared", "-fPIC")


def _library(name: str) -> ctypes.CDLL:
    with tempfile.TemporaryDirectory() as directory:
        library = Path(directory) / "peer.so"
        source = str(PEERS / f"{name}.c")
        command = [*find_compiler().command, *FLAGS, source, "-o", str(library), "-lm"]
        subprocess.run(command, check=True)
        return ctypes.CDLL(str(library))


def _pointer(array: FloatArray) -> ctypes.c_void_p:
    return ctypes.c_void_p(array.ctypes.data)


def scalar_c(machine: FloatArray, n_steps: int) -> March:
    """Return the hand-written scalar C, one column after another."""
    library = _library("scalar")

    def one(start: FloatArray, point: FloatArray) -> FloatArray:
        state = start.copy()
        library.march_scalar(
            _pointer(machine),
            ctypes.c_int64(n_steps),
            *(ctypes.c_double(value) for value in point),
            _pointer(state),
        )
        return state

    return _by_columns(one)


def simd_c(machine: FloatArray, n_steps: int) -> March:
    """Return SIMD C by hand (AVX-512 or AVX2); the batch in whole blocks of 16."""
    library = _library("simd")

    def march(starts: FloatArray, points: FloatArray) -> FloatArray:
        starts, points = np.ascontiguousarray(starts), np.ascontiguousarray(points)
        ends = np.empty_like(starts)
        library.march_simd(
            _pointer(machine),
            ctypes.c_int64(n_steps),
            ctypes.c_int64(starts.shape[1]),
            *(_pointer(array) for array in (points[0], points[1], starts, ends)),
        )
        return ends

    return march


def by_threads(march: March) -> Callable[[FloatArray, FloatArray, int], FloatArray]:
    """Return a march by a number of threads: ctypes lets go of Python's lock.

    They take the batch a few blocks at a time, so that none waits long for another.
    """

    def march_by(starts: FloatArray, points: FloatArray, threads: int) -> FloatArray:
        width = 2 * _BLOCK
        parts = [slice(i, i + width) for i in range(0, starts.shape[1], width)]
        with ThreadPoolExecutor(threads) as pool:
            ends = pool.map(lambda part: march(starts[:, part], points[:, part]), parts)
            return np.concatenate(list(ends), axis=1)

    return march_by


def numba(machine: FloatArray, n_steps: int) -> March:
    """Return Runge-Kutta and damage in numba, as a user would write them."""
    from numba import njit

    from benchmarks.peers import rundown

    rates = njit(fastmath=True)(rundown.rates)
    damage = njit(fastmath=True)(rundown.damage)
    march = njit(fastmath=True)(rundown.march_with(rates, damage))
    return _by_columns(
        lambda start, point: march(machine, n_steps, point[0], point[1], start.copy())
    )


def _by_columns(one: Callable[[FloatArray, FloatArray], FloatArray]) -> March:
    def march(starts: FloatArray, points: FloatArray) -> FloatArray:
        pairs = zip(starts.T, points.T, strict=True)
        return np.stack([np.asarray(one(*pair)) for pair in pairs], axis=1)

    return march


def has_simd() -> bool:
    """Return whether the SIMD peer runs here."""
    try:
        flags = set(Path("/proc/cpuinfo").read_text(encoding="utf-8").split())
    except OSError:
        return False
    return "avx512dq" in flags or {"avx2", "fma"} <= flags


def has_numba() -> bool:
    """Return whether numba is installed."""
    return importlib.util.find_spec("numba") is not None

"""The whole program as a user starts it: time and memory, cold and warm cache."""

from __future__ import annotations

import json
import os
import statistics
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

from benchmarks.machine import cores
from benchmarks.scale import Scale
from benchmarks.shares import COMPILING, MAP, REST
from benchmarks.table import Row, at_most, markdown

COLD, WARM, MEMORY = 8.0, 4.0, 300.0  # s, s, MB
_IMPORTS = "import coupling_design.flow.design, coupling_design.report.console.report"
_BAD_INPUT = 2  # an exit code; 1 says that no design meets the limits


@dataclass(frozen=True)
class Run:
    """Wall and processor time [s] and peak memory [MB] of one process."""

    seconds: float
    busy: float
    memory: float


def whole_design(scale: Scale) -> list[Row]:
    """Return time and memory of the five-step design, cold and warm."""
    cold, warm = [], []
    for _ in range(scale.processes):
        with tempfile.TemporaryDirectory() as home:
            cold.append(_design(scale, home))
            warm.append(_design(scale, home))
    cold_time, warm_time = _median(cold), _median(warm)
    busy = statistics.median(run.busy for run in warm)
    peak = max(run.memory for run in (*cold, *warm))
    imported = _median(
        [_run([sys.executable, "-c", _IMPORTS]) for _ in range(scale.processes)]
    )
    what = "five-step design with its 64 x 32 map"
    least = f"{busy / cores():.1f}"
    numbers = {"warm_seconds": f"{warm_time:.1f}", "least_seconds": least}
    rows = [
        at_most("cold", f"{what}, cold [s]", _spread(cold), cold_time, COLD),
        at_most("warm", f"{what}, warm [s]", _spread(warm), warm_time, WARM),
        Row("busy", "processor time of that, warm [s]", f"{busy:.1f}"),
        at_most("memory", "peak memory of that [MB]", f"{peak:.0f}", peak, MEMORY),
    ]
    return [*rows, Row("import", "import [s]", f"{imported:.2f}", numbers=numbers)]


def memory_of_steps(scale: Scale) -> Row:
    """Return the peak memory of a process with ten times the steps against one."""
    peaks = [
        _run([sys.executable, "-m", "benchmarks.rundown", str(scale.case), n]).memory
        for n in ("1", "10")
    ]
    shown = f"{peaks[1] / peaks[0]:.2f} x ({peaks[1]:.0f} MB)"
    return at_most(
        "steps_memory", "ten times the steps, memory", shown, peaks[1] / peaks[0], 1.1
    )


def shares(scale: Scale) -> dict[str, str]:
    """Return where the whole design's time goes, for the page's texts."""
    with tempfile.TemporaryDirectory() as home:
        cold, warm = _shares(scale, home), _shares(scale, home)
    total = sum(t for part, t in warm.items() if part != COMPILING)
    lines = [
        (part, f"{cold[part]:.2f} s", f"{seconds:.2f} s", f"{seconds / total:.0%}")
        for part, seconds in warm.items()
    ]
    mapping = warm.get(MAP, 0.0) + warm.get(REST, 0.0)
    return {
        "shares": markdown(("part", "cold", "warm", "of warm"), lines),
        "map_seconds": f"{mapping:.1f}",
        "rest_seconds": f"{total - mapping:.1f}",
        "map_share": f"{mapping / total:.0%}",
        "compile_seconds": f"{cold[COMPILING]:.1f}",
    }


def _shares(scale: Scale, home: str) -> dict[str, float]:
    command = [sys.executable, "-m", "benchmarks.shares", str(scale.case), home]
    done = subprocess.run(
        command, env=_environment(home), capture_output=True, text=True, check=True
    )
    parts: dict[str, float] = json.loads(done.stdout)["parts"]
    return parts


def _design(scale: Scale, home: str) -> Run:
    report = str(Path(home) / "report")
    command = [sys.executable, "-m", "coupling_design", str(scale.case)]
    return _run([*command, "--output", report], home)


def _run(command: list[str], home: str | None = None) -> Run:
    done = subprocess.run(
        [sys.executable, "-m", "benchmarks.clock", *command],
        env=_environment(home),
        capture_output=True,
        text=True,
        check=False,
    )
    if done.returncode < 0 or done.returncode >= _BAD_INPUT:
        sys.exit(f"{' '.join(command)} failed: {done.stderr}")
    return Run(*map(float, done.stdout.split()))


def _environment(home: str | None) -> dict[str, str]:
    """Return a user's environment, with a cache in `home`, where systems look for it.

    Python is to keep what it compiles, as it does unless a setting forbids it: each
    process would else compile all it imports, which says nothing of the program.
    """
    environment = dict(os.environ)
    environment.pop("PYTHONDONTWRITEBYTECODE", None)
    if home is not None:
        environment |= {"XDG_CACHE_HOME": home, "HOME": home}
    return environment


def _median(runs: list[Run]) -> float:
    return statistics.median(run.seconds for run in runs)


def _spread(runs: list[Run]) -> str:
    times = [run.seconds for run in runs]
    return f"{_median(runs):.1f} ({min(times):.1f} to {max(times):.1f})"

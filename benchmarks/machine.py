"""What the computer is and how busy it was."""

from __future__ import annotations

import os
import platform
import subprocess
from importlib.metadata import version
from pathlib import Path

from coupling_design.lanes.compiler import CompilerError, find_compiler


def machine() -> str:
    """Return processor, cores, compiler and versions in one line."""
    return ", ".join(
        [
            processor(),
            f"{cores()} cores",
            _compiler(),
            f"{platform.system()} {platform.machine()}",
            f"Python {platform.python_version()}",
            f"CasADi {version('casadi')}",
        ]
    )


def cores() -> int:
    """Return how many cores there are."""
    return os.cpu_count() or 1


def load() -> str:
    """Return how many processes wanted a core in the last minute."""
    try:
        return f"{os.getloadavg()[0]:.2f}"
    except OSError:
        return "unknown"


def processor() -> str:
    """Return the processor's model name."""
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
        names = [line for line in lines if line.startswith("model name")]
        return names[0].partition(":")[2].strip()
    except (OSError, IndexError):
        return platform.processor() or platform.machine()


def _compiler() -> str:
    try:
        command = [find_compiler().command[0], "--version"]
        done = subprocess.run(command, capture_output=True, text=True, check=True)
        return done.stdout.splitlines()[0]
    except (CompilerError, OSError, subprocess.CalledProcessError, IndexError):
        return "no C compiler"

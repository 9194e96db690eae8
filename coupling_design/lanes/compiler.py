"""Finding a C compiler and having it make a shared library."""

from __future__ import annotations

import os
import platform
import shlex
import shutil
import subprocess
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

# Names a compiler to use instead of the one found, with arguments of its own if wanted,
# or "none" for no compiler.
VARIABLE = "COUPLING_DESIGN_COMPILER"

_NAMES = ("cc", "gcc", "clang")

# No flag may change what a sum rounds to: results must not depend on the compiler.
# errno and traps only forbid the compiler to compute a square root in line.
_FLAGS = (
    "-std=gnu11",
    "-O2",
    "-ffp-contract=off",
    "-fno-math-errno",
    "-fno-trapping-math",
    "-fPIC",
    "-shared",
)
_LONGEST_COMPILATION = 120  # s


class CompilerError(Exception):
    """There is no compiler, or it failed; the message says why in one line."""


@dataclass(frozen=True)
class Compiler:
    """A C compiler and what its code depends on besides the source.

    Attributes
    ----------
    command : the program and arguments that overrule the usual ones
    identity : version of the compiler, its flags and the processor
    """

    command: tuple[str, ...]
    identity: str

    def build(self, source: str, library: Path) -> None:
        """Write the shared library of a source, or raise CompilerError."""
        arguments = [
            self.command[0],
            *_FLAGS,
            *_processor_flags(),
            *self.command[1:],
            "-x",
            "c",
            "-",
            "-o",
            str(library),
            "-lm",
        ]
        done = _run(arguments, source)
        if done.returncode != 0:
            raise CompilerError(f"{self.command[0]} failed: {_gist(done.stderr)}")


def find_compiler() -> Compiler:
    """Return the compiler to use, or raise CompilerError."""
    return _find(os.environ.get(VARIABLE, ""), os.environ.get("CC", ""))


@lru_cache(maxsize=8)
def _find(chosen: str, usual: str) -> Compiler:
    if chosen.lower() == "none":
        raise CompilerError(f"{VARIABLE} is none")
    if os.name != "posix":
        raise CompilerError("machine code is made on Linux and macOS only")
    candidates = [chosen] if chosen else [usual, *_NAMES]
    for candidate in filter(None, candidates):
        command = tuple(shlex.split(candidate))
        if command and shutil.which(command[0]):
            return Compiler(command, _identity(command))
    wanted = f"no C compiler {chosen!r} found" if chosen else "no C compiler found"
    raise CompilerError(wanted)


def _identity(command: tuple[str, ...]) -> str:
    done = _run([*command, "--version"])
    if done.returncode != 0:
        raise CompilerError(f"{command[0]} --version failed: {_gist(done.stderr)}")
    return "\n".join(
        [done.stdout, *command, *_FLAGS, *_processor_flags(), _processor()]
    )


def _run(arguments: list[str], text: str = "") -> subprocess.CompletedProcess[str]:
    try:
        return subprocess.run(
            arguments,
            input=text,
            capture_output=True,
            text=True,
            errors="replace",
            timeout=_LONGEST_COMPILATION,
            check=False,
        )
    except (OSError, subprocess.TimeoutExpired) as error:
        raise CompilerError(f"{arguments[0]} failed: {error}") from error


def _gist(messages: str) -> str:
    """Return the first line that tells of an error, or just the first."""
    lines = [line.strip() for line in messages.splitlines() if line.strip()]
    errors = [line for line in lines if "error" in line.lower()]
    return next(iter(errors or lines), "it said nothing")


def _processor_flags() -> tuple[str, ...]:
    is_x86 = platform.machine().lower() in ("x86_64", "amd64", "i686")
    return ("-march=native",) if is_x86 else ("-mcpu=native",)


def _processor() -> str:
    """Return what tells this processor from one that may not run its code."""
    names = ("model name", "flags", "CPU part", "Features", "isa")
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    except OSError:
        return f"{platform.machine()} {platform.processor()} {platform.platform()}"
    described = sorted({line for line in lines if line.startswith(names)})
    return "\n".join([platform.machine(), *described])

"""The whole design with the time of each part, as JSON on the output.

    python -m benchmarks.shares CASE DIRECTORY

What it does is what `python -m coupling_design` does, between time stamps.
"""

from __future__ import annotations

import json
import sys
import time
from collections import defaultdict
from pathlib import Path

COMPILING = "of all that, compiling"
MAP = "the 64 x 32 map of step 3"
REST = "finishing that map"


class Clock:
    """Seconds of each part, the parts one after another."""

    def __init__(self) -> None:
        self.parts: dict[str, float] = defaultdict(float)
        self._part, self._since = "", time.perf_counter()

    def start(self, part: str) -> None:
        """End the part before and start one."""
        now = time.perf_counter()
        if self._part:
            self.parts[self._part] += now - self._since
        self._part, self._since = part, now

    def progress(self, message: str) -> None:
        """Start the part that a progress message of the flow belongs to."""
        self.start(_part_of(message))


def _part_of(message: str) -> str:
    step, _, doing = message.rpartition(": ")
    if doing.startswith("mapping") and step.startswith("step 3"):
        return MAP
    if doing.startswith("finishing"):
        return REST
    if doing.startswith(("mapping", "histories", "run-down")):
        return "chosen run-down, its plane, histories"
    return f"searches of {step.partition(' of ')[0]}" if step else doing


def main() -> None:
    """Design, and print the parts."""
    clock = Clock()
    clock.start("importing")
    from coupling_design.case import load_case
    from coupling_design.flow.design import run_design
    from coupling_design.lanes.compiler import Compiler
    from coupling_design.report.console.console import make_report_console
    from coupling_design.report.console.report import render_outcome
    from coupling_design.report.files.write import prepare_directory, write_files

    build, compiling = Compiler.build, [0.0]

    def timed_build(self: Compiler, source: str, library: Path) -> None:
        began = time.perf_counter()
        build(self, source, library)
        compiling[0] += time.perf_counter() - began

    Compiler.build = timed_build  # type: ignore[method-assign]
    clock.start("reading the case")
    case, directory = load_case(sys.argv[1]), Path(sys.argv[2])
    outcome = run_design(case, clock.progress)
    clock.start("report")
    prepare_directory(directory)
    console = make_report_console()
    console.file = sys.stderr
    console.print(render_outcome(outcome))
    write_files(outcome, directory)
    clock.start("")
    parts = {**clock.parts, COMPILING: compiling[0]}
    sys.stdout.write(json.dumps({"parts": parts, "rollouts": outcome.rollouts}))


if __name__ == "__main__":
    main()

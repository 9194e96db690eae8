"""Measure everything and print the page: python -m benchmarks."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from contextlib import nullcontext
from pathlib import Path

from benchmarks import machine
from benchmarks.designs import design_searches
from benchmarks.integrator import solve_ivp_rows
from benchmarks.interpreted import differentiated, interpreted
from benchmarks.page import page
from benchmarks.rollouts import many_rollouts, one_rollout, ten_times
from benchmarks.scale import FULL, Scale, quick
from benchmarks.subject import Subject
from benchmarks.table import Row, table
from benchmarks.whole import memory_of_steps, shares, whole_design


def main(arguments: Sequence[str] | None = None) -> None:
    """Print the table; write the page if wanted."""
    options = _parser().parse_args(arguments)
    with quick() if options.quick else nullcontext(FULL) as scale:
        texts = {"machine": machine.machine(), "load": machine.load()}
        rows = measure(scale)
        texts |= {"rounds": str(scale.rounds), "processes": str(scale.processes)}
        texts |= {"load_after": machine.load(), **shares(scale)}
    sys.stdout.write(table(rows) + "\n")
    written = page(rows, texts)
    if options.write:
        options.write.write_text(written, encoding="utf-8")


def measure(scale: Scale) -> list[Row]:
    """Return all rows, in the order of the page."""
    subject = Subject(scale.case)
    return [
        *one_rollout(subject, scale),
        *many_rollouts(subject, scale),
        *solve_ivp_rows(subject, scale),
        ten_times(subject, scale),
        memory_of_steps(scale),
        *whole_design(scale),
        *design_searches(subject, scale),
        *interpreted(subject, scale),
        *differentiated(subject, scale),
    ]


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="python -m benchmarks", description=__doc__)
    parser.add_argument(
        "--quick", action="store_true", help="everything once, with a short run-down"
    )
    parser.add_argument(
        "--write", metavar="FILE", type=Path, help="where the page goes"
    )
    return parser


if __name__ == "__main__":
    main()

"""How much is measured: all of it, or just enough to see that everything runs."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import yaml

CASE = Path(__file__).parent.parent / "cases" / "16v280.yaml"


@dataclass(frozen=True)
class Scale:
    """What to measure, and how often.

    Attributes
    ----------
    case : file
    rounds : of everything that is timed within this process
    processes : runs of the whole program, each cold and warm
    batch : designs, whole blocks of 16
    generations : at most, of differential evolution
    """

    case: Path
    rounds: int
    processes: int
    batch: int
    generations: int


FULL = Scale(CASE, rounds=7, processes=5, batch=256, generations=1000)


@contextmanager
def quick() -> Iterator[Scale]:
    """Give a scale of some seconds: a run-down cut short, each thing done once."""
    document = yaml.safe_load(CASE.read_text(encoding="utf-8"))
    document["shutdown"]["duration"] = "0.2 s"
    with tempfile.TemporaryDirectory() as directory:
        case = Path(directory) / CASE.name
        text = yaml.safe_dump(document, sort_keys=False, allow_unicode=True)
        case.write_text(text, encoding="utf-8")
        yield Scale(case, rounds=1, processes=1, batch=16, generations=2)

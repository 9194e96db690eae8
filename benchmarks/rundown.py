"""One run-down in a process: python -m benchmarks.rundown CASE REFINEMENT."""

from __future__ import annotations

import sys
from pathlib import Path

from benchmarks.subject import Subject
from coupling_design.march.fastest import fastest_marcher


def main() -> None:
    """Roll out one design, its step divided by the refinement."""
    refinement = int(sys.argv[2])
    subject = Subject(Path(sys.argv[1]), refinement)
    batch = subject.batch(1)
    run = fastest_marcher(subject.step, refinement * subject.case.shutdown.n_steps)
    run(batch.starts, batch.points)


if __name__ == "__main__":
    main()

"""The command line, as `python -m coupling_design`."""

from __future__ import annotations

import atexit
import gc
import sys
from collections.abc import Sequence


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line; return its exit code."""
    # What is left at the end goes with the process; to look through it takes 50 ms.
    atexit.register(gc.freeze)
    from coupling_design.commands.app import run

    return run(arguments)


if __name__ == "__main__":
    sys.exit(main())

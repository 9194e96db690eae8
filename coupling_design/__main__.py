"""The command line, as `python -m coupling_design`."""

from __future__ import annotations

import sys
from collections.abc import Sequence


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line; return its exit code."""
    from coupling_design.commands.app import run

    return run(arguments)


if __name__ == "__main__":
    sys.exit(main())

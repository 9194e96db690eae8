"""The command: read a case, run the design flow, report."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path

from coupling_design import __doc__ as purpose
from coupling_design import __version__
from coupling_design.errors import CouplingDesignError

_NO_DESIGN = 1
_INTERRUPTED = 130
_EXIT_CODES = "exit code: 0 a design, 1 no design meets the limits, 2 bad input"


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command; return its exit code."""
    options = _parser().parse_args(arguments)
    directory = options.output or Path("reports", Path(options.case).stem)
    try:
        return _design(options.case, directory)
    except CouplingDesignError as error:
        from coupling_design.report.console import make_error_console
        from coupling_design.report.problems import render_error

        make_error_console().print(render_error(error), crop=False)
        return error.exit_code
    except KeyboardInterrupt:
        sys.stderr.write("Interrupted.\n")
        return _INTERRUPTED


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="python -m coupling_design", description=purpose, epilog=_EXIT_CODES
    )
    parser.add_argument("case", metavar="CASE", help="case file, YAML")
    parser.add_argument(
        "--output",
        metavar="DIR",
        type=Path,
        help="where design.json and report.txt go (reports/<name of the case file>)",
    )
    version = f"coupling_design {__version__}"
    parser.add_argument("--version", action="version", version=version)
    return parser


def _design(case_file: str, directory: Path) -> int:
    from coupling_design.case import load_case
    from coupling_design.design.flow import run_design
    from coupling_design.report.console import make_report_console
    from coupling_design.report.files import prepare_directory, write_files
    from coupling_design.report.outcome import render_outcome
    from coupling_design.report.progress import show_progress

    case = load_case(case_file)
    prepare_directory(directory)
    with show_progress() as progress:
        outcome = run_design(case, progress)
    console = make_report_console()
    console.print(render_outcome(outcome))
    written = write_files(outcome, directory)
    console.print(*(f"Written: {path}" for path in written), sep="\n", soft_wrap=True)
    return _NO_DESIGN if outcome.chosen is None else 0


if __name__ == "__main__":
    sys.exit(main())

"""`python -m studies.identification [report | search] [--quick] [--seed N] ...`."""

from __future__ import annotations

import argparse
import sys

from rich.console import Console

from coupling_design.case import load_case
from coupling_design.errors import CouplingDesignError
from coupling_design.machine.machine import Case
from coupling_design.parts.bearing.parameters import Cleanliness
from studies.command import parser
from studies.drawing import save
from studies.identification.found import tables_of
from studies.identification.parameters import SMOOTH_CONTACT, STIFFEST_CONTACT
from studies.identification.search import Archive, Region, global_search, local_fit
from studies.identification.targets import misfit
from studies.identification.trade_off import improve, read_front, write_front

_QUICK_MINUTES, _LOCAL_SHARE = 0.2, 0.4


def main() -> int:
    """Run the study as the command line says and return the exit code."""
    arguments = _parser().parse_args()
    try:
        case = load_case(arguments.case)
        if arguments.action == "report":
            _report(case, arguments)
        elif arguments.trade_off:
            _trade_off(case, arguments)
        else:
            _search(case, arguments)
    except CouplingDesignError as error:
        Console(stderr=True).print(str(error), style="red", markup=False)
        return 1
    return 0


def _parser() -> argparse.ArgumentParser:
    made = parser("Identification of the inputs that the paper does not print")
    made.add_argument("action", nargs="?", choices=("report", "search"))
    made.set_defaults(action="report")
    made.add_argument("--quick", action="store_true", help="seconds instead of minutes")
    made.add_argument("--seed", type=int, default=1)
    made.add_argument("--minutes", type=float, default=10.0, help="of a search")
    made.add_argument(
        "--trade-off",
        action="store_true",
        help="search for the front of half the stiffness against the rest",
    )
    made.add_argument(
        "--stiff-contact",
        action="store_true",
        help="search with contacts that the paper's time step does not resolve too",
    )
    made.add_argument(
        "--from-scratch", action="store_true", help="forget the named sets"
    )
    made.add_argument(
        "--cleanliness",
        nargs="+",
        type=Cleanliness,
        default=[Cleanliness.SLIGHT_TYPICAL],
        help="classes to search (default: slight_typical, the paper's words)",
    )
    return made


def _minutes(arguments: argparse.Namespace) -> float:
    return _QUICK_MINUTES if arguments.quick else float(arguments.minutes)


def _search(case: Case, arguments: argparse.Namespace) -> None:
    contact = STIFFEST_CONTACT if arguments.stiff_contact else SMOOTH_CONTACT
    region = Region(contact, tuple(arguments.cleanliness), arguments.from_scratch)
    seconds = 60 * _minutes(arguments)
    archive = Archive(case, region)
    share = (1 - _LOCAL_SHARE) * seconds
    first = global_search(archive, misfit, arguments.seed, share, "global search")
    n_phases = 2 if arguments.quick else 8
    smooth = local_fit(case, first, region, n_phases, _LOCAL_SHARE * seconds)
    found = {"one start phase": first, "all start phases": smooth}
    console = Console()
    for made in tables_of(case, found):
        console.print(made)


def _trade_off(case: Case, arguments: argparse.Namespace) -> None:
    minutes = _minutes(arguments)
    command = (
        "python -m studies.identification search --trade-off "
        f"--seed {arguments.seed} --minutes {minutes:g}"
    )
    write_front(improve(case, arguments.seed, minutes, read_front()), command)


def _report(case: Case, arguments: argparse.Namespace) -> None:
    from studies.identification.report import QUICK_STUDY, STUDY

    study = QUICK_STUDY if arguments.quick else STUDY
    found = study.examine(case)
    console = Console()
    for made in study.tables(found):
        console.print(made)
    for sentence in study.findings(found):
        console.print(sentence, markup=False, highlight=False)
    for name, drawn in study.figures(found).items():
        console.print(str(save(drawn, arguments.output, name, arguments.format)))


if __name__ == "__main__":
    sys.exit(main())

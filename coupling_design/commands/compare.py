"""`compare A B`: what changed, and what it did."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Annotated

import typer

if TYPE_CHECKING:
    from rich.console import RenderableType

    from coupling_design.commands.comparison import Difference, Shown

EXAMPLES = (
    "compare cases/16v280.yaml reports/16v280/chosen.yaml",
    "compare before/design.json after/design.json",
    "compare cases/16v280.yaml mine.yaml --design",
)
_SIDE = "case file or design.json"


_SizeOf = Annotated[
    str | None,
    typer.Option(
        metavar="NAME",
        show_default=False,
        help="roll out this size of the case's catalogue, not its present coupling",
    ),
]


def run(
    first: Annotated[str, typer.Argument(metavar="A", help=_SIDE)],
    second: Annotated[str, typer.Argument(metavar="B", help=_SIDE)],
    *,
    design: Annotated[
        bool,
        typer.Option("--design", help="design the coupling of cases, too (seconds)"),
    ] = False,
    size_a: _SizeOf = None,
    size_b: _SizeOf = None,
) -> int:
    """Put two cases or two results side by side: what changed, and what it did.

    Of cases the present couplings are rolled out; of design.json files the present
    and the chosen ones are compared.
    """
    from rich.text import Text

    from coupling_design.commands.comparison import (
        compare_results,
        differing_inputs,
        read_side,
    )
    from coupling_design.report.console.blocks import bullets, facts
    from coupling_design.report.console.console import make_report_console
    from coupling_design.report.console.progress import show_progress
    from coupling_design.report.words.chances import CHAOTIC

    with show_progress() as progress:
        progress(first)
        a = read_side(first, design=design, size=size_a)
        progress(second)
        b = read_side(second, design=design, size=size_b)
    console = make_report_console()
    console.print(facts([("A", a.label), ("B", b.label)]), Text())
    for name, side in (("A", a), ("B", b)):
        warned = bullets(f"Read first, {name}", side.warnings)
        if warned is not None:
            console.print(warned, Text())
    console.print(_inputs(differing_inputs(a, b)), Text())
    console.print(_results(compare_results(a, b)))
    if any("chaotic" in name for side in (a, b) for name in side.results):
        console.print(Text(), Text(CHAOTIC), sep="\n")
    return 0


def _inputs(differences: Sequence[Difference] | None) -> RenderableType:
    from rich.text import Text

    from coupling_design.report.console.blocks import table, titled

    if differences is None:
        return Text("Inputs: a result of an older version does not record them.")
    if not differences:
        return Text("Inputs: no value differs.")
    rows = table(["value", "A", "B"], [], [])
    for each in differences:
        rows.add_row(*map(Text, (each.name, _word(each.first), _word(each.second))))
    return titled("Inputs that differ, as written", rows)


def _results(differences: Sequence[Difference]) -> RenderableType:
    from rich.text import Text

    from coupling_design.report.console.blocks import table, titled
    from coupling_design.report.words.numbers import percent
    from coupling_design.report.words.units import display_unit

    rows = table(["result"], ["A", "B", "change\n%"], ["unit"])
    for each in differences:
        unit = display_unit("" if each.unit == "1" else each.unit)
        rows.add_row(
            Text(each.name),
            _number(each.first, each.unit),
            _number(each.second, each.unit),
            "" if each.change is None else percent(each.change),
            Text(unit if each.unit else ""),
        )
    return titled("Results", rows)


def _word(value: Shown) -> str:
    return "not given" if value is None else str(value)


def _number(value: Shown, unit: str) -> str:
    from coupling_design.report.words.damages import damage
    from coupling_design.report.words.names import words
    from coupling_design.report.words.units import quantity

    if not isinstance(value, float):
        return "" if value is None else words(value)
    small = unit == "1" and abs(value) < 1e-3
    return damage(value) if small else quantity(value, unit)

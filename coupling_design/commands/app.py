"""The command line: every command with its help."""

from __future__ import annotations

import inspect
import sys
from collections.abc import Sequence
from types import ModuleType
from typing import Annotated, Any

import typer
from typer.main import get_command

from coupling_design import __doc__ as purpose
from coupling_design import __version__
from coupling_design.commands import (
    campbell,
    check,
    compare,
    design,
    new,
    schema,
    simulate,
    sweep,
)
from coupling_design.commands.group import CommandGroup

PROGRAM = "coupling-design"
_EXIT_CODES = (
    "Exit code: 0 done, 1 no design meets the limits, 2 bad input, 130 interrupted."
)


# Each has a function `run`, which returns the exit code, and EXAMPLES of its use.
COMMANDS: dict[str, ModuleType] = {
    "design": design,
    "check": check,
    "new": new,
    "simulate": simulate,
    "sweep": sweep,
    "campbell": campbell,
    "compare": compare,
    "schema": schema,
}


def run(arguments: Sequence[str] | None = None) -> int:
    """Run the command line; return its exit code."""
    try:
        args = sys.argv[1:] if arguments is None else list(arguments)
        _command().main(args, prog_name=PROGRAM)
    except SystemExit as ended:
        return ended.code if isinstance(ended.code, int) else int(bool(ended.code))
    return 0


def _command() -> Any:
    app = typer.Typer(
        name=PROGRAM,
        cls=CommandGroup,
        help=f"{purpose}\n\n{PROGRAM} CASE is short for {PROGRAM} design CASE.",
        epilog=_EXIT_CODES,
        rich_markup_mode="rich",
        context_settings={"help_option_names": ["-h", "--help"]},
    )
    app.callback()(_options)
    for name, command in COMMANDS.items():
        app.command(name, help=_help(command))(command.run)
    return get_command(app)


def _help(command: ModuleType) -> str:
    """Return a command's docstring and its examples, which keep their lines."""
    examples = "\n".join(f"  {PROGRAM} {example}" for example in command.EXAMPLES)
    said = (inspect.getdoc(command.run) or "").split("\n\n")
    paragraphs = "\n\n".join(part.replace("\n", " ") for part in said)
    text = f"{paragraphs}\n\n\b\nExamples:\n{examples}"
    return f"{text}\n\n{_EXIT_CODES}" if command is design else text


def _show_version(asked: bool) -> None:
    if asked:
        sys.stdout.write(f"coupling_design {__version__}\n")
        raise typer.Exit


def _options(
    *,
    version: Annotated[
        bool,
        typer.Option(
            "--version", help="print the version", callback=_show_version, is_eager=True
        ),
    ] = False,
) -> None:
    """Take the options that stand before any command."""

"""The commands together: the default one, and what becomes of errors."""

from __future__ import annotations

import sys
from difflib import get_close_matches
from pathlib import Path
from typing import Any

import typer
from typer.core import TyperGroup

from coupling_design.errors import CouplingDesignError

DEFAULT = "design"
INTERRUPTED = 130


class CommandGroup(TyperGroup):
    """Commands by name; anything else is a case to design."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Read the arguments; put the default command in where none is named."""
        ours = {name for option in self.get_params(ctx) for name in option.opts}
        is_completion = ctx.resilient_parsing
        if not args:
            args = [] if is_completion else [DEFAULT]
        elif args[0] not in {*self.commands, *ours}:
            if not is_completion:
                self._check_spelling(ctx, args)
            args = [DEFAULT, *args]
        return super().parse_args(ctx, args)

    def invoke(self, ctx: Any) -> Any:
        """Run the command and end with its exit code, or the error's."""
        try:
            code = super().invoke(ctx)
        except CouplingDesignError as error:
            _show(error)
            code = error.exit_code
        except KeyboardInterrupt:
            sys.stderr.write("Interrupted.\n")
            code = INTERRUPTED
        raise typer.Exit(code or 0)

    def _check_spelling(self, ctx: Any, args: list[str]) -> None:
        """Refuse a misspelt command; a name with a dot or slash is a file's."""
        word = args[0] if args else ""
        if not word.isalpha() or Path(word).exists():
            return
        near = get_close_matches(word, self.commands, n=1)
        if near:
            ctx.fail(f"No such command or file '{word}'. Did you mean '{near[0]}'?")


def _show(error: CouplingDesignError) -> None:
    from coupling_design.report.console.console import make_error_console
    from coupling_design.report.console.errors import render_error

    make_error_console().print(render_error(error), crop=False)

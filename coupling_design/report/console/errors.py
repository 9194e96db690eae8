"""What a user is told when there is no report."""

from __future__ import annotations

from rich.console import Group, RenderableType
from rich.rule import Rule
from rich.text import Text

from coupling_design.errors import CaseError, CouplingDesignError


def render_error(error: CouplingDesignError) -> Group:
    """Return a red panel without sides: a line of its own for each problem.

    Lines are not broken, so that `file:line` can be clicked and searched for; print
    with `crop=False`.
    """
    problems = error.problems if isinstance(error, CaseError) else (str(error),)
    parts: list[RenderableType] = [
        Rule(Text(_title(error), style="bold red"), style="red")
    ]
    for problem in problems:
        parts += [Text(problem, no_wrap=True, overflow="ignore"), Text()]
    return Group(*parts[:-1], Rule(style="red"))


def _title(error: CouplingDesignError) -> str:
    if not isinstance(error, CaseError):
        return "The run stopped"
    n = len(error.problems)
    return f"{n} problem{'' if n == 1 else 's'} in the input"

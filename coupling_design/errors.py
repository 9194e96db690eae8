"""The exceptions a user can meet; everything else is a defect of ours."""

from __future__ import annotations

from collections.abc import Sequence


class CouplingDesignError(Exception):
    """Base of all expected errors; `exit_code` is what the command returns."""

    exit_code = 1


class CaseError(CouplingDesignError):
    """The input is wrong.

    `problems` holds one sentence for each problem: where, what was found, what is
    allowed, what to do.
    """

    exit_code = 2

    def __init__(self, problems: Sequence[str]) -> None:
        self.problems = tuple(problems)
        super().__init__("\n".join(self.problems))


class SimulationError(CouplingDesignError):
    """A rollout left the domain in which its equations hold."""


class OutputError(CouplingDesignError):
    """A place for the report's files that cannot be written to."""

    exit_code = 2


class DesignError(CouplingDesignError):
    """The optimiser or a stage could not do its work."""

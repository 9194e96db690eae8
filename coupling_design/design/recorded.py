"""The run-downs that the flow looks at in full, each recorded once."""

from __future__ import annotations

from functools import lru_cache

from coupling_design.driveline.history import History, simulate
from coupling_design.driveline.parameters import Driveline, Shutdown


# The present and the chosen coupling: the flow asks for both twice.
@lru_cache(maxsize=2)
def recorded_rundown(driveline: Driveline, shutdown: Shutdown) -> History:
    """Return the history of a run-down; the last two asked for are kept."""
    return simulate(driveline, shutdown)

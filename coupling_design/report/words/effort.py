"""What a run took, in words."""

from __future__ import annotations

from coupling_design.flow.outcome import DesignOutcome


def effort_sentence(outcome: DesignOutcome) -> str:
    """Return the run time, and how many run-downs there were at which step."""
    coarse = outcome.coarse_rollouts
    more = f" and {coarse} at a longer step for the map" if coarse else ""
    return (
        f"Run time {outcome.run_time:.1f} s, {outcome.rollouts} run-downs{more} on "
        f"{outcome.engine}."
    )

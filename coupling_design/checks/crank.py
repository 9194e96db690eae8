"""Whether three inertias are enough: where the crankshaft swings in itself."""

from __future__ import annotations

from coupling_design.machine.machine import Case

# A coupling's mode this many times below the crank's first is right to about a per cent
# with the crank rigid (chains of six throws, heavy and light flywheels).
ENOUGH = 5.0
# No crankshaft of an engine that drives a generator has a higher first mode [Hz].
_HIGHEST_CRANK_MODE = 700.0


def too_few_inertias(case: Case, natural_frequency: float) -> str | None:
    """Return what it means where a mode [Hz] is near or above those of the crank.

    None where three inertias do. Without engine data only what no engine has is told.
    """
    estimate = case.crank_mode
    highest = _HIGHEST_CRANK_MODE if estimate is None else estimate
    if highest >= ENOUGH * natural_frequency:
        return None
    whose = (
        f"This engine's first crank mode is about {estimate:.3g} Hz (estimated from "
        "bore, stroke and throws, good to a factor of 1.5)"
        if estimate is not None
        else f"No engine's first crank mode is above {highest:g} Hz, and the case does "
        "not describe the engine"
    )
    side = "above" if natural_frequency > highest else "within five times of"
    return (
        f"Three inertias are too few for {natural_frequency:.4g} Hz. {whose}: the plan "
        f"lies {side} it, where the crankshaft is not one rigid mass. The line's true "
        "modes lie lower and are more, orders may meet them in the working range, and "
        "the peak of the run-down is not that of three inertias: ask for a torsional "
        "calculation of the whole chain."
    )

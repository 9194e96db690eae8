"""The limits that the steps of the flow put on a design, by name.

Sources
-------
[1] Advances in Mechanical Engineering 2023, doi 10.1177/16878132231190062: section
    "Design method", steps 2 to 4, and eq. (7).
"""

from __future__ import annotations

import math

from coupling_design.arithmetic import Scalar, maximum
from coupling_design.machine.machine import Case
from coupling_design.machine.words import LoadLimitReading
from coupling_design.parts.bearing.contact_stress import (
    minimum_load,
    permissible_transmission_force,
)
from coupling_design.parts.criterion import Sense
from coupling_design.search.program import Constraint
from coupling_design.wear.performance import Performance

# Above this ratio of excitation to natural frequency a soft mount attenuates, [1].
ISOLATION_RATIO = math.sqrt(2)

_SMALL_ORDER = 0.01  # of the largest amplitude

_ISOLATION_SOURCE = "passive vibration isolation, sqrt 2 (paper, step 2)"


def excitation_frequencies(case: Case) -> tuple[tuple[float, float, float], ...]:
    """Return (order, lowest, highest frequency [Hz]) over the working speed range."""
    lowest, highest = (speed / (2 * math.pi) for speed in case.duty.working_speed)
    return tuple(
        (order.order, order.order * lowest, order.order * highest)
        for order in case.working_excitation
    )


def highest_excitation(case: Case) -> float:
    """Return the highest excitation frequency in the working speed range [Hz]."""
    return max(highest for _, _, highest in excitation_frequencies(case))


def deciding_orders(case: Case) -> tuple[float, float]:
    """Return the highest order of all, and of those of 1 % of the largest or more.

    By amplitude, at working speed; each order counts for the limit of step 4, however
    small it is.
    """
    orders = case.working_excitation
    largest = max(abs(order.amplitude) for order in orders)
    strong = [o.order for o in orders if abs(o.amplitude) >= _SMALL_ORDER * largest]
    return max(order.order for order in orders), max(strong)


def isolation_constraints(case: Case) -> tuple[Constraint, ...]:
    """Return, for each order, excitation over natural frequency at least sqrt 2.

    The lowest working speed is where an order comes nearest to a soft coupling.
    """

    def ratio(order: float, excitation: float) -> Constraint:
        def quantity(performance: Performance) -> Scalar:
            return excitation / performance.natural_frequency

        return Constraint(
            name=f"order {order:g}: excitation over natural frequency",
            quantity=quantity,
            limit=ISOLATION_RATIO,
            sense=Sense.AT_LEAST,
            unit="",
            source=_ISOLATION_SOURCE,
            needs_rollout=False,
        )

    return tuple(
        ratio(order, lowest) for order, lowest, _ in excitation_frequencies(case)
    )


def high_frequency_constraint(case: Case) -> Constraint:
    """Return: natural frequency at least sqrt 2 times the highest excitation [Hz]."""
    return Constraint(
        name="natural frequency",
        quantity=lambda performance: performance.natural_frequency,
        limit=ISOLATION_RATIO * highest_excitation(case),
        sense=Sense.AT_LEAST,
        unit="Hz",
        source="sqrt 2 times the highest excitation (paper, step 4)",
        needs_rollout=False,
    )


def load_constraints(
    case: Case, reading: LoadLimitReading | None = None
) -> tuple[Constraint, ...]:
    """Return the load limit in the case's reading, or in the one named."""
    if (reading or case.reading) is LoadLimitReading.TRANSMISSION_FORCE:
        return (_transmission_force(case),)
    return tuple(_combined_load(case, k) for k in range(len(case.bearings)))


def survival_constraints(case: Case) -> tuple[Constraint, ...]:
    """Return what any design must meet: no bearing dies in one stop, or is dented."""

    def over_static_rating(performance: Performance) -> Scalar:
        first, second = (
            load / bearing.static_load_rating
            for load, bearing in zip(
                performance.peak_combined_load, case.bearings, strict=True
            )
        )
        return maximum(first, second)

    return (
        Constraint(
            name="damage of one stop",
            quantity=lambda performance: maximum(*performance.damages),
            limit=1.0,
            sense=Sense.AT_MOST,
            unit="",
            source="Miner's sum: 1 is a whole bearing life",
        ),
        Constraint(
            name="largest bearing load over C_0",
            quantity=over_static_rating,
            limit=1.0,
            sense=Sense.AT_MOST,
            unit="",
            source="static load rating (ISO 76): above it a bearing is dented",
        ),
    )


def _transmission_force(case: Case) -> Constraint:
    return Constraint(
        name="peak transmission force",
        quantity=lambda performance: performance.peak_transmission_force,
        limit=float(permissible_transmission_force(case.shaft, case.bearings)),
        sense=Sense.AT_MOST,
        unit="N",
        source="F_min less the static load (eq. 7; the paper's reading, no lever)",
    )


def _combined_load(case: Case, k: int) -> Constraint:
    bearing = case.bearings[k]
    return Constraint(
        name=f"peak combined load, {bearing.name}",
        quantity=lambda performance: performance.peak_combined_load[k],
        limit=float(minimum_load(bearing)),
        sense=Sense.AT_MOST,
        unit="N",
        source=f"F_min = (S_min / K1)^{bearing.contact.root} (eq. 7; with the shaft's "
        "lever)",
    )

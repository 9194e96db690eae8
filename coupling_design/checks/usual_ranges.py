"""What generator sets of any size have: outside it a value is warned of, not refused.

One table: quantity, lowest, highest, why. From the smallest sets sold, some kilowatts,
to the largest medium-speed engines.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass

from coupling_design.machine.machine import Case

_RPM = math.pi / 30


@dataclass(frozen=True)
class UsualRange:
    """One row of the table, in the unit it is read in.

    `path` is of the value that is at fault where it is left, `of` gives it.
    """

    quantity: str
    path: str
    unit: str
    lowest: float
    highest: float
    reason: str
    of: Callable[[Case], float]


def _power(case: Case) -> float:
    return case.duty.rated_torque * case.duty.working_speed[1]


def _inertia(case: Case) -> float:
    line = case.driveline
    J_1, J_2 = line.engine_inertia, line.coupling_inertia
    return float(J_1 + J_2 + line.generator_inertia)


def _inertia_constant(case: Case) -> float:
    omega = case.duty.working_speed[1]
    return 0.5 * _inertia(case) * omega**2 / _power(case)


def _twist(case: Case) -> float:
    stiffness = case.driveline.coupling.torsional_stiffness
    return case.duty.rated_torque / float(stiffness)


def _driven_share(case: Case) -> float:
    return float(case.driveline.coupling_inertia) / _inertia(case)


USUAL_RANGES = (
    UsualRange(
        "rated power, torque times highest working speed",
        "duty.rated_torque",
        "kW",
        3.0,
        3e4,
        "the smallest diesel sets give some kilowatts, the largest engines 25 MW",
        lambda case: _power(case) / 1e3,
    ),
    UsualRange(
        "highest working speed",
        "duty.working_speed.highest",
        "rpm",
        60.0,
        3600.0,
        "a generator of two poles at 60 Hz turns at 3600 rpm",
        lambda case: case.duty.working_speed[1] / _RPM,
    ),
    UsualRange(
        "initial speed of the run-down",
        "shutdown.initial_speed",
        "rpm",
        20.0,
        4000.0,
        "an over-speed trip stands 10 to 15 % above the working speed",
        lambda case: float(case.shutdown.initial_speed) / _RPM,
    ),
    UsualRange(
        "energy at working speed over rated power, 0.5 J omega^2 / P",
        "driveline.generator_inertia",
        "s",
        0.05,
        20.0,
        "sets have an inertia constant of 0.3 to 4 s; far off, an inertia is mistyped",
        _inertia_constant,
    ),
    UsualRange(
        "share of the coupling in all inertia",
        "driveline.coupling_inertia",
        "-",
        1e-5,
        0.3,
        "the driven half is a small part of the line",
        _driven_share,
    ),
    UsualRange(
        "twist of the present coupling at rated torque",
        "driveline.coupling.torsional_stiffness",
        "rad",
        1e-5,
        0.5,
        "membranes twist by 1e-4 rad, the softest rubber by 0.3 rad",
        _twist,
    ),
    UsualRange(
        "viscosity at working temperature",
        "lubrication.viscosity",
        "mm^2/s",
        2.0,
        1000.0,
        "ISO 281 knows no oil film thinner than 2 mm^2/s gives; greases' base oils "
        "have up to some hundred",
        lambda case: case.lubrication.viscosity * 1e6,
    ),
)


def outside_usual_ranges(case: Case) -> Iterator[str]:
    """Yield a sentence for each value that no usual set has."""
    for row in USUAL_RANGES:
        value = row.of(case)
        if not row.lowest <= value <= row.highest:
            yield (
                f"{case.place(row.path)}: {row.quantity} is {value:.4g} {row.unit}, "
                f"outside {row.lowest:g} to {row.highest:g} {row.unit}: {row.reason}. "
                "Is a digit or a unit wrong?"
            )
    yield from _ratings(case)


def _ratings(case: Case) -> Iterator[str]:
    for k, bearing in enumerate(case.bearings):
        ratio = float(bearing.static_load_rating / bearing.dynamic_load_rating)
        if not 0.4 <= ratio <= 2.5:
            yield (
                f"{case.place(f'bearings[{k}].dynamic_load_rating')}: {bearing.name} "
                f"has C_0 / C = {ratio:.4g}, outside 0.4 to 2.5: catalogues have 0.6 "
                "to 1.9. Is a digit or a unit wrong?"
            )

"""At which crank angle each cylinder fires, from what a maker's sheet says.

Cylinders of an in-line engine are named 1, 2, 3 ...; those of a V engine A1, A2 ...
and B1, B2 ..., B after A in the direction of rotation, cylinders of one number on
one throw. So a B cylinder is at top dead centre one bank angle after its A cylinder,
and, with four strokes, fires then or a turn later.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import accumulate, pairwise

from coupling_design.engine.parameters import Cycle
from coupling_design.errors import CaseError

_TURN = 2 * math.pi
_CLOSE = math.radians(1e-6)


@dataclass(frozen=True)
class Arrangement:
    """Which cylinder fires when, angles in [rad] of the crankshaft.

    Attributes
    ----------
    cylinders : how many the engine has
    firing_order : names of all cylinders; of a V engine also one bank's numbers, and
        bank B follows by the bank angle
    bank_angle : between the banks, None in line
    firing_intervals : after each firing of `firing_order`; None if a bank fires evenly
    crank_angles : where each throw stands, in the direction of rotation, when throw 1
        is up; None if it follows from even firing
    """

    cylinders: int
    firing_order: tuple[str, ...]
    bank_angle: float | None = None
    firing_intervals: tuple[float, ...] | None = None
    crank_angles: tuple[float, ...] | None = None

    @property
    def names(self) -> tuple[str, ...]:
        """Names of all cylinders, those of bank A first."""
        if self.bank_angle is None:
            return tuple(str(number) for number in range(1, self.cylinders + 1))
        return tuple(f"{bank}{number}" for bank in "AB" for number in self.numbers)

    @property
    def numbers(self) -> tuple[str, ...]:
        """Numbers of the cylinders of one bank, or in line."""
        banks = 1 if self.bank_angle is None else 2
        return tuple(str(n) for n in range(1, self.cylinders // banks + 1))


def firing_angles(arrangement: Arrangement, cycle: Cycle) -> tuple[float, ...]:
    """Return each cylinder's firing top dead centre [rad], in the order of `names`.

    There are as many as cylinders (n_cylinders,). Angles count from the first firing of
    the order, within one cycle. Raises CaseError if the order, the intervals or the
    throws contradict each other.
    """
    _check_names(arrangement)
    order = arrangement.firing_order
    if arrangement.firing_intervals is not None:
        found = _by_intervals(order, arrangement.firing_intervals, cycle)
    elif arrangement.crank_angles is not None:
        found = _by_throws(arrangement, arrangement.crank_angles, cycle)
    elif arrangement.bank_angle is None or order[0].isdigit():
        found = _evenly(order, cycle)
    else:
        found = _by_even_bank(arrangement, cycle)
    names = arrangement.names
    if arrangement.bank_angle is not None and order[0].isdigit():
        lags = {"A": 0.0, "B": arrangement.bank_angle}
        found = {n: (found[n[1:]] + lags[n[0]]) % cycle.angle for n in names}
    return tuple(found[name] for name in names)


def _check_names(arrangement: Arrangement) -> None:
    order = arrangement.firing_order
    allowed = [arrangement.names]
    if arrangement.bank_angle is not None:
        allowed.append(arrangement.numbers)
        if arrangement.cylinders % 2:
            raise CaseError(
                [f"found {arrangement.cylinders} cylinders, allowed is an even number: "
                 "the banks of a V engine are alike; leave bank_angle out if in line"]
            )  # fmt: skip
    if not any(sorted(order) == sorted(names) for names in allowed):
        listed = ", or ".join(
            f"{names[0]} to {names[-1]}" for names in allowed if names
        )
        raise CaseError(
            [f"found {', '.join(order)}; a firing order of {arrangement.cylinders} "
             f"cylinders names each of {listed} once"]
        )  # fmt: skip


def _evenly(order: Sequence[str], cycle: Cycle) -> dict[str, float]:
    step = cycle.angle / len(order)
    return {name: index * step for index, name in enumerate(order)}


def _by_intervals(
    order: Sequence[str], intervals: Sequence[float], cycle: Cycle
) -> dict[str, float]:
    total = math.fsum(intervals)
    if len(intervals) != len(order) or abs(total - cycle.angle) > _CLOSE:
        raise CaseError(
            [f"found {len(intervals)} firing intervals, together "
             f"{math.degrees(total):g} deg; allowed is one for each of the "
             f"{len(order)} in the firing order, together "
             f"{math.degrees(cycle.angle):g} deg"]
        )  # fmt: skip
    return dict(zip(order, accumulate((0.0, *intervals[:-1])), strict=True))


def _by_throws(
    arrangement: Arrangement, throws: Sequence[float], cycle: Cycle
) -> dict[str, float]:
    """Return firing angles of a crankshaft: a throw that leads is up the sooner."""
    numbers = arrangement.numbers
    if len(throws) != len(numbers):
        raise CaseError(
            [f"found {len(throws)} crank angles; allowed is one for each throw, "
             f"{len(numbers)}"]
        )  # fmt: skip
    order = arrangement.firing_order
    centres = dict(zip(numbers, (-throw for throw in throws), strict=True))
    if not order[0].isdigit():
        centres = _of_both_banks(centres, arrangement.bank_angle or 0.0)
    return _in_sequence(order, centres, cycle)


def _by_even_bank(arrangement: Arrangement, cycle: Cycle) -> dict[str, float]:
    """Return firing angles of a V engine's whole order, each bank firing evenly."""
    order = arrangement.firing_order
    even = _evenly([name[1:] for name in order if name[0] == "A"], cycle)
    centres = _of_both_banks(even, arrangement.bank_angle or 0.0)
    found = _in_sequence(order, centres, cycle)
    first = found[f"A{next(iter(even))}"]
    for number, angle in even.items():
        apart = (found[f"A{number}"] - first - angle) % cycle.angle
        if min(apart, cycle.angle - apart) > _CLOSE:
            raise CaseError([_contradiction(arrangement.firing_order)])
    return found


def _of_both_banks(centres: Mapping[str, float], bank_angle: float) -> dict[str, float]:
    lags = {"A": 0.0, "B": bank_angle}
    return {
        f"{bank}{number}": centre + lag
        for bank, lag in lags.items()
        for number, centre in centres.items()
    }


def _in_sequence(
    order: Sequence[str], centres: Mapping[str, float], cycle: Cycle
) -> dict[str, float]:
    """Return when each fires: at its next dead centre after the one before it."""
    found = {order[0]: 0.0}
    for before, name in pairwise(order):
        wait = (centres[name] - centres[before]) % _TURN
        if min(wait, _TURN - wait) < _CLOSE:  # up together, so it fires a turn later
            wait = _TURN
        found[name] = found[before] + wait
    if found[order[-1]] > cycle.angle - _CLOSE:
        raise CaseError([_contradiction(order)])
    return found


def _contradiction(order: Sequence[str]) -> str:
    return (
        f"the order {', '.join(order)} cannot be fired within one cycle by the "
        "crankshaft that bank_angle and crank_angles (even firing, where they are not "
        "given) describe; correct them, or write firing_intervals"
    )

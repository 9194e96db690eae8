"""What an answer does when what is not known well moves within what is known of it.

That a number has six digits numerically says nothing of this. How far each input moves
is our judgement, the same for every case: a speed read off a dial, order amplitudes
from a calculation or a fit, a contact stiffness that nobody has on a sheet.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from coupling_design.line.modes import largest_stable_step
from coupling_design.line.parameters import KeyedConnection
from coupling_design.wear.digits import standing_digits
from coupling_design.wear.evaluator import Evaluator
from coupling_design.wear.performance import Performance
from coupling_design.wear.variables import FIRST_AMPLITUDE, INITIAL_SPEED

# Factors on each.
_SPEED = (0.97, 1.03)
_AMPLITUDE = (0.9, 1.1)
_CONTACT = (0.5, 2.0)
# Two damages must be told apart whatever moves both of them.
_FEWEST_DIGITS = 2


@dataclass(frozen=True)
class Move:
    """One input moved.

    Attributes
    ----------
    name : of the input
    factor : on its value [-]
    damage, peak : of the run-downs then, [-] and [N]
    """

    name: str
    factor: float
    damage: float
    peak: float


@dataclass(frozen=True)
class Sensitivity:
    """What one coupling does when inputs move, beside what it does where they do not.

    `damage` [-] and `peak` [N] are those of the case as it stands.
    """

    damage: float
    peak: float
    moves: tuple[Move, ...]

    @property
    def names(self) -> tuple[str, ...]:
        """What moves, each once."""
        return tuple(dict.fromkeys(move.name for move in self.moves))

    @property
    def damage_change(self) -> float:
        """Largest relative change of the damage [-]."""
        return max(abs(move.damage / self.damage - 1) for move in self.moves)

    @property
    def digits(self) -> int:
        """Significant digits of the damage worth printing, at least 2."""
        return max(standing_digits(self.damage_change), _FEWEST_DIGITS)

    def reach(self, name: str) -> tuple[float, float, float, float]:
        """Return lowest and highest relative change of damage, then of peak [-].

        What the input does not move is 0, the case as it stands.
        """
        moves = [move for move in self.moves if move.name == name]
        damages = [0.0, *(move.damage / self.damage - 1 for move in moves)]
        peaks = [0.0, *(move.peak / self.peak - 1 for move in moves)]
        return min(damages), max(damages), min(peaks), max(peaks)

    def span(self, name: str) -> str:
        """Return by how much an input moves, in words."""
        factors = [move.factor for move in self.moves if move.name == name]
        low, high = min(factors), max(factors)
        if high >= 2.0:
            return f"x {low:g} to x {high:g}"
        return f"{low - 1:+.0%} to {high - 1:+.0%}"


def sensitivity(evaluator: Evaluator, performance: Performance) -> Sensitivity:
    """Return what a design point does when speed, orders and contact move."""
    point = performance.torsional_stiffness, performance.key_gap
    moved = list(_moves(evaluator, *point))
    variables, n = evaluator.run_downs.variables, evaluator.chances.shape[1]
    columns = variables.columns([point] * len(moved), evaluator.chances)
    for i, (_, place, factor) in enumerate(moved):
        columns[place, i * n : (i + 1) * n] *= factor
    found = evaluator.performances_from(columns)
    return Sensitivity(
        damage=performance.damage,
        peak=float(performance.peak_transmission_force),
        moves=tuple(
            Move(name, factor, each.damage, float(each.peak_transmission_force))
            for (name, _, factor), each in zip(moved, found, strict=True)
        ),
    )


def reduction_range(present: Sensitivity, chosen: Sensitivity) -> tuple[float, float]:
    """Return between what the reduction of damage lies when inputs move [-].

    The same input moves for both; what only one of them has moves for that one.
    """
    before = {(move.name, move.factor): move.damage for move in present.moves}
    after = {(move.name, move.factor): move.damage for move in chosen.moves}
    reductions = [
        1 - after.get(key, chosen.damage) / before.get(key, present.damage)
        for key in {**before, **after}
    ]
    return min(reductions), max(reductions)


def _moves(
    evaluator: Evaluator, torsional_stiffness: float, key_gap: float
) -> Iterator[tuple[str, int, float]]:
    """Yield what moves: its name, its place among the variables, a factor on it."""
    variables = evaluator.run_downs.variables
    for factor in _SPEED:
        yield "initial speed", INITIAL_SPEED, factor
    for i, order in enumerate(evaluator.case.driveline.excitation):
        for factor in _AMPLITUDE:
            yield f"amplitude of order {order.order:g}", FIRST_AMPLITUDE + i, factor
    place = variables.contact_stiffness
    line = evaluator.driveline(torsional_stiffness, key_gap)
    if place is None or not isinstance(line.connection, KeyedConnection):
        return
    for factor in _CONTACT:
        stiffness = line.connection.contact_stiffness * factor
        stiffer = replace(line.connection, contact_stiffness=stiffness)
        # What the time step cannot resolve says nothing.
        stable = largest_stable_step(replace(line, connection=stiffer))
        if stable >= evaluator.time_step:
            yield "contact stiffness", place, factor

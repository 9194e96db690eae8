"""The design as a nonlinear program: variables, objective and named constraints.

A stage contributes constraints by name; the program is scaled so that every variable
runs from 0 to 1, every constraint is value over limit, and damage enters by logarithm.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from enum import StrEnum

import casadi as ca
import numpy as np

from coupling_design.arithmetic import Scalar
from coupling_design.parts.criterion import Criterion, Sense, held
from coupling_design.search.callback import RolloutCallback
from coupling_design.wear.evaluator import Evaluator
from coupling_design.wear.performance import Performance

# The program's limits lie this much inside the true ones, relative, so that a point
# which the solver puts on a limit passes it when it is checked again.
BACK_OFF = 1e-6


class Objective(StrEnum):
    """What a program minimises."""

    DAMAGE = "damage"
    STIFFNESS = "torsional stiffness"
    PEAK = "load over its limit"


@dataclass(frozen=True)
class Constraint:
    """A named limit on what a design does.

    `quantity` reads the value from a performance of numbers or symbols; `unit` is SI.
    A limit on the natural frequency alone needs no rollout.
    """

    name: str
    quantity: Callable[[Performance], Scalar]
    limit: float
    sense: Sense
    unit: str
    source: str
    needs_rollout: bool = True

    def excess(self, performance: Performance) -> Scalar:
        """Return how far the limit is exceeded, relative to it; negative inside."""
        # A bearing that its own weight overloads leaves a limit below zero.
        distance = (self.quantity(performance) - self.limit) / abs(self.limit)
        return distance if self.sense is Sense.AT_MOST else -distance

    def criterion(self, performance: Performance) -> Criterion:
        """Return the constraint held against a performance of numbers."""
        return held(
            self.name,
            float(self.quantity(performance)),
            self.limit,
            float(self.excess(performance)),
            sense=self.sense,
            unit=self.unit,
            source=self.source,
        )


@dataclass(frozen=True)
class DesignSpace:
    """Bounds of stiffness [N m/rad] and gap [m]; equal gap bounds fix the gap."""

    stiffness: tuple[float, float]
    gap: tuple[float, float]

    @property
    def gap_is_free(self) -> bool:
        """Whether the gap is a variable of the program."""
        return self.gap[1] > self.gap[0]

    def scaled(self, stiffness: float, gap: float) -> list[float]:
        """Return a point in the program's variables: log stiffness, then gap."""
        low, high = np.log(self.stiffness)
        scaled = [
            (float(np.log(stiffness)) - low) / (high - low) if high > low else 0.0
        ]
        if self.gap_is_free:
            scaled.append((gap - self.gap[0]) / (self.gap[1] - self.gap[0]))
        return [float(np.clip(value, 0.0, 1.0)) for value in scaled]

    def point(self, scaled: Scalar) -> tuple[Scalar, Scalar]:
        """Return (stiffness, gap) of the program's variables, values or symbols."""
        low, high = (float(value) for value in np.log(self.stiffness))
        stiffness = ca.exp(low + (high - low) * scaled[0])
        if not self.gap_is_free:
            return stiffness, self.gap[0]
        return stiffness, self.gap[0] + (self.gap[1] - self.gap[0]) * scaled[1]


@dataclass(frozen=True)
class DesignProblem:
    """What is minimised over a design space, subject to which constraints.

    The constraints that need a rollout are the loads: with Objective.PEAK they are
    what is minimised, and do not constrain.
    """

    evaluator: Evaluator
    space: DesignSpace
    objective: Objective
    constraints: tuple[Constraint, ...]

    def value(self, performance: Performance) -> Scalar:
        """Return the scaled objective, smaller is better; numbers or symbols."""
        if self.objective is Objective.STIFFNESS:
            return ca.log(performance.torsional_stiffness / self.space.stiffness[0])
        if self.objective is Objective.DAMAGE:
            return ca.log(ca.fmax(*performance.damages))
        return self.load_ratio(performance)

    def load_ratio(self, performance: Performance) -> Scalar:
        """Return the largest load over its limit [-]."""
        ratio: Scalar = 0.0
        for constraint in self.constraints:
            if constraint.needs_rollout:
                ratio = ca.fmax(ratio, 1 + constraint.excess(performance))
        return ratio

    @property
    def binding(self) -> tuple[Constraint, ...]:
        """The constraints that hold in this program."""
        if self.objective is not Objective.PEAK:
            return self.constraints
        return tuple(c for c in self.constraints if not c.needs_rollout)

    def is_feasible(self, performance: Performance) -> bool:
        """Return whether numbers meet every constraint of this program."""
        return all(float(c.excess(performance)) <= 0.0 for c in self.binding)

    def violation(self, performance: Performance) -> float:
        """Return the largest relative excess of any constraint, 0 if none."""
        excesses = [float(c.excess(performance)) for c in self.binding]
        return max([0.0, *excesses])

    def violation_without_rollout(self, performance: Performance) -> float:
        """Return the largest relative excess of those that need no rollout."""
        return max(
            (float(c.excess(performance)) for c in self.binding if not c.needs_rollout),
            default=0.0,
        )

    def functions(self) -> tuple[ca.Function, list[object]]:
        """Return (scaled variables) -> (objective, constraints <= 0), with derivatives.

        The second result must be kept alive as long as the function is used.
        """
        n = 2 if self.space.gap_is_free else 1
        u = ca.MX.sym("u", n)
        stiffness, gap = self.space.point(u)
        rollout = RolloutCallback(self.evaluator)
        totals = rollout(ca.vertcat(stiffness, gap))
        performance = self.evaluator.read(stiffness, gap, totals)
        excess = [c.excess(performance) + BACK_OFF for c in self.binding]
        program = ca.Function(
            "program", [u], [self.value(performance), ca.vertcat(*excess)]
        )
        return program, [rollout]

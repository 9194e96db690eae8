"""The rollout as a CasADi function, so that a program can be written around it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import casadi as ca
import numpy as np

from coupling_design.arithmetic import FloatArray
from coupling_design.errors import SimulationError
from coupling_design.wear.evaluator import Evaluator
from coupling_design.wear.quantities import TOTALS


class RolloutCallback(ca.Callback):
    """The rollout as a CasADi function of (stiffness, gap), with its exact Jacobian."""

    def __init__(self, evaluator: Evaluator) -> None:
        ca.Callback.__init__(self)
        self._evaluator = evaluator
        self._kept: list[ca.Callback] = []
        self.construct("rollout", {})

    def get_n_in(self) -> int:
        """Return 1: the point."""
        return 1

    def get_n_out(self) -> int:
        """Return 1: the totals."""
        return 1

    def get_sparsity_in(self, _: int) -> ca.Sparsity:
        """Return the shape of the point."""
        return ca.Sparsity.dense(2)

    def get_sparsity_out(self, _: int) -> ca.Sparsity:
        """Return the shape of the totals."""
        return ca.Sparsity.dense(len(TOTALS))

    def eval(self, arguments: Sequence[ca.DM]) -> list[ca.DM]:
        """Return the totals at a point."""
        return [ca.DM(_totals_and_jacobian(self._evaluator, arguments[0])[0])]

    def has_jacobian(self) -> bool:
        """Return that the Jacobian is known exactly."""
        return True

    def get_jacobian(
        self,
        name: str,
        _inames: Sequence[str],
        _onames: Sequence[str],
        opts: Any = None,
    ) -> ca.Function:
        """Return the Jacobian as a callback of its own."""
        jacobian = _JacobianCallback(self._evaluator, name, opts)
        self._kept.append(jacobian)
        return jacobian


class _JacobianCallback(ca.Callback):
    def __init__(self, evaluator: Evaluator, name: str, options: Any) -> None:
        ca.Callback.__init__(self)
        self._evaluator = evaluator
        self.construct(name, options)

    def get_n_in(self) -> int:
        return 2

    def get_n_out(self) -> int:
        return 1

    def get_sparsity_in(self, i: int) -> ca.Sparsity:
        return ca.Sparsity.dense(2 if i == 0 else len(TOTALS))

    def get_sparsity_out(self, _: int) -> ca.Sparsity:
        return ca.Sparsity.dense(len(TOTALS), 2)

    def eval(self, arguments: Sequence[ca.DM]) -> list[ca.DM]:
        return [ca.DM(_totals_and_jacobian(self._evaluator, arguments[0])[1])]


def _totals_and_jacobian(
    evaluator: Evaluator, point: ca.DM
) -> tuple[FloatArray, FloatArray]:
    """Return totals and Jacobian, not-a-number where the rollout left finite numbers.

    Ipopt takes that for a point to step back from; an exception it could not.
    """
    stiffness, gap = (float(value) for value in point.full().ravel())
    try:
        return evaluator.totals_and_jacobian(stiffness, gap)
    except SimulationError:
        n = len(TOTALS)
        return np.full(n, np.nan), np.full((n, 2), np.nan)

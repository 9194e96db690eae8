"""The rollout as a CasADi function, so that a program can be written around it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import casadi as ca

from coupling_design.design.evaluation import Evaluator
from coupling_design.design.joint import TOTALS


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
        stiffness, gap = (float(value) for value in arguments[0].full().ravel())
        return [ca.DM(self._evaluator.totals_and_jacobian(stiffness, gap)[0])]

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
        stiffness, gap = (float(value) for value in arguments[0].full().ravel())
        return [ca.DM(self._evaluator.totals_and_jacobian(stiffness, gap)[1])]

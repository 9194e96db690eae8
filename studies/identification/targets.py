"""The paper's results that inputs are held to, and how far candidates are from them.

Sources
-------
[1] Advances in Mechanical Engineering 2023, doi 10.1177/16878132231190062.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from coupling_design.arithmetic import FloatArray
from coupling_design.machine.machine import Case
from coupling_design.parts.bearing.damage import PAPER_UNIT
from coupling_design.wear.chance import chances
from studies.identification.model import VARIANTS, Rundowns, run
from studies.identification.parameters import Inputs

_Value = Callable[[Rundowns], FloatArray]
_RPM = 30 / math.pi
# A residual counts with its square up to so many tolerances, and linearly beyond: one
# result out of reach must not drown the others.
LINEAR_BEYOND = 6.0


@dataclass(frozen=True)
class Target:
    """A result of [1]: it lies from `lowest` to `highest`, give or take `tolerance`.

    `tolerance` weighs the results in the fit; `paper` is what [1] says, in words.
    """

    name: str
    unit: str
    paper: str
    lowest: float
    highest: float
    tolerance: float
    value: _Value

    @property
    def spread(self) -> float:
        """Standard deviation that [1] leaves to the result; infinite for a limit."""
        return max(self.tolerance, (self.highest - self.lowest) / math.sqrt(12))


def _damage(variant: str) -> _Value:
    return lambda found: PAPER_UNIT * found[variant, "damage_1"]


def _change(variant: str, reference: str, total: str = "damage_1") -> _Value:
    def value(found: Rundowns) -> FloatArray:
        changes: FloatArray = 100 * (
            found[variant, total] / found[reference, total] - 1
        )
        return changes

    return value


def _bow(gap: str, share: float) -> _Value:
    """Return by how much D at a gap lies above the line from tight fit to 0.3 mm."""

    def value(found: Rundowns) -> FloatArray:
        whole = _change("gap 0.3", "tight")(found)
        return _change(gap, "tight")(found) - share * whole

    return value


def _least_elastic_peak(found: Rundowns) -> FloatArray:
    """Return the least peak of F_c with any elastic stiffness and the gap [kN]."""
    elastic = [name for name in found.totals if name not in ("high stiffness", "gap 0")]
    peaks = [found[name, "peak_transmission_force"] for name in elastic]
    least: FloatArray = np.min(peaks, axis=0) / 1e3
    return least


_ANY = math.inf
_PEAK = "peak_transmission_force"

# fmt: off
TARGETS = (
    Target("D, present coupling", "1e-6", "0.00405", 0.00405, 0.00405, 0.00405 * 0.02,
           _damage("present")),
    Target("D at half the stiffness", "%", "+90.21", 90.21, 90.21, 5.0,
           _change("half", "present")),
    Target("D at 1.1 times the stiffness", "%", "falls slightly", -8.0, -0.4, 1.0,
           _change("stiffer", "present")),
    Target("D at 0.3 mm over tight fit", "%", "+19.68", 19.68, 19.68, 1.0,
           _change("gap 0.3", "tight")),
    Target("D at 0.1 mm above the line", "%", "linear", 0.0, 0.0, 2.0,
           _bow("gap 0.1", 0.1 / 0.3)),
    Target("D at 0.28 mm above the line", "%", "linear", 0.0, 0.0, 1.0,
           _bow("present", 0.28 / 0.3)),
    Target("peak Fc, high stiffness", "kN", "33.926", 33.926, 33.926, 0.4,
           lambda found: found["high stiffness", _PEAK] / 1e3),
    Target("D, high stiffness", "%", "-43.19", -43.19, -43.19, 1.0,
           _change("high stiffness", "present")),
    Target("resonance, tight fit", "rpm", "100 to 140", 102.0, 138.0, 3.0,
           lambda found: _RPM * found["tight", "speed_at_peak"]),
    Target("resonance, gap as built", "rpm", "100 to 140", 100.0, 140.0, 4.0,
           lambda found: _RPM * found["present", "speed_at_peak"]),
    Target("least peak Fc, elastic", "kN", "above 36.12", 37.0, _ANY, 0.7,
           _least_elastic_peak),
    Target("peak Fc at half the stiffness", "%", "rises", 3.0, _ANY, 5.0,
           _change("half", "present", _PEAK)),
    Target("peak Fc at 1.1 times the stiffness", "%", "falls", -_ANY, 0.0, 10.0,
           _change("stiffer", "present", _PEAK)),
    Target("largest load of bearing 2", "kN", "below 48.84", 0.0, 48.5, 1.0,
           lambda found: found["present", "peak_combined_load_2"] / 1e3),
    Target("speed after 12 s", "rpm", "about 0", -_ANY, 15.0, 10.0,
           lambda found: _RPM * found["present", "final_speed"]),
    Target("time until 5 rpm", "s", "about 12", 11.0, _ANY, 0.3,
           lambda found: found["present", "turning_time"]),
)
# fmt: on
HALF = next(i for i, t in enumerate(TARGETS) if t.name == "D at half the stiffness")
_LOWEST, _HIGHEST, _TOLERANCE = (
    np.array([getattr(target, name) for target in TARGETS])
    for name in ("lowest", "highest", "tolerance")
)


def targets(found: Rundowns) -> FloatArray:
    """Return the TARGETS of candidates, shape (n_candidates, n_targets)."""
    return np.array([target.value(found) for target in TARGETS]).T


def targets_of(
    case: Case, candidates: Sequence[Inputs], refinement: int = 1
) -> FloatArray:
    """Return the TARGETS of candidates, rolled out, (n_candidates, n_targets)."""
    return targets(run(case, candidates, refinement, VARIANTS))


def phases(case: Case, n: int) -> FloatArray:
    """Return n crank angles at the start, evenly spread, with gravity's direction.

    Shape (n, 2) [rad]; as the program itself judges a run-down.
    """
    return chances(case, n).T


def targets_over_phases(
    case: Case, candidates: Sequence[Inputs], n: int, refinement: int = 1
) -> FloatArray:
    """Return the TARGETS for n crank angles, shape (n_candidates, n, n_targets)."""
    started = [
        each.started_at(*angles) for each in candidates for angles in phases(case, n)
    ]
    found = targets_of(case, started, refinement)
    return found.reshape(len(candidates), n, len(TARGETS))


def residuals(values: FloatArray) -> FloatArray:
    """Return how many tolerances TARGETS lie above (+) or below (-) the paper."""
    nearest = np.clip(values, _LOWEST, _HIGHEST)
    outside: FloatArray = (values - nearest) / _TOLERANCE
    return outside


def contributions(values: FloatArray) -> FloatArray:
    """Return what each target adds to the misfit [-]."""
    r = np.abs(residuals(values))
    linear = LINEAR_BEYOND * (2 * r - LINEAR_BEYOND)
    return np.where(r < LINEAR_BEYOND, r**2, linear)


def misfit(values: FloatArray) -> FloatArray:
    """Return the misfit of all targets [-]; large where a rollout diverged."""
    total: FloatArray = contributions(values).sum(axis=-1)
    return np.where(np.isfinite(total), total, 1e6)


def misfit_of_the_others(values: FloatArray) -> FloatArray:
    """Return the misfit of all targets but D at half the stiffness [-]."""
    others = np.delete(contributions(values), HALF, axis=-1).sum(axis=-1)
    return np.where(np.isfinite(others), others, 1e6)

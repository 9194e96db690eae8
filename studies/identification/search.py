"""Search for the lost inputs: differential evolution, then local least squares.

Both are SciPy's. Every candidate is kept with its targets: other questions can be put
to the same rollouts.

Sources
-------
[1] Storn, Price (1997), Differential evolution, J. Global Optim. 11.
"""

from __future__ import annotations

import contextlib
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from coupling_design.arithmetic import FloatArray
from coupling_design.machine.machine import Case
from coupling_design.parts.bearing.parameters import Cleanliness
from studies.identification.jacobian import differences
from studies.identification.parameters import (
    NAMES,
    SMOOTH_CONTACT,
    Inputs,
    from_unit,
    named_sets,
    to_unit,
)
from studies.identification.targets import (
    LINEAR_BEYOND,
    misfit,
    residuals,
    targets_of,
    targets_over_phases,
)

Objective = Callable[[FloatArray], FloatArray]
POPULATION = 32
# Share of the bounds by which the local fit's derivatives step.
_STEP = 0.02
_LOCAL_ITERATIONS = 30
# Share of the bounds that the fit starts inside of them: on one it would hardly move.
_INSIDE = 0.03


@dataclass(frozen=True)
class Region:
    """Where to search: the stiffest contact [N m/rad] and the classes allowed.

    `from_scratch` says not to start from the named sets.
    """

    contact: float
    classes: tuple[Cleanliness, ...]
    from_scratch: bool = False

    @property
    def refinement(self) -> int:
        """What divides the time step: a stiffer contact needs half of the paper's."""
        return 1 if self.contact <= SMOOTH_CONTACT else 2

    @property
    def dimensions(self) -> list[tuple[float, float]]:
        """Bounds of the search: shares of the quantities' own, and the class."""
        highest = np.ones(len(NAMES))
        highest[-1] = to_unit(np.array([[*([1.0] * 10), self.contact]]))[0, -1]
        return [*((0.0, high) for high in highest), (0, len(self.classes) - 1)]

    def decode(self, points: FloatArray) -> list[Inputs]:
        """Return the inputs that points (n, 12) of the search stand for."""
        values = from_unit(points[:, :-1])
        classes = np.rint(points[:, -1]).astype(int)
        return [
            Inputs(tuple(row), self.classes[i])
            for row, i in zip(values.tolist(), classes.tolist(), strict=True)
        ]

    def encode(self, inputs: Inputs) -> FloatArray:
        """Return the point of the search (12,) nearest to inputs."""
        shares = to_unit(np.array([inputs.values]))[0]
        point = np.append(shares, self.classes.index(inputs.cleanliness))
        low, high = np.array(self.dimensions).T
        clipped: FloatArray = np.clip(point, low, high)
        return clipped

    def known(self) -> list[FloatArray]:
        """Return the named sets of these classes as points of the search."""
        if self.from_scratch:
            return []
        sets = [entry.inputs for entry in named_sets().values()]
        return [self.encode(s) for s in sets if s.cleanliness in self.classes]


@dataclass
class Archive:
    """Every candidate looked at: its point of the search and its TARGETS."""

    case: Case
    region: Region
    points: list[FloatArray] = field(default_factory=list)
    values: list[FloatArray] = field(default_factory=list)

    def evaluate(self, points: FloatArray) -> FloatArray:
        """Return the TARGETS of points (n, 12), and keep both."""
        found = targets_of(
            self.case, self.region.decode(points), self.region.refinement
        )
        self.points.extend(points)
        self.values.extend(found)
        return found

    def best(self, objective: Objective, n: int) -> FloatArray:
        """Return the n points that do best by an objective, best first."""
        order = np.argsort(objective(np.array(self.values)))[:n]
        return np.array(self.points)[order]


class _TimeUpError(Exception):
    """The time allowed has passed."""


def global_search(
    archive: Archive, objective: Objective, seed: int, seconds: float, label: str
) -> Inputs:
    """Return the best inputs that differential evolution, [1], finds in a time.

    Half of its population starts from the best of the archive, the others anywhere.
    """
    from scipy.optimize import differential_evolution

    region, deadline = archive.region, time.monotonic() + seconds
    generations = 0

    def score(points: FloatArray) -> FloatArray:
        return objective(archive.evaluate(points.T))

    def watch(_: FloatArray, convergence: float = 0.0) -> bool:
        nonlocal generations
        generations += 1
        _say(f"{label}: generation {generations}, {_least(archive, objective):.2f}")
        return time.monotonic() > deadline

    differential_evolution(
        score,
        region.dimensions,
        init=_population(archive, objective, seed),
        seed=seed,
        callback=watch,
        vectorized=True,
        updating="deferred",
        integrality=[False] * len(NAMES) + [True],
        mutation=(0.4, 0.9),
        recombination=0.8,
        maxiter=100_000,
        tol=1e-3,
        polish=False,
    )
    _say("\n")
    return region.decode(archive.best(objective, 1))[0]


def local_fit(
    case: Case, start: Inputs, region: Region, n_phases: int, seconds: float
) -> Inputs:
    """Return inputs whose targets, averaged over crank angles, fit best nearby.

    Least squares within the bounds, beyond `LINEAR_BEYOND` tolerances linear.
    """
    from scipy.optimize import least_squares

    deadline, best = time.monotonic() + seconds, (np.inf, start)
    low, high = np.array(region.dimensions[:-1]).T

    def several(points: FloatArray) -> FloatArray:
        classed = [Inputs(tuple(v), start.cleanliness) for v in from_unit(points)]
        found = targets_over_phases(case, classed, n_phases, region.refinement)
        return residuals(found.mean(axis=1))

    def one(point: FloatArray) -> FloatArray:
        nonlocal best
        if time.monotonic() > deadline:
            raise _TimeUpError
        values = targets_over_phases(
            case, [_inputs(point, start)], n_phases, region.refinement
        ).mean(axis=1)
        best = min(best, (misfit(values)[0], _inputs(point, start)), key=_first)
        _say(f"local fit: {best[0]:.2f}")
        left: FloatArray = residuals(values)[0]
        return left

    def slope(point: FloatArray) -> FloatArray:
        return differences(several, point, low, high, _STEP)

    point = to_unit(np.array([start.values]))[0]
    point = np.clip(point, low + _INSIDE, high - _INSIDE)
    with contextlib.suppress(_TimeUpError):
        least_squares(
            *(one, point, slope, (low, high)),
            loss="huber",
            f_scale=LINEAR_BEYOND,
            max_nfev=_LOCAL_ITERATIONS,
        )
    _say("\n")
    return best[1]


def _inputs(point: FloatArray, like: Inputs) -> Inputs:
    return Inputs(tuple(from_unit(point[np.newaxis])[0].tolist()), like.cleanliness)


def _first(pair: tuple[float, Inputs]) -> float:
    return pair[0]


def _least(archive: Archive, objective: Objective) -> float:
    return float(objective(np.array(archive.values)).min())


def _population(archive: Archive, objective: Objective, seed: int) -> FloatArray:
    """Return the points to start from."""
    from scipy.stats import qmc

    known = archive.region.known()
    if known and not archive.values:
        archive.evaluate(np.array(known))
    low, high = np.array(archive.region.dimensions).T
    kept = list(archive.best(objective, POPULATION // 2)) if archive.values else []
    cube = qmc.LatinHypercube(len(low), seed=seed)
    spread = low + cube.random(POPULATION - len(kept)) * (high - low)
    spread[:, -1] = np.rint(spread[:, -1])
    return np.vstack([*kept, spread])


def _say(words: str) -> None:
    sys.stderr.write(words if words == "\n" else f"\r{words:<72}")
    sys.stderr.flush()

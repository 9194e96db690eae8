"""Everything that the report shows, computed once."""

from __future__ import annotations

import functools
from dataclasses import dataclass

import numpy as np

from coupling_design.arithmetic import FloatArray
from coupling_design.machine.machine import Case
from coupling_design.parts.bearing.damage import PAPER_UNIT
from studies.forces import change
from studies.identification.explanation import sentences
from studies.identification.identifiability import Identifiability, identifiability
from studies.identification.model import MORE_VARIANTS, Rundowns, run
from studies.identification.parameters import (
    SHIPPED,
    SMOOTH_CONTACT,
    NamedSet,
    named_sets,
)
from studies.identification.targets import TARGETS, targets, targets_over_phases
from studies.identification.trade_off import Point, read_front

# What divides the paper's step of 1e-4 s.
STEPS = {"1e-4 s": 1, "2.5e-5 s": 4}
COMPROMISE = "middle"
N_PHASES, QUICK_PHASES = 11, 3


@dataclass(frozen=True)
class SetEvidence:
    """What one set gives.

    Attributes
    ----------
    named : the set
    values : TARGETS for each of STEPS (n_steps, n_targets)
    more : further results in words, for each of STEPS
    band : TARGETS over the crank angle (n_phases, n_targets)
    """

    named: NamedSet
    values: FloatArray
    more: dict[str, tuple[float, ...]]
    band: FloatArray


@dataclass(frozen=True)
class Evidence:
    """The sets by name, two of them linearised, the front, and the explanation."""

    sets: dict[str, SetEvidence]
    determined: dict[str, Identifiability]
    front: tuple[Point, ...]
    explanation: tuple[str, ...]

    @property
    def shipped(self) -> SetEvidence:
        """The set that the shipped case carries."""
        return self.sets[SHIPPED]


@functools.cache
def examine(case: Case, n_phases: int = N_PHASES) -> Evidence:
    """Return all that the report shows, with so many crank angles."""
    sets = named_sets()
    return Evidence(
        sets={name: _evidence(case, named, n_phases) for name, named in sets.items()},
        determined={
            name: identifiability(case, sets[name].inputs, n_phases)
            for name in (SHIPPED, COMPROMISE)
        },
        front=tuple(read_front()),
        explanation=tuple(sentences(case, n_phases)),
    )


def quick(case: Case) -> Evidence:
    """Return the same with few crank angles."""
    return examine(case, QUICK_PHASES)


def _evidence(case: Case, named: NamedSet, n_phases: int) -> SetEvidence:
    stiff = named.inputs["contact_stiffness"] > SMOOTH_CONTACT
    found = [run(case, [named.inputs], n, MORE_VARIANTS) for n in STEPS.values()]
    more = [_more(each) for each in found]
    return SetEvidence(
        named=named,
        values=np.vstack([targets(each) for each in found]),
        more={name: tuple(each[name] for each in more) for name in more[0]},
        band=targets_over_phases(case, [named.inputs], n_phases, 1 + stiff)[0],
    )


def _more(found: Rundowns) -> dict[str, float]:
    """Return results that are shown but not fitted."""
    damage = {
        name: PAPER_UNIT * float(found[name, "damage_1"][0]) for name in found.totals
    }
    now, tight = damage["present"], damage["tight"]
    return {
        "D, tight fit [1e-6]": tight,
        "D, high stiffness [1e-6]": damage["high stiffness"],
        "D at 1.05 times the stiffness [%]": change(damage["a little stiffer"], now),
        "D at twice the stiffness [%]": change(damage["double"], now),
        "D, key without gap over tight fit [%]": change(damage["gap 0"], tight),
        "D at 0.2 mm over tight fit [%]": change(damage["gap 0.2"], tight),
        "peak Fc, present coupling [kN]": float(
            found["present", "peak_transmission_force"][0] / 1e3
        ),
    }


def names_of_targets() -> tuple[str, ...]:
    """Return the targets with their units."""
    return tuple(f"{target.name} [{target.unit}]" for target in TARGETS)

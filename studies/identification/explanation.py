"""Why no physical input with a resolved contact makes half the stiffness cost +90 %.

Sources
-------
[1] Advances in Mechanical Engineering 2023, doi 10.1177/16878132231190062.
[2] ISO 281:2007: life falls with the load to the power of 10/3.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from coupling_design.machine.machine import Case
from coupling_design.parts.bearing.life import LIFE_EXPONENT, ROLLER
from coupling_design.parts.bearing.parameters import Cleanliness
from studies.identification.model import MORE_VARIANTS, run
from studies.identification.parameters import Inputs, named_sets, shipped
from studies.identification.targets import HALF, TARGETS, phases, targets_of

# The paper's two numbers: what the high-stiffness coupling saves, what half costs [%].
SAVED = next(-t.lowest for t in TARGETS if t.name == "D, high stiffness")
RISE = TARGETS[HALF].lowest
_VARIANTS = ("present", "half", "tight", "half, tight", "high stiffness")


@dataclass(frozen=True)
class Resonance:
    """What the resonance does to D, averaged over the crank angle.

    Attributes
    ----------
    share : of D with the present coupling that the high-stiffness one saves [%]
    rise : of D at half the stiffness [%]
    growth : of the resonance's part of D at half the stiffness [-]
    linear_growth : the same in a tight fit, where the driveline is linear [-]
    damage : D of the present coupling, in the paper's unit
    """

    share: float
    rise: float
    growth: float
    linear_growth: float
    damage: float


def needed_growth(share: float = SAVED, rise: float = RISE) -> float:
    """Return by what the resonance's part of D must grow for D to rise so [-].

    Both in per cent; what the high-stiffness coupling leaves is not resonance and does
    not change with stiffness.
    """
    return 1 + rise / share


def passage_growth(exponent: float = LIFE_EXPONENT[ROLLER]) -> float:
    """Return by what a linear resonance's damage grows at half the stiffness [-].

    Damping ratio kappa0 omega_n / (2 omega0): the natural frequency and the damping
    ratio fall by sqrt 2, so the swing grows by sqrt 2, the band passed narrows to half
    and so does the time in it, and each second of it has 1 / sqrt 2 of the turns.
    With damage as load^p [2] per turn that is 2^((p - 3) / 2): the most, a run-down
    too quick for the swing to build up gives less.
    """
    return 2 ** ((exponent - 3) / 2)


def needed_exponent(growth: float) -> float:
    """Return the p at which a linear passage would grow so."""
    return 3 + 2 * math.log2(growth)


def resonance_of(case: Case, inputs: Inputs, n_phases: int) -> Resonance:
    """Return what the resonance does to D near a set."""
    started = [inputs.started_at(*angles) for angles in phases(case, n_phases)]
    found = run(case, started, variants={v: MORE_VARIANTS[v] for v in _VARIANTS})
    now, half, tight, tight_half, rest = (
        float(np.mean(found[variant, "damage_1"])) for variant in _VARIANTS
    )
    return Resonance(
        share=100 * (1 - rest / now),
        rise=100 * (half / now - 1),
        growth=(half - rest) / (now - rest),
        linear_growth=(tight_half - rest) / (tight - rest),
        damage=1e6 * now,
    )


@functools.cache
def by_cleanliness(case: Case, n_phases: int) -> Mapping[Cleanliness, Resonance]:
    """Return the same for the shipped inputs with each class of cleanliness."""
    return {
        each: resonance_of(case, shipped().of_class(each), n_phases)
        for each in Cleanliness
    }


def _of_rattling(case: Case) -> str:
    """Return what the contact adds, by one set with its own contact and the shipped."""
    rattling = named_sets()["lowest"].inputs
    contact, resolved = rattling["contact_stiffness"], shipped()["contact_stiffness"]
    values = (*rattling.values[:-1], resolved)
    soft = _rise(case, replace(rattling, values=values), 1)
    coarse, fine = (_rise(case, rattling, n) for n in (1, 4))
    return (
        "Rattling adds to it where the contact is too stiff for the paper's time step "
        f"to follow: the set 'lowest' has a contact of {contact / 1e6:.0f} MN m/rad. D "
        f"at half the stiffness changes by {coarse:+.0f} % at the paper's step and by "
        f"{fine:+.0f} % at a quarter of it; with the shipped contact of "
        f"{resolved / 1e6:.1f} MN m/rad it would be {soft:+.0f} %."
    )


def _rise(case: Case, inputs: Inputs, refinement: int) -> float:
    """Return the change of D at half the stiffness [%]."""
    return float(targets_of(case, [inputs], refinement)[0, HALF])


def sentences(case: Case, n_phases: int) -> Sequence[str]:
    """Return the explanation, its numbers filled in."""
    classes = by_cleanliness(case, n_phases)
    now = classes[shipped().cleanliness]
    clean = classes[Cleanliness.NORMAL]
    half = resonance_of(case, named_sets()["smooth half"].inputs, n_phases)
    need = needed_growth()
    return (
        f"The high-stiffness coupling passes no resonance and saves {SAVED:.2f} % of D "
        f"in the paper: so much of D is resonance. For D to rise by {RISE:.2f} % at "
        f"half the stiffness that part must grow {need:.2f} times.",
        f"A linear resonance's damage grows {passage_growth():.2f} times: the swing by "
        "the square root of two, to the power of 10/3 for a roller bearing, in half "
        "the time and at fewer turns. It would take a power of "
        f"{needed_exponent(need):.1f}; a_ISO makes the power higher, but less so the "
        "dirtier the grease. Rolled out with the shipped inputs in a tight fit the "
        f"part grows {now.linear_growth:.2f} times, with the key {now.growth:.2f} "
        f"times, and D changes by {now.rise:+.1f} % (averages over the crank angle).",
        _of_rattling(case),
        f"Cleaner grease makes more of D resonance: with normal cleanliness "
        f"{clean.share:.1f} % of it instead of {now.share:.1f} %, but then the "
        f"high-stiffness coupling saves just that much, and not {SAVED:.2f} %. The set "
        f"'smooth half' does reach {half.rise:+.1f} % so; there the high-stiffness "
        f"coupling saves {half.share:.1f} %.",
    )

"""What the key's contact stiffness decides: damage at half the coupling's stiffness.

Claim of the paper's figure 9: half the stiffness does 90.21 % more damage. Its contact
of "1,000,000 M N m/rad" cannot be what it rolled out, so every stiffness is tried here
at which the time step is stable, with half that step beside it.
"""

from __future__ import annotations

import dataclasses
import functools
from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.figure import Figure
from rich.table import Table

from coupling_design.machine.machine import Case
from coupling_design.parts.bearing.damage import PAPER_UNIT
from coupling_design.report.words.numbers import percent, significant
from coupling_design.steps.present import present_candidate
from coupling_design.wear.evaluator import Evaluator
from studies.command import Study, leave, table
from studies.drawing import BLUE, GREY, ORANGE, canvas, limits
from studies.forces import change
from studies.machine import present_point
from studies.stiffness import HALF

PAPER_CHANGE = 90.21  # of D at half the stiffness [%]
# A result counts as resolved if half the time step moves it by less [%].
RESOLVED = 1.0
# [N m/rad]; at the hard one rattling has been found chaotic.
CONTACTS = tuple(float(k) for k in np.geomspace(1e7, 1e9, 13))
HARD_CONTACT = 4e8


@dataclasses.dataclass(frozen=True)
class AtHalf:
    """One contact stiffness [N m/rad] and what half the coupling's stiffness does.

    `damage_e6` is D with the present stiffness in the paper's unit; `change` is that of
    D at half of it [%], at the time step, `refined_change` at half the time step.
    """

    contact: float
    damage_e6: float
    change: float
    refined_change: float

    @property
    def is_resolved(self) -> bool:
        """Whether halving the time step moves the change by little."""
        return abs(self.refined_change - self.change) < RESOLVED


@dataclasses.dataclass(frozen=True)
class ContactInfluence:
    """The case's own contact, then the others by rising stiffness."""

    present: AtHalf
    others: tuple[AtHalf, ...]


@functools.cache
def at_half(case: Case, contact: float) -> AtHalf:
    """Return what half the stiffness does with a contact [N m/rad]."""
    seat = dataclasses.replace(case.hub_seat, contact_stiffness=contact)
    keyed = Evaluator(dataclasses.replace(case, hub_seat=seat), present_candidate(case))
    now, built = present_point(case)
    points = [(HALF * now, built), (now, built)]
    half, full = keyed.performances(points)
    fine_half, fine_full = keyed.refined.performances(points)
    return AtHalf(
        contact=contact,
        damage_e6=PAPER_UNIT * full.damage,
        change=change(half.damage, full.damage),
        refined_change=change(fine_half.damage, fine_full.damage),
    )


def examine(case: Case, contacts: tuple[float, ...] = CONTACTS) -> ContactInfluence:
    """Return the influence of the contact's stiffness."""
    present = at_half(case, case.hub_seat.contact_stiffness or HARD_CONTACT)
    return ContactInfluence(present, tuple(at_half(case, k) for k in contacts))


def why_not_half(case: Case) -> str:
    """Return what half the stiffness does with the case's contact and a hard one."""
    ours = at_half(case, case.hub_seat.contact_stiffness or HARD_CONTACT)
    hard = at_half(case, HARD_CONTACT)
    sentence = (
        f"With the contact of {ours.contact / 1e6:.4g} MN m/rad half the stiffness "
        f"changes D by {ours.change:+.2f} % ({ours.refined_change:+.2f} % with half "
        f"the time step), with one of {hard.contact / 1e6:.0f} MN m/rad by "
        f"{hard.change:+.2f} % ({hard.refined_change:+.2f} %)."
    )
    if hard.is_resolved or hard.change <= ours.change:
        return sentence
    return (
        f"{sentence} What comes nearer to the paper is not resolved by its time step."
    )


def tables(found: ContactInfluence) -> Sequence[Table]:
    """Return every contact's damage and its change at half the stiffness."""
    made = table(
        "Half the coupling's stiffness, by the contact's stiffness",
        "contact, MN m/rad",
        "D, 1e-6",
        "change at half, %",
        "with half the time step, %",
    )
    for row in sorted((found.present, *found.others), key=lambda r: r.contact):
        made.add_row(
            significant(row.contact / 1e6),
            significant(row.damage_e6),
            percent(row.change / 100),
            percent(row.refined_change / 100),
        )
    return [made]


def figures(found: ContactInfluence) -> Mapping[str, Figure]:
    """Return the change at half the stiffness over the contact's stiffness."""
    figure, (axes,) = canvas(1, height=3.4)
    x = [row.contact / 1e6 for row in found.others]
    for color, name, values in (
        (BLUE, "time step of the case", [row.change for row in found.others]),
        (ORANGE, "half of it", [row.refined_change for row in found.others]),
    ):
        axes.plot(x, values, ".-", color=color, label=name)
    axes.axvline(found.present.contact / 1e6, color=GREY, linewidth=0.8)
    axes.annotate(" the case", (found.present.contact / 1e6, 70.0), color=GREY)
    limits(axes, PAPER_CHANGE, "paper")
    axes.set_xscale("log")
    axes.set_xlabel("stiffness of the key's contact, MN m/rad")
    axes.set_ylabel("change of D at half the stiffness, %")
    axes.legend()
    return {"contact": figure}


def findings(found: ContactInfluence) -> Sequence[str]:
    """Return the largest change that is resolved, and the largest of all."""
    rows = (found.present, *found.others)
    resolved = max((r for r in rows if r.is_resolved), key=lambda r: r.change)
    largest = max(rows, key=lambda r: r.change)
    return (
        f"Where halving the time step moves the result by less than {RESOLVED:g} "
        f"percentage point, half the stiffness changes D by {resolved.change:+.1f} % "
        f"at most, with a contact of {resolved.contact / 1e6:.3g} MN m/rad.",
        f"The largest change of all is {largest.change:+.1f} % at "
        f"{largest.contact / 1e6:.3g} MN m/rad ({largest.refined_change:+.1f} % with "
        f"half the time step); the paper's is {PAPER_CHANGE:+.2f} %.",
    )


STUDY = Study(
    "Half the stiffness, by the contact's stiffness (fig. 9)",
    examine,
    tables,
    figures,
    findings,
)

if __name__ == "__main__":
    leave(STUDY)

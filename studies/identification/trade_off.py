"""Half the stiffness against everything else: what can be had together.

For each rise of D at half the stiffness, the least misfit of all the other results, for
a contact that is resolved and for one up to five times as stiff. The front is stored
beside this file; a new run starts from it and from the named sets, and improves it.
"""

from __future__ import annotations

import csv
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

from coupling_design.arithmetic import FloatArray
from coupling_design.machine.machine import Case
from coupling_design.parts.bearing.parameters import Cleanliness
from studies.drawing import BLUE, GREY, ORANGE, RED, canvas
from studies.identification.parameters import (
    NAMES,
    QUANTITIES,
    SMOOTH_CONTACT,
    STIFFEST_CONTACT,
    Inputs,
    Quantity,
)
from studies.identification.search import Archive, Objective, Region, global_search
from studies.identification.targets import (
    HALF,
    TARGETS,
    misfit_of_the_others,
    targets_of,
)

FRONT_FILE = Path(__file__).with_name("trade_off.csv")
# What the paper calls generally clean, and a class on either side of it.
CLASSES = (Cleanliness.NORMAL, Cleanliness.SLIGHT_TYPICAL, Cleanliness.SEVERE)
CONTACTS = (SMOOTH_CONTACT, STIFFEST_CONTACT)
# Rises of D at half the stiffness [%]: searched for, and stored.
_SEARCHED = (90.0, 75.0, 60.0, 45.0, 30.0, 15.0, 0.0)
LEVELS: FloatArray = np.arange(0.0, 95.0, 5.0)
# Misfit per tolerance that the rise falls short, dearer than the front is steep.
_PRICE = 100.0
# Above the paper's by two tolerances is no gain any more [%].
_MOST = 100.0


@dataclass(frozen=True)
class Point:
    """The least misfit of the others at a rise [%] of at least `level`.

    `contact` is the bound of the contact stiffness [N m/rad], `values` the TARGETS.
    """

    contact: float
    level: float
    others: float
    inputs: Inputs
    values: tuple[float, ...]

    @property
    def rise(self) -> float:
        """Rise of D at half the stiffness [%]."""
        return self.values[HALF]


def improve(
    case: Case, seed: int, minutes: float, known: Sequence[Point]
) -> list[Point]:
    """Return the front after a search that starts from what is known of it."""
    front: list[Point] = []
    seconds = 60 * minutes / (len(CONTACTS) * len(_SEARCHED))
    for contact in CONTACTS:
        region = Region(contact, CLASSES)
        archive = Archive(case, region)
        stored = [point.inputs for point in known if point.contact <= contact]
        starts = [region.encode(inputs) for inputs in stored]
        archive.evaluate(np.array([*region.known(), *starts]))
        for i, level in enumerate(_SEARCHED):
            label = f"contact up to {contact:.0e}, rise {level:.0f} %"
            global_search(archive, _at_least(level), seed + i, seconds, label)
        candidates = region.decode(np.array(archive.points))
        found = front_of(_points(contact, candidates, np.array(archive.values)))
        settled = [*stored, *(_as_stored(point.inputs) for point in found)]
        values = targets_of(case, settled, region.refinement)
        front.extend(front_of(_points(contact, settled, values)))
    return front


def front_of(points: Sequence[Point]) -> list[Point]:
    """Return the best of many points at each of LEVELS that one reaches."""
    front = []
    for level in LEVELS.tolist():
        reached = [point for point in points if level <= point.rise <= _MOST]
        if reached:
            best = min(reached, key=lambda point: point.others)
            front.append(replace(best, level=level))
    return front


def _points(
    contact: float, candidates: Sequence[Inputs], values: FloatArray
) -> list[Point]:
    others = misfit_of_the_others(values).tolist()
    rows = zip(others, candidates, map(tuple, values.tolist()), strict=True)
    return [Point(contact, 0.0, *row) for row in rows]


def _as_stored(inputs: Inputs) -> Inputs:
    """Return inputs with the digits that a file keeps: rattling can tell."""
    pairs = zip(QUANTITIES, inputs.values, strict=True)
    return replace(
        inputs, values=tuple(q.to_si(float(_stored(q, value))) for q, value in pairs)
    )


def _stored(quantity: Quantity, value: float) -> str:
    return f"{quantity.from_si(value):.10g}"


def write_front(front: Sequence[Point], command: str, path: Path = FRONT_FILE) -> None:
    """Write a front as a table, with the command that made it."""
    with path.open("w", newline="", encoding="utf-8") as file:
        file.write(f"# Made by: {command} (from the front before and the named sets)\n")
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(_header())
        for point in front:
            shown = [_stored(q, point.inputs[q.name]) for q in QUANTITIES]
            writer.writerow(
                [f"{point.contact:g}", f"{point.level:g}", f"{point.others:.5g}"]
                + [point.inputs.cleanliness.value]
                + shown
                + [f"{value:.5g}" for value in point.values]
            )


def read_front(path: Path = FRONT_FILE) -> list[Point]:
    """Return the stored front, or nothing where there is none."""
    if not path.exists():
        return []
    lines = path.read_text(encoding="utf-8").splitlines()
    rows = csv.DictReader(line for line in lines if not line.startswith("#"))
    return [_point(row) for row in rows]


def command_of(path: Path = FRONT_FILE) -> str:
    """Return the first line of a stored front: the command that made it."""
    return path.read_text(encoding="utf-8").partition("\n")[0].removeprefix("# ")


def figure(front: Sequence[Point], bands: Mapping[str, FloatArray]) -> Figure:
    """Return the picture of the front, with sets by their TARGETS over the phase."""
    made, (axes,) = canvas(1, height=4.2)
    for contact, color in zip(CONTACTS, (BLUE, ORANGE), strict=True):
        points = [point for point in front if point.contact == contact]
        axes.plot(
            [point.rise for point in points],
            [point.others for point in points],
            ".-",
            color=color,
            label=f"best of one phase, contact up to {contact / 1e6:.0f} MN m/rad",
        )
    for name, band in bands.items():
        rise, others = band[:, HALF], misfit_of_the_others(band.mean(axis=0))
        axes.plot([rise.min(), rise.max()], [others, others], color=GREY, linewidth=0.8)
        axes.plot(rise.mean(), others, "s", color=GREY, markersize=3)
        at = (float(rise.max()), float(others))
        axes.annotate(name, at, xytext=(4, -2), textcoords="offset points", fontsize=7)
    axes.plot(
        [], [], "s-", color=GREY, markersize=3, label="named sets over all phases"
    )
    axes.axvline(TARGETS[HALF].lowest, color=RED, linestyle="--", label="paper")
    axes.set_yscale("log")
    axes.set_xlabel("rise of D at half the stiffness, %")
    axes.set_ylabel("misfit of all other results, -")
    axes.legend(loc="lower right", bbox_to_anchor=(0.93, 0.0))
    return made


def _at_least(level: float) -> Objective:
    """Return the misfit of the others, with a price on falling short of a rise."""

    def objective(values: FloatArray) -> FloatArray:
        rise, tolerance = values[:, HALF], TARGETS[HALF].tolerance
        short = np.maximum(level - rise, 0) + np.maximum(rise - _MOST, 0)
        total: FloatArray = misfit_of_the_others(values) + _PRICE * short / tolerance
        return np.where(np.isfinite(total), total, 1e6)

    return objective


def _header() -> list[str]:
    inputs = [f"{q.name} [{q.unit or '-'}]" for q in QUANTITIES]
    values = [f"{target.name} [{target.unit}]" for target in TARGETS]
    limits = ["contact at most [N m/rad]", "rise at least [%]", "misfit of the others"]
    return [*limits, "cleanliness", *inputs, *values]


def _point(row: dict[str, str]) -> Point:
    cells = list(row.values())
    n = len(NAMES)
    numbers = zip(QUANTITIES, cells[4 : 4 + n], strict=True)
    values = tuple(quantity.to_si(float(cell)) for quantity, cell in numbers)
    return Point(
        contact=float(cells[0]),
        level=float(cells[1]),
        others=float(cells[2]),
        inputs=Inputs(values, Cleanliness(cells[3])),
        values=tuple(float(cell) for cell in cells[4 + n :]),
    )

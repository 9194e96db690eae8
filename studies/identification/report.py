"""The study as it is shown: on the screen, in a page, and as comparisons."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.figure import Figure
from rich.markup import escape
from rich.table import Table

from coupling_design.machine.machine import Case
from coupling_design.report.words.numbers import significant
from studies.command import Study
from studies.identification.evidence import COMPROMISE, Evidence, examine, quick
from studies.identification.parameters import (
    NAMES,
    QUANTITIES,
    SHIPPED,
)
from studies.identification.rows import (
    Rows,
    all_rows,
    bands,
    directions,
    fitted,
    markdown,
    side_by_side,
    values_of_sets,
)
from studies.identification.targets import HALF, TARGETS, contributions
from studies.identification.trade_off import CONTACTS, Point, command_of, figure
from studies.judgement import within, within_share
from tests.verification.comparison import Comparison

_WELL, _HARDLY = 0.8, 0.4
# Changes of D are held within a tenth, the gap's influence within three points.
_GAP, _GAP_POINTS = "D at 0.3 mm over tight fit", 3.0
_COMPARED = (
    "D, present coupling",
    "D at half the stiffness",
    _GAP,
    "peak Fc, high stiffness",
    "D, high stiffness",
)


def comparisons(case: Case) -> tuple[Comparison, ...]:
    """Return the shipped results, averaged over the crank angle, beside the paper's."""
    found = examine(case)
    means = found.shipped.band.mean(axis=0)
    rows = []
    for target, ours in zip(TARGETS, means.tolist(), strict=True):
        arguments = (
            f"{target.name}, mean over the crank angle",
            target.paper,
            target.lowest,
            ours,
            target.unit,
        )
        if target.name == _GAP:
            rows.append(within(*arguments, _GAP_POINTS))
        elif target.name in _COMPARED:
            why = " ".join(found.explanation) if target is TARGETS[HALF] else ""
            rows.append(within_share(*arguments, why))
    return tuple(rows)


def fragment(case: Case, drawing: str) -> str:
    """Return the study in Markdown, with a link to the file of its figure."""
    found = examine(case)
    one, other = (directions(n, d) for n, d in found.determined.items())
    parts = [
        _heading(side_by_side(found)),
        _heading(bands(found)),
        _heading(values_of_sets(found)),
        *(f"* `{s.named.name}`: {s.named.purpose}" for s in found.sets.values()),
        _heading(fitted(found)),
        "\n\n".join(determination(found)),
        _heading(one),
        _heading(other),
        "#### Why half the stiffness costs less than the paper says",
        "\n\n".join(found.explanation),
        "\n\n".join(of_the_front(found)),
        f"![Misfit of all other results over the rise of D]({drawing})",
    ]
    return "\n\n".join(parts) + "\n"


def determination(found: Evidence) -> Sequence[str]:
    """Return in words what is pinned, what is not, and what trades off."""
    about = found.determined[SHIPPED]
    words = [quantity.words for quantity in QUANTITIES]
    shares = dict(zip(words, about.determined.tolist(), strict=True))
    well = [f"{w} ({100 * s:.0f} %)" for w, s in shares.items() if s >= _WELL]
    hardly = [f"{w} ({100 * s:.0f} %)" for w, s in shares.items() if s < _HARDLY]
    other = found.determined[COMPROMISE]
    contact = NAMES.index("contact_stiffness")
    return (
        f"Of {len(words)} inputs the results pin {about.n_pinned} combinations better "
        f"than their bounds do. Well determined, by the share of the bounds' variance "
        f"that they take away: {', '.join(well)}. Hardly: {', '.join(hardly)}.",
        f"With a stiff contact (set '{COMPROMISE}') {other.n_pinned} are pinned, and "
        f"the contact stiffness to {100 * other.determined[contact]:.0f} % instead of "
        f"{100 * about.determined[contact]:.0f} %: what half the stiffness costs "
        "depends on it there.",
    )


def of_the_front(found: Evidence) -> Sequence[str]:
    """Return what the front says, and how it was made."""
    said = []
    for contact in CONTACTS:
        points = [p for p in found.front if p.contact == contact]
        reached = [p for p in points if abs(p.rise - TARGETS[HALF].lowest) <= 9.1]
        least = min(points, key=lambda p: p.others)
        words = (
            f"Contact up to {contact / 1e6:.0f} MN m/rad: with a rise of "
            f"{least.rise:+.0f} % the other results' misfit is {least.others:.2g}"
        )
        if reached:
            best = min(reached, key=lambda p: p.others)
            words += (
                f", with {best.rise:+.0f} % it is {best.others:.3g} "
                f"({best.inputs.cleanliness.value} grease), most of it {_worst(best)}"
            )
        said.append(words + ".")
    return (*said, "1 is one result off by one tolerance. " + command_of() + ".")


def _worst(point: Point) -> str:
    """Return the result, other than half the stiffness, that a point misses most."""
    adds = contributions(np.array(point.values))
    adds[HALF] = 0.0
    i = int(adds.argmax())
    target = TARGETS[i]
    return (
        f"from {target.name}: {significant(point.values[i])} {target.unit}, in the "
        f"paper {target.paper}"
    )


def tables(found: Evidence) -> Sequence[Table]:
    """Return every table."""
    made = []
    for rows in all_rows(found):
        one = Table(title=rows.title, title_justify="left")
        for i, column in enumerate(rows.columns):
            one.add_column(column, justify="left" if i == 0 else "right")
        for cells in rows.cells:
            one.add_row(*map(escape, cells))
        made.append(one)
    return made


def figures(found: Evidence) -> Mapping[str, Figure]:
    """Return the picture of the front."""
    bands = {name: one.band for name, one in found.sets.items()}
    return {"trade_off": figure(found.front, bands)}


def findings(found: Evidence) -> Sequence[str]:
    """Return what the study says, in sentences."""
    return (*determination(found), *found.explanation, *of_the_front(found))


def _heading(rows: Rows) -> str:
    return f"#### {rows.title}\n\n{markdown(rows)}"


STUDY = Study(
    "Identification of the inputs that the paper does not print",
    examine,
    tables,
    figures,
    findings,
)
QUICK_STUDY = dataclasses.replace(STUDY, examine=quick)

"""The report's tables as rows of text, the same for the screen and for a page."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from coupling_design.arithmetic import FloatArray
from coupling_design.report.words.numbers import significant
from studies.identification.evidence import STEPS, Evidence, names_of_targets
from studies.identification.identifiability import (
    Identifiability,
    describe,
    input_words,
    ranges,
    target_words,
)
from studies.identification.parameters import QUANTITIES
from studies.identification.targets import (
    TARGETS,
    misfit,
    misfit_of_the_others,
    residuals,
)

_DIGITS = 3


@dataclass(frozen=True)
class Rows:
    """A table: its title, its columns and its cells."""

    title: str
    columns: tuple[str, ...]
    cells: tuple[tuple[str, ...], ...]


def all_rows(found: Evidence) -> tuple[Rows, ...]:
    """Return every table of the report."""
    return (
        fitted(found),
        results(found),
        side_by_side(found),
        bands(found),
        values_of_sets(found),
        *(directions(name, each) for name, each in found.determined.items()),
    )


def fitted(found: Evidence) -> Rows:
    """Return the shipped values, their bounds, and how well each is determined."""
    one = found.shipped.named
    about = found.determined[one.name]
    lines = zip(
        QUANTITIES, one.inputs.values, ranges(about), about.determined, strict=True
    )
    return Rows(
        f"Fitted inputs, set '{one.name}', {one.inputs.cleanliness.value} grease",
        (
            *("input", "unit", "bounds", "value", "one deviation", "determined, %"),
            "why these bounds",
        ),
        tuple(
            (
                quantity.words,
                quantity.unit or "-",
                f"{quantity.lowest:.3g} to {quantity.highest:.3g}",
                significant(quantity.from_si(value)),
                f"{significant(low, _DIGITS)} to {significant(high, _DIGITS)}",
                f"{100 * share:.0f}",
                quantity.reason,
            )
            for quantity, value, (low, high), share in lines
        ),
    )


def results(found: Evidence) -> Rows:
    """Return the shipped set's results and residuals."""
    one = found.shipped
    left = residuals(one.values[0])
    mean = one.band.mean(axis=0)
    return Rows(
        f"Results and residuals, set '{one.named.name}'",
        ("result", "paper", "ours", "off, tolerances", "tolerance", "mean over angle"),
        tuple(
            (
                name,
                target.paper,
                significant(float(one.values[0, i])),
                f"{left[i]:+.1f}" if left[i] else "0",
                significant(target.tolerance, 2),
                significant(float(mean[i])),
            )
            for i, (name, target) in enumerate(
                zip(names_of_targets(), TARGETS, strict=True)
            )
        ),
    )


def side_by_side(found: Evidence) -> Rows:
    """Return every result of every set, at both steps where they differ."""
    sets = list(found.sets.values())
    names = zip(names_of_targets(), TARGETS, strict=True)
    lines = [
        (name, target.paper, *(_both(one.values[:, i]) for one in sets))
        for i, (name, target) in enumerate(names)
    ]
    further = [
        (name, "", *(_both(np.array(one.more[name])) for one in sets))
        for name in sets[0].more
    ]
    sums = [
        ("misfit [-]", "0", *(_both(misfit(one.values)) for one in sets)),
        (
            "misfit without half the stiffness [-]",
            "0",
            *(_both(misfit_of_the_others(one.values)) for one in sets),
        ),
    ]
    steps = " / ".join(STEPS)
    return Rows(
        f"Named sets side by side, at {steps} where they differ",
        ("result", "paper", *found.sets),
        (*lines, *further, *sums),
    )


def bands(found: Evidence) -> Rows:
    """Return mean and range of each result over the crank angle."""
    sets = list(found.sets.values())
    lines = [
        (name, target.paper, *(_band(one.band[:, i]) for one in sets))
        for i, (name, target) in enumerate(
            zip(names_of_targets(), TARGETS, strict=True)
        )
        if np.isfinite(target.spread)
    ]
    means = [one.band.mean(axis=0) for one in sets]
    sums = [
        (f"{words} of the means [-]", "0", *(_short(float(f(mean))) for mean in means))
        for words, f in (
            ("misfit", misfit),
            ("misfit without half the stiffness", misfit_of_the_others),
        )
    ]
    return Rows(
        f"Mean (least to most) over {len(sets[0].band)} crank angles at the start",
        ("result", "paper", *found.sets),
        (*lines, *sums),
    )


def values_of_sets(found: Evidence) -> Rows:
    """Return the inputs of every set."""
    sets = [one.named.inputs for one in found.sets.values()]
    lines = [
        (
            f"{q.words} [{q.unit or '-'}]",
            *(significant(q.from_si(inputs[q.name])) for inputs in sets),
        )
        for q in QUANTITIES
    ]
    classes = ("cleanliness", *(inputs.cleanliness.value for inputs in sets))
    return Rows(
        "Inputs of the named sets",
        ("input", *found.sets),
        (*lines, classes),
    )


def directions(name: str, found: Identifiability) -> Rows:
    """Return which combinations of inputs the results pin, the best first."""
    return Rows(
        f"What the results pin near set '{name}'",
        ("times better than the bounds", "combination of inputs", "by the results"),
        tuple(_directions(found)),
    )


def _directions(found: Identifiability) -> Iterator[tuple[str, str, str]]:
    for i, strength in enumerate(found.strengths):
        yield (
            significant(float(strength), 2),
            describe(found.directions[i], input_words()),
            describe(found.results[:, i], target_words()),
        )


def _both(values: FloatArray) -> str:
    """Return a result at the two steps, once where they agree."""
    texts = [_short(float(value)) for value in values]
    return texts[0] if texts[0] == texts[-1] else " / ".join(texts)


def _band(values: FloatArray) -> str:
    mean, low, high = (_short(float(f(values))) for f in (np.mean, np.min, np.max))
    return mean if low == high else f"{mean} ({low} to {high})"


def _short(value: float) -> str:
    return "0" if abs(value) < 1e-5 else significant(value, _DIGITS)


def markdown(rows: Rows, omitted: Sequence[str] = ()) -> str:
    """Return a table in Markdown, without the columns named."""
    kept = [i for i, name in enumerate(rows.columns) if name not in omitted]
    head = [rows.columns[i] for i in kept]
    lines = [head, ["---"] * len(kept)]
    lines += [[row[i] for i in kept] for row in rows.cells]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)

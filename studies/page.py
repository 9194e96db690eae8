"""The validation as a page of Markdown, the same for the same numbers."""

from __future__ import annotations

import math
import os
from collections.abc import Iterator, Sequence
from pathlib import Path

from coupling_design.report.words.numbers import percent, significant
from studies.collection import Illustration, Part
from studies.judgement import Contrast
from tests.verification.comparison import Comparison

INTRODUCTION = """\
# Validation

Every number on this page is written by `make validation`; nothing is typed by hand.
A row agrees when ours differs from the published value by no more than the source's own
precision. For the paper's results that is a tenth of the value, three percentage points
for the influence of the gap, and the sign where it gives only a direction. A difference
of `0` is below a hundredth of that precision.
"""


def write_page(parts: Sequence[Part], header: Sequence[str], page: Path) -> str:
    """Return the page's text; figures are linked relative to where `page` lies."""
    blocks = [INTRODUCTION, *header, _summary(parts), *_disagreements(parts)]
    for part in parts:
        blocks.append(f"## {part.title}")
        blocks.extend(_part_blocks(part, page))
    return "\n\n".join(block.strip() for block in blocks) + "\n"


def _summary(parts: Sequence[Part]) -> str:
    """Return how many comparisons of each part agree."""
    counted = [(part.title, part.comparisons) for part in parts if part.comparisons]
    everything = tuple(row for _, found in counted for row in found)
    rows = [
        (title, str(len(found)), str(sum(map(agrees, found))))
        for title, found in (*counted, ("all", everything))
    ]
    return "## Summary\n\n" + _table(("part", "compared", "agree"), rows)


def agrees(comparison: Comparison) -> bool:
    """Return whether a comparison agrees."""
    return bool(comparison.agrees)


def _disagreements(parts: Sequence[Part]) -> Iterator[str]:
    """Yield what disagrees or is missing, or that nothing does."""
    yield "## Where they disagree"
    lines = [
        f"* **{row.quantity}** ({row.source}): published {number(row, row.published)}, "
        f"ours {number(row, row.ours)} {row.unit}. {row.remark}".rstrip()
        for part in parts
        for row in part.comparisons
        if not row.agrees
    ]
    lines += [f"* {part.title}: {part.missing}" for part in parts if part.missing]
    yield "\n".join(lines) or "Nowhere."
    yield (
        "Not compared: the paper's 0.66 % between model and test at resonance; its "
        "measurement (table 2) is lost."
    )


def _part_blocks(part: Part, page: Path) -> Iterator[str]:
    """Yield the tables and figures of a part."""
    if part.missing:
        yield f"Could not be compared: {part.missing}"
    if part.comparisons:
        yield _comparison_table(part.comparisons)
    if part.contrasts:
        yield _contrast_table(part.contrasts)
    if part.text:
        yield _with_links(part.text, part.drawings, page)
    for illustration in part.illustrations:
        yield from _illustration_blocks(illustration, page)


def _comparison_table(rows: Sequence[Comparison]) -> str:
    """Return comparisons as a table."""
    titles = (
        "quantity",
        "source",
        "published",
        "ours",
        "difference",
        "agrees",
        "remark",
    )
    return _table(
        titles,
        [
            (
                row.quantity + ("" if row.unit in ("-", "sign") else f" [{row.unit}]"),
                row.source,
                number(row, row.published),
                number(row, row.ours),
                difference(row),
                "yes" if row.agrees else "**no**",
                row.remark,
            )
            for row in rows
        ],
    )


def _contrast_table(rows: Sequence[Contrast]) -> str:
    """Return contrasts as a table."""
    titles = (
        "question",
        "one reading",
        "the other",
        "unit",
        "taken here",
        "what follows",
    )
    return _table(
        titles,
        [
            (
                row.question,
                f"{row.first_reading}: {significant(row.first, 5)}",
                f"{row.second_reading}: {significant(row.second, 5)}",
                row.unit,
                row.ours,
                row.remark,
            )
            for row in rows
        ],
    )


def _illustration_blocks(illustration: Illustration, page: Path) -> Iterator[str]:
    """Yield a study's title, sentences and figures."""
    yield f"### {illustration.title}"
    if illustration.findings:
        yield "\n".join(f"* {sentence}" for sentence in illustration.findings)
    for file in illustration.files:
        yield f"![{illustration.title}]({_link(file, page)})"


def _with_links(text: str, drawings: Sequence[Path], page: Path) -> str:
    """Return text whose paths of drawings are seen from where the page lies."""
    for file in drawings:
        text = text.replace(file.as_posix(), _link(file, page))
    return text


def _link(file: Path, page: Path) -> str:
    """Return a file's path as seen from where the page lies."""
    return Path(os.path.relpath(file.resolve(), page.resolve().parent)).as_posix()


def number(row: Comparison, value: float) -> str:
    """Return a value with as many digits as its source's precision calls for."""
    if row.unit == "sign":
        return {1: "more", -1: "less", 0: "the same"}[int(value)]
    if row.tolerance == 0 or row.published == 0 or not math.isfinite(value):
        return significant(value, 5)
    digits = math.ceil(math.log10(abs(row.published) / row.tolerance)) + 1
    return significant(value, min(max(digits, 4), 12))


def difference(row: Comparison) -> str:
    """Return the difference, and relative to what is published in percent.

    Zero where it is lost in the tolerance.
    """
    if row.unit == "sign":
        return "0" if row.agrees else "opposite"
    if abs(row.difference) <= row.tolerance / 100:
        return "0"
    sign = "+" if row.difference > 0 else "-"
    text = sign + significant(abs(row.difference), 2)
    if row.published == 0 or row.unit == "%":
        return text
    return f"{text} ({percent(row.difference / abs(row.published))} %)"


def _table(titles: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """Return a table of Markdown."""
    lines = [titles, ["---"] * len(titles), *rows]
    return "\n".join(f"| {' | '.join(map(_escaped, line))} |" for line in lines)


def _escaped(text: str) -> str:
    """Return text that does not end a table's cell."""
    return text.replace("|", "\\|").replace("\n", " ")

from pathlib import Path

import pytest

from studies.collection import Illustration, Part, first_line, verification_part
from studies.judgement import Contrast, direction, within, within_share
from studies.page import difference, number, write_page
from tests.verification.comparison import Comparison

PAGE = Path("VALIDATION.md")


def compared(published, ours, tolerance, unit="Hz", remark=""):
    return Comparison(
        "frequency", "book | page 3", published, ours, unit, tolerance, remark
    )


def page(*parts):
    return write_page(parts, ("Case: test.",), PAGE)


@pytest.mark.parametrize(
    ("published", "ours", "tolerance", "text", "off"),
    [
        (176.1, 176.077, 0.05, "176.08", "-0.023 (-0.01 %)"),
        (90.0, 45.0, 9.0, "45.00", "-45 (-50.00 %)"),
        (1.0, 1.0 + 1e-13, 1e-7, "1.0000000", "0"),
        (0.25, 0.25, 0.0, "0.25000", "0"),
    ],
)
def test_digits_follow_the_tolerance(published, ours, tolerance, text, off):
    row = compared(published, ours, tolerance)

    assert number(row, ours) == text
    assert difference(row) == off


def test_a_page_says_what_disagrees_and_why():
    part = Part(
        "Part",
        (compared(10.0, 10.0, 0.1), compared(10.0, 20.0, 1.0, remark="Too fast.")),
    )
    text = page(part)

    assert "| Part | 2 | 1 |" in text
    assert "published 10.00, ours 20.00 Hz. Too fast." in text
    assert "| **no** | Too fast. |" in text
    assert "book \\| page 3" in text


def test_a_page_without_disagreement():
    assert "Nowhere." in page(Part("Part", (compared(1.0, 1.0, 0.1),)))


def test_a_missing_part_is_named():
    part = verification_part("tests.verification.no_such_module")

    assert "no_such_module" in part.missing
    assert part.missing in page(part)


def test_contrasts_and_figures():
    contrast = Contrast("Which?", "this", 1.0, "that", 2.0, "N", "this", "So.")
    drawing = Illustration("Drawing", ("It rises.",), (Path("studies/figures/a.svg"),))
    text = page(Part("Part", contrasts=(contrast,), illustrations=(drawing,)))

    assert "| Which? | this: 1.0000 | that: 2.0000 | N | this | So. |" in text
    assert "* It rises." in text
    assert "![Drawing](studies/figures/a.svg)" in text


def test_a_reason_is_given_only_where_one_is_needed():
    near = within_share("D", "fig. 9", 100.0, 109.0, "%", "why")
    far = within_share("D", "fig. 9", 100.0, 111.0, "%", "why")
    off = within("D", "fig. 9", 100.0, 111.0, "%", 20.0, "why")

    assert [row.agrees for row in (near, far, off)] == [True, False, True]
    assert [row.remark for row in (near, far, off)] == ["", "why", ""]


@pytest.mark.parametrize(("ours", "agrees"), [(-3.0, True), (0.0, False), (2.0, False)])
def test_directions(ours, agrees):
    row = direction("D", "fig. 9", -1, ours, "")

    assert row.agrees is agrees
    assert difference(row) == ("0" if agrees else "opposite")
    assert number(row, row.published) == "less"


def test_first_line():
    assert first_line("Say it.\n\nMore.") == "Say it"

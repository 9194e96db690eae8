from pathlib import Path

import pytest

from coupling_design.checks.usual_ranges import USUAL_RANGES

PAGE = Path(__file__).parents[2] / "docs" / "plausible.md"


@pytest.mark.parametrize("row", USUAL_RANGES, ids=lambda row: row.path)
def test_the_page_has_each_usual_range(row):
    line = (
        f"| {row.quantity} | {row.lowest:g} to {row.highest:g} {row.unit} "
        f"| {row.reason} |"
    )
    assert line in PAGE.read_text(encoding="utf-8").splitlines()

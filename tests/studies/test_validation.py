"""The committed page against one written now; platforms differ in the last digits."""

from pathlib import Path

import pytest

from studies.validation import validate

ROOT = Path(__file__).parents[2]
CASE, PAGE = Path("cases/16v280.yaml"), ROOT / "VALIDATION.md"


def rows(text):
    """Return the cells of each row of a comparison table, by quantity and source."""
    found = {}
    for line in text.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split(" | ")]
        if len(cells) == 7 and cells[5] in ("yes", "**no**"):
            found[cells[0], cells[1]] = cells
    return found


def value(text):
    try:
        return float(text)
    except ValueError:
        return text


@pytest.mark.slow
def test_the_page_is_up_to_date(tmp_path, monkeypatch):
    monkeypatch.chdir(ROOT)
    page = tmp_path / "VALIDATION.md"
    validate(CASE, tmp_path / "figures", page)

    now, kept = (rows(file.read_text(encoding="utf-8")) for file in (page, PAGE))

    assert now.keys() == kept.keys(), "run make validation"
    for key, cells in now.items():
        assert value(cells[2]) == value(kept[key][2])
        expected = value(kept[key][3])
        if isinstance(expected, float):
            expected = pytest.approx(expected, rel=1e-3, abs=1e-6)
        assert value(cells[3]) == expected, f"{key}: run make validation"
        assert cells[5] == kept[key][5]


@pytest.mark.slow
def test_the_page_is_the_same_twice(tmp_path, monkeypatch):
    monkeypatch.chdir(ROOT)
    files = []
    for attempt in ("first", "second"):
        folder = tmp_path / attempt
        folder.mkdir()
        validate(CASE, folder / "figures", folder / "VALIDATION.md")
        files.append(sorted(p for p in folder.rglob("*") if p.is_file()))

    assert [p.name for p in files[0]] == [p.name for p in files[1]]
    assert [p.read_bytes() for p in files[0]] == [p.read_bytes() for p in files[1]]
    assert all(p.stat().st_size < 150e3 for p in files[0])

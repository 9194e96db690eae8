"""The site builds without a warning, and needs no network to be read."""

import importlib.util
import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
MISSING = [
    name
    for name in ("mkdocs", "material", "pymdownx", "latex2mathml")
    if importlib.util.find_spec(name) is None
]
# What a page would fetch by itself; a link that a reader follows is none.
_FETCHED = re.compile(
    r"<(?:script|img|iframe)\b[^>]*\bsrc=\"?(?:https?:)?//"
    r"|<link\b(?=[^>]*rel=\"?(?:stylesheet|preconnect|preload))[^>]*href=\"?https?://"
)

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(bool(MISSING), reason=f"not installed: {', '.join(MISSING)}"),
]


@pytest.fixture(scope="module")
def site(tmp_path_factory):
    directory = tmp_path_factory.mktemp("site")
    built = subprocess.run(
        [sys.executable, "-m", "mkdocs", "build", "--strict", "-d", str(directory)],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
    )
    assert built.returncode == 0, built.stdout + built.stderr
    return directory


def test_builds_without_a_warning(site):
    assert (site / "index.html").is_file()


def test_nothing_is_fetched_from_elsewhere(site):
    fetching = [
        str(page.relative_to(site))
        for page in site.rglob("*.html")
        if _FETCHED.search(page.read_text(encoding="utf-8"))
    ]
    assert fetching == []


def test_formulas_are_drawn(site):
    theory = (site / "theory.html").read_text(encoding="utf-8")
    assert theory.count("<math") > 100
    assert "```math" not in theory
    assert "$`" not in theory

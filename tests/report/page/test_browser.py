"""The report in a real browser: drawn without complaint, and printed."""

import re
import shutil
import subprocess

import pytest

from coupling_design.report.page.page import html_report

NAMES = ("chromium", "chromium-browser", "google-chrome")
BROWSER = next(filter(None, map(shutil.which, NAMES)), None)
OPTIONS = (
    "--headless",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--virtual-time-budget=30000",
    "--enable-logging=stderr",
)

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(BROWSER is None, reason="no Chromium on this machine"),
]


@pytest.fixture(scope="module")
def report(drawn, speed_map, tmp_path_factory):
    path = tmp_path_factory.mktemp("report") / "report.html"
    path.write_text(html_report(drawn, speed_map), encoding="utf-8")
    return path


@pytest.fixture
def browse(tmp_path):
    """Return what opens a page, and gives standard output and the console's lines."""

    def run(page, *options):
        profile = f"--user-data-dir={tmp_path / 'profile'}"
        command = [BROWSER, *OPTIONS, profile, *options, page.as_uri()]
        done = subprocess.run(command, capture_output=True, text=True, timeout=120)
        console = [line for line in done.stderr.splitlines() if "CONSOLE" in line]
        return done.stdout, console

    return run


def test_every_figure_is_drawn_without_complaint(report, browse):
    dom, console = browse(report, "--dump-dom")
    assert console == []
    figures = len(re.findall(r"<figure ", dom))
    assert f'data-figures="{figures}"' in dom
    drawings = re.split(r"<figure ", dom)[1:]
    assert all('class="main-svg"' in drawing for drawing in drawings)
    assert all('class="trace' in d or "hm" in d for d in drawings)


def test_the_browser_would_complain_of_a_broken_script(report, browse, tmp_path):
    broken = tmp_path / "broken.html"
    text = report.read_text(encoding="utf-8")
    broken.write_text(text.replace("Plotly.newPlot", "Plotly.nothing"), "utf-8")
    assert browse(broken, "--dump-dom")[1] != []


def test_it_prints(report, browse, tmp_path):
    printed = tmp_path / "report.pdf"
    browse(report, "--no-pdf-header-footer", f"--print-to-pdf={printed}")
    content = printed.read_bytes()
    assert content.startswith(b"%PDF")
    assert len(re.findall(rb"/Type\s*/Page\b", content)) > 10

import io
import os
import sys

import pytest
from rich.text import Text

from coupling_design.report.console.console import (
    make_error_console,
    make_report_console,
    plain_text,
    print_report,
)
from coupling_design.report.console.progress import show_progress
from coupling_design.report.console.report import render_outcome


class Terminal(io.StringIO):
    def isatty(self):
        return True


@pytest.fixture
def pipe(monkeypatch):
    """Return what puts the standard streams into a pipe; call it in the test."""
    return lambda: _streams(monkeypatch, io.TextIOWrapper(io.BytesIO(), "ascii"))


@pytest.fixture
def terminal(monkeypatch):
    """Return what puts the standard streams on a terminal; call it in the test."""
    monkeypatch.setenv("TERM", "xterm-256color")
    monkeypatch.setattr(os, "get_terminal_size", lambda *_: os.terminal_size((132, 40)))
    return lambda: _streams(monkeypatch, Terminal())


def _streams(monkeypatch, stream):
    monkeypatch.setattr(sys, "stdout", stream)
    monkeypatch.setattr(sys, "stderr", stream)
    return stream


def test_a_pipe_is_100_wide(pipe):
    pipe()
    assert make_report_console().width == 100
    assert make_error_console().width == 100


@pytest.mark.parametrize(
    ("columns", "width"), [("120", 120), ("nonsense", 100), ("", 100), ("40", 80)]
)
def test_columns_sets_the_width(pipe, monkeypatch, columns, width):
    monkeypatch.setenv("COLUMNS", columns)
    pipe()
    assert make_report_console().width == width


def test_a_screen_has_its_own_width(terminal):
    terminal()
    assert make_report_console().width == 132


def test_colour_on_a_screen_and_none_if_unwanted(terminal, monkeypatch):
    stream = terminal()
    make_report_console().print(Text("FAIL", style="bold red"))
    monkeypatch.setenv("NO_COLOR", "1")
    make_report_console().print(Text("FAIL", style="bold red"))
    coloured, plain = stream.getvalue().splitlines()
    assert "31" in coloured
    assert plain == "\x1b[1mFAIL\x1b[0m"


def test_a_pipe_gets_no_escapes_and_any_character(pipe):
    stream = pipe()
    make_report_console().print(Text("Kühlung [1] :x:", style="red"))
    stream.seek(0)
    assert stream.read().strip() == "K\\xfchlung [1] :x:"


def test_plain_text_ignores_the_terminal(monkeypatch):
    monkeypatch.setenv("FORCE_COLOR", "1")
    monkeypatch.setenv("COLUMNS", "30")
    assert plain_text(Text("wide " * 18, style="red")) == ("wide " * 18).rstrip() + "\n"


def test_a_reader_who_leaves_does_not_end_the_run(monkeypatch):
    reader, writer = os.pipe()
    with os.fdopen(writer, "w") as stream:
        os.close(reader)
        monkeypatch.setattr(sys, "stdout", stream)
        console = make_report_console()
        console.print("lost")
        console.print("still running")


def test_progress_says_nothing_in_a_pipe(pipe):
    stream = pipe()
    with show_progress() as progress:
        progress("step 1")
    stream.seek(0)
    assert stream.read() == ""


def test_progress_shows_the_step_on_a_terminal(terminal):
    stream = terminal()
    with show_progress() as progress:
        progress("step 1 of 5")
    assert "step 1 of 5" in stream.getvalue()


class Counted:
    """A report that counts how often it is laid out."""

    def __init__(self, report):
        self.report, self.times = report, 0

    def __rich_console__(self, console, options):
        self.times += 1
        yield self.report


@pytest.mark.parametrize(
    ("encoding", "columns", "times"),
    [("utf-8", "", 1), ("utf-8", "120", 2), ("ascii", "", 2), ("latin-1", "100", 2)],
)
def test_a_report_for_a_pipe_is_laid_out_once(
    monkeypatch, outcome, encoding, columns, times
):
    monkeypatch.setenv("COLUMNS", columns)
    report = Counted(render_outcome(outcome))
    at_once, separately = io.BytesIO(), io.BytesIO()
    _streams(monkeypatch, io.TextIOWrapper(at_once, encoding, write_through=True))
    text = print_report(make_report_console(), report)
    _streams(monkeypatch, io.TextIOWrapper(separately, encoding, write_through=True))
    make_report_console().print(report.report)

    assert report.times == times
    assert at_once.getvalue() == separately.getvalue()
    assert text == plain_text(report.report)


def test_a_report_on_a_screen_keeps_its_colours(terminal, outcome):
    stream = terminal()
    text = print_report(make_report_console(), render_outcome(outcome))
    assert "\x1b[" in stream.getvalue()
    assert text == plain_text(render_outcome(outcome))

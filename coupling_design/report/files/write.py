"""The report's files: a reader finds the old one or the new one, never half of one."""

from __future__ import annotations

import os
import secrets
from pathlib import Path

from coupling_design.errors import OutputError
from coupling_design.flow.outcome import DesignOutcome
from coupling_design.flow.speed_map import SpeedMap
from coupling_design.report.console.console import plain_text
from coupling_design.report.console.report import render_outcome
from coupling_design.report.files.json import build_document, document_text
from coupling_design.report.page.library import can_write_html
from coupling_design.report.page.page import html_report


def prepare_directory(directory: Path) -> None:
    """Make a directory and see that it can be written to, before the long work."""
    probe = _beside(directory / "probe")
    try:
        directory.mkdir(parents=True, exist_ok=True)
        probe.touch(exist_ok=False)
        probe.unlink()
    except OSError as error:
        raise _output_error(directory, error) from None


def write_files(
    outcome: DesignOutcome,
    directory: Path,
    speed_map: SpeedMap | None = None,
    report: str | None = None,
) -> tuple[Path, ...]:
    """Write design.json, report.txt and report.html; return their paths.

    The last is left out without histories to draw, and where `can_write_html` says no.
    `report` is the report as plain text, if it has been laid out already.
    """
    if report is None:
        report = plain_text(render_outcome(outcome))
    texts = {
        directory / "design.json": document_text(build_document(outcome)),
        directory / "report.txt": report,
    }
    if outcome.histories and can_write_html():
        texts[directory / "report.html"] = html_report(outcome, speed_map)
    for path, text in texts.items():
        write_atomically(path, text)
    return tuple(texts)


def write_atomically(path: Path, text: str) -> None:
    """Write a file in one go: if that fails, what was there before stays."""
    # Half a character, from a file name of another encoding, is written as \\udcxx.
    content = text.encode("utf-8", errors="backslashreplace")
    temporary = _beside(path)
    try:
        try:
            with temporary.open("xb") as file:
                file.write(content)
                file.flush()
                os.fsync(file.fileno())
            temporary.replace(path)
        finally:
            temporary.unlink(missing_ok=True)
    except OSError as error:
        raise _output_error(path, error) from None


def _beside(path: Path) -> Path:
    return path.with_name(f".{path.name}.{secrets.token_hex(4)}.tmp")


def _output_error(path: Path, error: OSError) -> OutputError:
    return OutputError(
        f"{path}: cannot be written: {error.strerror or error}; make the directory "
        "writable or name another with --output DIR"
    )

"""Names and verdicts as words."""

from __future__ import annotations

from rich.text import Text

VERDICT_STYLES = {"PASS": "bold green", "FAIL": "bold red", "SKIPPED": "bold"}


def verdict(passes: bool) -> Text:
    """Return PASS or FAIL; the colour only repeats the word."""
    word = "PASS" if passes else "FAIL"
    return Text(word, style=VERDICT_STYLES[word])


def words(name: str) -> str:
    """Return a name of the code as one reads it: `tight_fit` is tight fit."""
    return name.replace("_", " ")

"""Names and verdicts as words."""

from __future__ import annotations

from rich.text import Text

from coupling_design.parts.criterion import Verdict

VERDICT_STYLES = {
    "PASS": "bold green",
    "FAIL": "bold red",
    "SKIPPED": "bold",
    "NOT CHECKED": "bold yellow",
}


def verdict(passes: bool) -> Text:
    """Return PASS or FAIL; the colour only repeats the word."""
    word = "PASS" if passes else "FAIL"
    return Text(word, style=VERDICT_STYLES[word])


def verdict_of(verdict: Verdict) -> Text:
    """Return what became of a limit; the colour only repeats the word."""
    word = verdict.value.upper()
    return Text(word, style=VERDICT_STYLES[word])


def words(name: str) -> str:
    """Return a name of the code as one reads it: `tight_fit` is tight fit."""
    return name.replace("_", " ")

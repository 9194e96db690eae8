"""The console examples of the pages: run them, compare them, write them anew.

`python docs/tools/examples.py` compares every page, or those named, with what is
printed now; with `--write` it puts that into them.

A page is one session in an empty directory that has the shipped `cases` and
`catalogues`. Blocks of ```yaml title="FILE"``` are appended to FILE as they come, and
each ```console``` block is one command after `$ ` and its output. What is special about
a block stands before it, in YAML:

    <!-- example: {slow: true, exit: 2, show: [["Step 3", "╰"], ["^Result$", 4]]} -->

`slow` blocks take more than a few seconds, `run: false` is never run, `exit` is the
expected exit code, `edit: [FILE, OLD, NEW]` corrects a file first. `show` prints parts
only: from the line that matches a pattern to the next that matches another, or so many
lines; parts are divided by `[...]`.
"""

from __future__ import annotations

import contextlib
import io
import math
import os
import re
import shlex
import sys
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import yaml

DOCS = Path(__file__).resolve().parent.parent
ROOT = DOCS.parent
PROGRAM = "coupling-design"
CUT = "[...]"
WIDTH = "100"
# Two machines agree in what they find, not in the last digit they print of it.
TOLERANCE = 0.02
_BLOCK = re.compile(
    r"(?:<!-- example: (?P<about>\{.*?\}) -->\n+)?"
    r"(?P<fence>^(?P<indent> *)```(?P<kind>console|yaml title=\"(?P<file>[^\"]+)\")\n)"
    r"(?P<body>.*?)^(?P=indent)```$",
    re.MULTILINE | re.DOTALL,
)
_NUMBER = re.compile(r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?")
# A word or an option; not what stands for a kind of value, such as <path>.
_WORD = re.compile(r"(?<![<\w-])-{0,2}[A-Za-z][\w-]+(?!>)\b")
# What differs from run to run, or from machine to machine, by its nature.
_PASSING = re.compile(
    r"Run time|time left|sha256|conditioning|starts? is shifted|^ *-+$"
)


@dataclass(frozen=True)
class Block:
    """One block of a page: a part of a file, or a command with its output."""

    page: Path
    line: int
    span: tuple[int, int]
    body: str
    file: str | None = None
    slow: bool = False
    run: bool = True
    exit: int = 0
    edit: Sequence[str] = ()
    show: Sequence[Any] = field(default_factory=tuple)

    @property
    def command(self) -> str:
        """The command, without its prompt."""
        first = self.body.partition("\n")[0]
        return first.removeprefix("$ ") if first.startswith("$ ") else ""

    @property
    def printed(self) -> list[str]:
        """What the page says is printed."""
        return self.body.splitlines()[1:]

    @property
    def arguments(self) -> list[str] | None:
        """The program's arguments; None if the block is not to be run."""
        words = shlex.split(self.command, comments=True)
        return words[1:] if self.run and words[:1] == [PROGRAM] else None


def pages() -> list[Path]:
    """Return every page that may hold examples."""
    return sorted(p for p in DOCS.rglob("*.md") if "tools" not in p.parts)


def blocks(page: Path) -> list[Block]:
    """Return the blocks of a page in their order."""
    text = page.read_text(encoding="utf-8")
    return [_block(page, text, match) for match in _BLOCK.finditer(text)]


def _block(page: Path, text: str, match: re.Match[str]) -> Block:
    return Block(
        page=page,
        line=text.count("\n", 0, match.start("fence")) + 1,
        span=match.span("body"),
        body=match["body"],
        file=match["file"],
        **yaml.safe_load(match["about"] or "{}"),
    )


@contextlib.contextmanager
def session() -> Iterator[Path]:
    """Work in an empty directory with the shipped cases; come back afterwards."""
    before, columns = Path.cwd(), os.environ.get("COLUMNS")
    with tempfile.TemporaryDirectory() as directory:
        for shipped in ("cases", "catalogues"):
            Path(directory, shipped).symlink_to(ROOT / shipped, True)
        os.chdir(directory)
        os.environ["COLUMNS"] = WIDTH
        try:
            yield Path(directory)
        finally:
            os.chdir(before)
            os.environ.pop("COLUMNS")
            if columns is not None:
                os.environ["COLUMNS"] = columns


def call(arguments: Sequence[str]) -> tuple[int, list[str]]:
    """Return the exit code of the program and the lines it printed."""
    from coupling_design.commands.app import run

    stream = io.StringIO()
    with contextlib.redirect_stdout(stream), contextlib.redirect_stderr(stream):
        code = run(arguments)
    return code, [line.rstrip() for line in stream.getvalue().rstrip().splitlines()]


def shown(lines: Sequence[str], show: Sequence[Any]) -> list[str]:
    """Return the parts of an output that a block wants, divided by cuts."""
    if not show:
        return list(lines)
    found: list[str] = []
    reached = 0
    for start, end in show:
        first = _find(lines, start, reached)
        last = first + end - 1 if isinstance(end, int) else _find(lines, end, first)
        if first > reached:
            found.append(CUT)
        found.extend(lines[first : last + 1])
        reached = last + 1
    return found if reached >= len(lines) else [*found, CUT]


def _find(lines: Sequence[str], text: str, start: int) -> int:
    for index in range(start, len(lines)):
        if re.search(text, lines[index]):
            return index
    raise LookupError(f"no line like '{text}' is printed")


def difference(block: Block, printed: Sequence[str]) -> str:
    """Return the first line of a page that is no longer what is printed, or ''.

    Of a help text its words count: their layout is the libraries'.
    """
    written = block.printed
    if "--help" in block.command:
        new = set(_WORD.findall("\n".join(printed)))
        old = set(_WORD.findall("\n".join(written)))
        return f"other words: {', '.join(sorted(new ^ old))}" if new != old else ""
    if len(written) != len(printed):
        return f"{len(written)} lines stand there, {len(printed)} are printed"
    for old, new in zip(written, printed, strict=True):
        if not _same(old, new):
            return f"\n  there:   {old}\n  printed: {new}"
    return ""


def _same(old: str, new: str) -> bool:
    if _PASSING.search(old) and _PASSING.search(new):
        return True
    words = [" ".join(_NUMBER.sub(" # ", line).split()) for line in (old, new)]
    numbers = [[float(n) for n in _NUMBER.findall(line)] for line in (old, new)]
    return words[0] == words[1] and all(
        math.isclose(a, b, rel_tol=TOLERANCE, abs_tol=1e-15)
        for a, b in zip(*numbers, strict=True)
    )


def follow(page: Path, slow: bool) -> Iterator[tuple[Block, int, list[str]]]:
    """Yield each command of a page with its exit code and what it shows now.

    Without `slow`, a page is followed up to its first slow block that writes what a
    later one reads: those that follow are marked slow too.
    """
    with session() as directory:
        for block in blocks(page):
            if block.file is not None:
                with (directory / block.file).open("a", encoding="utf-8") as file:
                    file.write(block.body)
            elif block.arguments is not None and (slow or not block.slow):
                _edit(directory, *block.edit)
                code, lines = call(block.arguments)
                yield block, code, shown(lines, block.show)


def _edit(directory: Path, name: str = "", old: str = "", new: str = "") -> None:
    if name:
        text = (directory / name).read_text(encoding="utf-8")
        if old not in text:
            raise LookupError(f"{name} has no '{old}'")
        (directory / name).write_text(text.replace(old, new), encoding="utf-8")


def rewrite(page: Path) -> None:
    """Put what is printed now into a page."""
    text = page.read_text(encoding="utf-8")
    for block, _, lines in reversed(list(follow(page, slow=True))):
        body = "\n".join([f"$ {block.command}", *lines, ""])
        text = text[: block.span[0]] + body + text[block.span[1] :]
    page.write_text(text, encoding="utf-8", newline="\n")


def problems(page: Path, slow: bool = True) -> list[str]:
    """Return what a page says that is no longer so."""
    found = []
    for block, code, lines in follow(page, slow):
        where = f"{page.relative_to(ROOT)}:{block.line}: {block.command}"
        if code != block.exit:
            found.append(f"{where}: exit code {code}, expected {block.exit}")
        elif what := difference(block, lines):
            found.append(f"{where}: {what}")
    return found


def main(arguments: Sequence[str]) -> int:
    """Compare or rewrite pages; return 1 if any is out of date."""
    named = [Path(each).resolve() for each in arguments if each != "--write"]
    found = []
    for page in named or pages():
        if "--write" in arguments:
            rewrite(page)
        else:
            found += problems(page)
    sys.stdout.writelines(f"{problem}\n" for problem in found)
    return 1 if found else 0


if __name__ == "__main__":
    sys.path.insert(0, str(ROOT))
    sys.exit(main(sys.argv[1:]))

"""A file's bytes and text, or a sentence on why there are none."""

from __future__ import annotations

from pathlib import Path

from coupling_design.errors import CaseError


def read_bytes(path: Path, file: str) -> bytes:
    """Return what a file holds; `file` is what its user calls it."""
    try:
        if path.is_dir():
            raise CaseError([f"{file}: is a directory; name the case file in it"])
        return path.read_bytes()
    except FileNotFoundError:
        raise CaseError([f"{file}: there is no such file; check the path"]) from None
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or error
        raise CaseError([f"{file}: cannot be read: {reason}"]) from None


def decode(content: bytes, file: str) -> str:
    """Return the text that bytes spell in UTF-8."""
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = content.count(b"\n", 0, error.start) + 1
        found = content[error.start]
        raise CaseError(
            [f"{file}:{line}: not UTF-8: found the byte 0x{found:02x}; "
             "save the file as UTF-8 text"]
        ) from None  # fmt: skip

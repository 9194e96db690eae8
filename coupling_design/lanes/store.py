"""Compiled libraries, and texts, kept between runs in the user's cache directory.

A library's name holds what it was made from and a hash of its content, so one rename
puts it in place and no reader takes half a file, or another's, for a whole one.
"""

from __future__ import annotations

import contextlib
import ctypes
import hashlib
import os
import stat
import tempfile
from pathlib import Path

import platformdirs

from coupling_design.lanes.compiler import Compiler, CompilerError

_KEY_SYMBOL = "march_key"
_MOST_TEXTS = 256


def load_library(source: str, compiler: Compiler) -> ctypes.CDLL:
    """Return the library of a source, from the cache or compiled now.

    Where the cache directory cannot be used the library lives in a temporary one.
    Raises CompilerError if it cannot be compiled or loaded.
    """
    key = digest("\0".join([source, compiler.identity]).encode())[:32]
    source += f'\nconst char {_KEY_SYMBOL}[] = "{key}";\n'
    with contextlib.suppress(OSError):
        directory = _cache_directory()
        stored = _stored(directory, key)
        if stored is not None:
            return stored
        return _open(_build(source, compiler, directory, key), key)
    with tempfile.TemporaryDirectory() as temporary:
        try:
            library = _build(source, compiler, Path(temporary), key)
            return _open(library, key)  # stays loaded when its file is gone
        except OSError as error:
            raise CompilerError(f"cannot load what was compiled: {error}") from error


def load_text(key: str) -> str | None:
    """Return the text stored under a key, None if there is none or it is damaged."""
    with contextlib.suppress(OSError, ValueError):
        path = _cache_directory() / f"{key}.txt"
        _check_is_ours(path)
        stored, _, text = path.read_text(encoding="utf-8").partition("\n")
        if stored == digest(text.encode()):
            return text
    return None


def save_text(key: str, text: str) -> None:
    """Store a text under a key, as far as the cache directory can be used."""
    with contextlib.suppress(OSError):
        directory = _cache_directory()
        handle, name = tempfile.mkstemp(suffix=".part", prefix=f"{key}-", dir=directory)
        part = Path(name)
        try:
            with os.fdopen(handle, "w", encoding="utf-8") as file:
                file.write(f"{digest(text.encode())}\n{text}")
            part.replace(directory / f"{key}.txt")
        finally:
            part.unlink(missing_ok=True)
        _remove_oldest_texts(directory)


def _remove_oldest_texts(directory: Path) -> None:
    """Keep a number of texts: a sweep over numbers of a case makes one for each."""
    by_age = sorted(directory.glob("*.txt"), key=lambda path: path.stat().st_mtime)
    for path in by_age[:-_MOST_TEXTS]:
        path.unlink(missing_ok=True)


def _cache_directory() -> Path:
    """Return the directory, made if need be, or raise OSError if it is not ours."""
    directory = Path(platformdirs.user_cache_path("coupling-design")) / "compiled"
    directory.mkdir(parents=True, exist_ok=True, mode=0o700)
    _check_is_ours(directory)
    return directory


def _check_is_ours(path: Path) -> None:
    """Raise OSError if anyone else owns a path or may write to it."""
    status = path.stat(follow_symlinks=False)
    others_may_write = status.st_mode & (stat.S_IWGRP | stat.S_IWOTH)
    if status.st_uid != os.getuid() or others_may_write or path.is_symlink():
        raise PermissionError(f"{path} is open to others")


def _stored(directory: Path, key: str) -> ctypes.CDLL | None:
    """Return the library stored under a key; remove what is no such library."""
    for path in sorted(directory.glob(f"{key}-*.so")):
        try:
            _check_is_ours(path)
            if digest(path.read_bytes()) == path.stem.rpartition("-")[2]:
                return _open(path, key)
        except OSError:
            pass
        with contextlib.suppress(OSError):
            path.unlink()
    return None


def _build(source: str, compiler: Compiler, directory: Path, key: str) -> Path:
    """Compile into a directory and return the file, complete under its final name."""
    handle, name = tempfile.mkstemp(suffix=".part", prefix=f"{key}-", dir=directory)
    os.close(handle)
    part = Path(name)
    try:
        compiler.build(source, part)
        with part.open("r+b") as file:
            content = digest(file.read())
            os.fsync(file.fileno())
        part.chmod(0o700)
        return part.replace(directory / f"{key}-{content}.so")
    finally:
        part.unlink(missing_ok=True)


def _open(path: Path, key: str) -> ctypes.CDLL:
    """Load a library and make sure that it is the one, or raise OSError."""
    library = ctypes.CDLL(str(path))
    try:
        held = (ctypes.c_char * (len(key) + 1)).in_dll(library, _KEY_SYMBOL).value
    except ValueError as error:
        raise OSError(f"{path} is no march") from error
    if held != key.encode():
        raise OSError(f"{path} is another march")
    return library


def digest(content: bytes) -> str:
    """Return what tells a content from any other."""
    return hashlib.sha256(content).hexdigest()

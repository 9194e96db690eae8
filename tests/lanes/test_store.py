"""Finding a compiler, and keeping what it made."""

import os
import subprocess
import sys
import textwrap

import casadi as ca
import numpy as np
import pytest

from coupling_design.lanes import march as march_module
from coupling_design.lanes import store
from coupling_design.lanes.compiler import VARIABLE
from coupling_design.lanes.march import NotCompiled, compile_march

pytestmark = pytest.mark.skipif(os.name != "posix", reason="needs POSIX")

START, POINT = np.array([[1.0, 2.0]]), np.array([[0.5, 0.25]])


def step():
    state, parameters = ca.SX.sym("x"), ca.SX.sym("p")
    return ca.Function("step", [state, parameters], [state + parameters * state])


def fresh_march():
    """Return the march as a new process would get it."""
    march_module._loading.cache_clear()
    return compile_march(step(), 3)


def assert_works(march):
    np.testing.assert_allclose(march(START, POINT), START * (1 + POINT) ** 3)


def directory():
    return store._cache_directory()


def stored():
    """Return what is there besides the texts of kernels."""
    return sorted(path for path in directory().iterdir() if path.suffix != ".txt")


def texts():
    return sorted(directory().glob("*.txt"))


def count_builds(monkeypatch):
    builds = []
    build = store._build
    monkeypatch.setattr(
        store, "_build", lambda *args: builds.append(args) or build(*args)
    )
    return builds


@pytest.mark.usefixtures("empty_cache")
def test_what_was_started_is_not_compiled_again(monkeypatch):
    builds = count_builds(monkeypatch)
    march_module._loading.cache_clear()
    march_module.start_compiling(step())
    assert_works(compile_march(step(), 3))
    assert len(builds) == 1


@pytest.mark.usefixtures("empty_cache")
def test_starting_what_cannot_be_compiled_says_nothing(monkeypatch):
    monkeypatch.setenv(VARIABLE, "none")
    march_module.start_compiling(step())
    monkeypatch.setenv(VARIABLE, "false")
    march_module.start_compiling(step())
    state, parameters = ca.SX.sym("x"), ca.SX.sym("p")
    unknown = ca.Function("s", [state, parameters], [ca.erf(state)])
    monkeypatch.delenv(VARIABLE)
    march_module.start_compiling(unknown)


@pytest.mark.usefixtures("empty_cache")
def test_second_use_compiles_nothing(monkeypatch):
    assert_works(fresh_march())
    builds = count_builds(monkeypatch)
    assert_works(fresh_march())
    assert builds == []
    assert len(stored()) == 1


@pytest.mark.usefixtures("empty_cache")
@pytest.mark.parametrize(
    "damage",
    [
        lambda content: content[: len(content) // 2],
        lambda _: b"",
        lambda _: b"no library at all",
        lambda content: content[:-1] + bytes([content[-1] ^ 1]),
    ],
    ids=["half", "empty", "foreign", "one bit"],
)
def test_a_damaged_library_is_never_loaded(monkeypatch, damage):
    assert_works(fresh_march())
    (library,) = stored()
    content = library.read_bytes()
    library.unlink()  # a loaded library must not be written to
    library.write_bytes(damage(content))
    builds = count_builds(monkeypatch)
    assert_works(fresh_march())
    assert len(builds) == 1
    assert stored()[0].read_bytes() == content or len(stored()) == 1


@pytest.mark.usefixtures("empty_cache")
def test_a_library_under_another_ones_name_is_not_taken(monkeypatch):
    assert_works(fresh_march())
    (library,) = stored()
    digest = library.stem.rpartition("-")[2]
    other = "0" * 32
    library.rename(library.with_name(f"{other}-{digest}.so"))
    assert store._stored(directory(), other) is None
    assert stored() == []


@pytest.mark.usefixtures("empty_cache")
def test_a_library_others_may_write_to_is_not_taken(monkeypatch):
    assert_works(fresh_march())
    stored()[0].chmod(0o722)
    builds = count_builds(monkeypatch)
    assert_works(fresh_march())
    assert len(builds) == 1


@pytest.mark.usefixtures("empty_cache")
def test_a_directory_others_may_write_to_is_not_used():
    directory().chmod(0o777)
    assert_works(fresh_march())
    assert not list(store.platformdirs.user_cache_path("coupling-design").rglob("*.so"))


@pytest.mark.usefixtures("empty_cache")
def test_without_a_cache_directory_a_temporary_one_serves(monkeypatch, tmp_path):
    (tmp_path / "file").write_text("in the way")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "file"))
    monkeypatch.setattr(
        store.platformdirs, "user_cache_path", lambda _: tmp_path / "file" / "cache"
    )
    assert_works(fresh_march())


@pytest.mark.usefixtures("empty_cache")
def test_processes_may_build_at_once(tmp_path):
    code = textwrap.dedent(
        """
        import casadi as ca, numpy as np
        from coupling_design.lanes.march import compile_march
        x, p = ca.SX.sym("x"), ca.SX.sym("p")
        march = compile_march(ca.Function("s", [x, p], [x * ca.exp(p)]), 2)
        print(march(np.ones((1, 3)), np.ones((1, 3)))[0, 2])
        """
    )
    processes = [
        subprocess.Popen(
            [sys.executable, "-c", code], stdout=subprocess.PIPE, text=True
        )
        for _ in range(4)
    ]
    printed = [process.communicate(timeout=120)[0] for process in processes]
    assert [float(text) for text in printed] == pytest.approx([np.exp(2)] * 4)
    assert not [path for path in stored() if path.suffix != ".so"]


@pytest.mark.usefixtures("empty_cache")
def test_a_failing_compiler_is_told_in_one_line(monkeypatch, tmp_path):
    fake = tmp_path / "badcc"
    fake.write_text(
        '#!/bin/sh\n[ "$1" = --version ] && { echo bad 1.0; exit 0; }\n'
        "echo warning first >&2; echo fatal error: out of ideas >&2; exit 3\n"
    )
    fake.chmod(0o755)
    monkeypatch.setenv(VARIABLE, str(fake))
    assert fresh_march() == NotCompiled(f"{fake} failed: fatal error: out of ideas")
    assert stored() == []


def test_no_compiler_is_told(monkeypatch, tmp_path):
    monkeypatch.delenv(VARIABLE, raising=False)
    monkeypatch.delenv("CC", raising=False)
    monkeypatch.setenv("PATH", str(tmp_path))
    march_module.find_compiler.__globals__["_find"].cache_clear()
    result = compile_march(step(), 3)
    march_module.find_compiler.__globals__["_find"].cache_clear()
    assert result == NotCompiled("no C compiler found")


def test_a_chosen_compiler_that_is_not_there_is_told(monkeypatch):
    monkeypatch.setenv(VARIABLE, "no-such-compiler")
    result = compile_march(step(), 3)
    assert result == NotCompiled("no C compiler 'no-such-compiler' found")

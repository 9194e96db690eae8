"""Kernels written once: what is stored is used, what is damaged or another's is not."""

import os

import casadi as ca
import pytest

from coupling_design.lanes import kernels, store
from coupling_design.lanes.graph.instructions import UnknownOperationError
from coupling_design.lanes.kernels import kernel_of

pytestmark = [
    pytest.mark.skipif(os.name != "posix", reason="needs POSIX"),
    pytest.mark.usefixtures("empty_cache"),
]


def step(factor=2.0):
    state, parameters = ca.SX.sym("x"), ca.SX.sym("p")
    return ca.Function("s", [state, parameters], [state + factor * parameters * state])


@pytest.fixture
def written(monkeypatch):
    """The steps that were written, not taken from the cache."""
    steps, write = [], kernels._written
    monkeypatch.setattr(
        kernels, "_written", lambda step: steps.append(step) or write(step)
    )
    return steps


def text():
    (path,) = store._cache_directory().glob("*.txt")
    return path


def test_a_kernel_is_written_once(written):
    first = kernel_of(step())
    assert kernel_of(step()) == first
    assert len(written) == 1


def test_other_numbers_are_another_kernel(written):
    assert kernel_of(step(3.5)).constants != kernel_of(step(4.5)).constants
    assert len(written) == 2


def test_another_version_writes_anew(written, monkeypatch):
    kernel_of(step())
    monkeypatch.setattr(kernels, "_writers", lambda: "another version")
    kernel_of(step())
    assert len(written) == 2


@pytest.mark.parametrize(
    "damage", [lambda t: t[:-1], lambda t: "", lambda t: t.replace("0", "1", 1)]
)
def test_a_damaged_text_is_written_anew(written, damage):
    first = kernel_of(step())
    path = text()
    path.write_text(damage(path.read_text(encoding="utf-8")), encoding="utf-8")
    assert kernel_of(step()) == first
    assert len(written) == 2
    assert kernel_of(step()) == first
    assert len(written) == 2


def test_a_text_that_others_may_write_is_not_taken(written):
    kernel_of(step())
    text().chmod(0o666)
    kernel_of(step())
    assert len(written) == 2


def test_without_a_directory_every_use_writes(written, monkeypatch, tmp_path):
    (tmp_path / "file").write_text("", encoding="utf-8")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "file"))
    monkeypatch.setenv("HOME", str(tmp_path / "file"))
    assert kernel_of(step()) == kernel_of(step())
    assert len(written) == 2


def test_what_has_no_machine_code_is_told_and_not_stored():
    state, parameters = ca.SX.sym("x"), ca.SX.sym("p")
    unknown = ca.Function("s", [state, parameters], [ca.erf(state)])
    with pytest.raises(UnknownOperationError):
        kernel_of(unknown)
    assert not list(store._cache_directory().glob("*.txt"))


def test_the_oldest_texts_go(monkeypatch):
    monkeypatch.setattr(store, "_MOST_TEXTS", 3)
    for factor in (3.0, 4.0, 5.0, 6.0, 7.0):
        kernel_of(step(factor))
    assert len(list(store._cache_directory().glob("*.txt"))) == 3

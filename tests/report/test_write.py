import json
import os
from dataclasses import replace

import pytest

from coupling_design.errors import CouplingDesignError
from coupling_design.report.files.write import (
    OutputError,
    prepare_directory,
    write_atomically,
    write_files,
)

needs_permissions = pytest.mark.skipif(
    os.name == "nt" or os.geteuid() == 0, reason="this user may write anywhere"
)


def test_writes_both_files(outcome, tmp_path):
    written = write_files(outcome, tmp_path)
    assert [path.name for path in written] == ["design.json", "report.txt"]
    assert sorted(path.name for path in tmp_path.iterdir()) == sorted(
        path.name for path in written
    )
    assert json.loads(written[0].read_text(encoding="utf-8"))["schema_version"] == 1
    lines = written[1].read_text(encoding="utf-8").splitlines()
    assert max(map(len, lines)) == 100


def test_lines_end_alike_everywhere(outcome, tmp_path):
    for path in write_files(outcome, tmp_path):
        content = path.read_bytes()
        assert b"\r" not in content
        assert content.endswith(b"\n")


def test_overwrites(tmp_path):
    path = tmp_path / "report.txt"
    write_atomically(path, "old")
    write_atomically(path, "new")
    assert path.read_text() == "new"


def test_a_failure_leaves_the_old_file(tmp_path, monkeypatch):
    path = tmp_path / "report.txt"
    write_atomically(path, "old")

    def full(_):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(OutputError, match="No space left on device"):
        write_atomically(path, "new")
    assert path.read_text() == "old"
    assert list(tmp_path.iterdir()) == [path]


def test_a_file_name_of_another_encoding_does_no_harm(outcome, tmp_path):
    odd = replace(outcome, case=replace(outcome.case, file="f\udc80.yaml"))
    design, _ = write_files(odd, tmp_path)
    assert json.loads(design.read_text(encoding="utf-8"))["case"]["file"] == (
        "f\udc80.yaml"
    )


def test_missing_directory(tmp_path):
    path = tmp_path / "gone" / "report.txt"
    with pytest.raises(OutputError, match=r"report\.txt: cannot be written: No such"):
        write_atomically(path, "text")


def test_directory_is_made(tmp_path):
    prepare_directory(tmp_path / "a" / "b")
    assert list((tmp_path / "a" / "b").iterdir()) == []


def test_a_file_in_the_way(tmp_path):
    (tmp_path / "reports").touch()
    with pytest.raises(OutputError, match=r"reports: cannot be written: .*--output"):
        prepare_directory(tmp_path / "reports")


@needs_permissions
def test_directory_without_permission(tmp_path):
    tmp_path.chmod(0o500)
    with pytest.raises(OutputError, match="Permission denied"):
        prepare_directory(tmp_path)


def test_refused_by_the_system(tmp_path, monkeypatch):
    def refuse(*_, **__):
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr("pathlib.Path.touch", refuse)
    with pytest.raises(CouplingDesignError, match="Permission denied") as caught:
        prepare_directory(tmp_path)
    assert caught.value.exit_code == 2

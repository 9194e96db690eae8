import shlex
from pathlib import Path

import pytest

from coupling_design.commands.app import COMMANDS, PROGRAM


@pytest.mark.parametrize("name", COMMANDS)
def test_every_help_has_examples(run, name):
    code, out, _ = run(name, "--help")
    assert code == 0
    assert "Examples:" in out
    assert COMMANDS[name].EXAMPLES


@pytest.mark.parametrize("name", COMMANDS)
def test_examples_are_of_their_command(name):
    for example in COMMANDS[name].EXAMPLES:
        assert name == "design" or shlex.split(example)[0] == name


def test_the_help_lists_every_command(run):
    code, out, _ = run("--help")
    assert code == 0
    assert [name for name in COMMANDS if f" {name} " not in out] == []
    assert f"{PROGRAM} CASE is short for" in out


@pytest.mark.parametrize(
    ("words", "among"),
    [
        ("coupling-design ", {"check", "simulate", "sweep", "schema"}),
        ("coupling-design s", {"simulate", "sweep", "schema"}),
        ("coupling-design simulate x.yaml --st", {"--stiffness"}),
        ("coupling-design x.yaml --outp", {"--output"}),
        ("coupling-design check {case} --set connection.g", {"connection.gap="}),
        ("coupling-design sweep {case} lubrication.v", {"lubrication.viscosity="}),
        ("coupling-design check absent.yaml --set connection.g", set()),
    ],
)
def test_what_the_shell_completes(run, quick, monkeypatch, words, among):
    monkeypatch.chdir(Path(quick).parent)  # whose own name may hold a space
    words = words.format(case=Path(quick).name)
    monkeypatch.setenv("_COUPLING_DESIGN_COMPLETE", "complete_bash")
    monkeypatch.setenv("COMP_WORDS", words)
    monkeypatch.setenv("COMP_CWORD", str(len(words.split(" ")) - 1))
    _, out, err = run()
    assert err == ""
    assert among <= set(out.split())


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_shell_completion(run, monkeypatch, shell):
    """As the script asks for it; --show-completion first guesses the user's shell."""
    monkeypatch.setenv("_COUPLING_DESIGN_COMPLETE", f"source_{shell}")
    _, out, err = run()
    assert err == ""
    assert PROGRAM in out

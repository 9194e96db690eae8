import json
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

from coupling_design import __version__
from coupling_design.__main__ import main
from coupling_design.errors import CaseError, DesignError

CASE = Path(__file__).parents[1] / "cases" / "16v280.yaml"
PROBLEM = (
    "cases/bad.yaml:14: driveline.connection.gap: found '28 kg', which is a mass; "
    "allowed is a length from 0 to 10 mm; write it with its unit, such as 0.28 mm, and "
    "see the shipped case for an example"
)


@pytest.fixture
def flow(monkeypatch, tmp_path):
    """Return what lets a test say how the design flow ends; files go to tmp_path."""
    monkeypatch.chdir(tmp_path)

    def ends_with(result):
        def run_design(case, progress):
            progress("step 1 of 5")
            if isinstance(result, BaseException):
                raise result
            return result

        module = SimpleNamespace(run_design=run_design)
        monkeypatch.setitem(sys.modules, "coupling_design.flow.design", module)

    return ends_with


@pytest.fixture
def outcomes():
    """Return a design and none, too small for a report of their own."""
    return tuple(SimpleNamespace(chosen=c, histories=()) for c in (object(), None))


@pytest.fixture
def small_report(monkeypatch):
    monkeypatch.setattr(
        "coupling_design.report.console.report.render_outcome", lambda _: "the report"
    )
    monkeypatch.setattr(
        "coupling_design.report.files.write.build_document", lambda _: {"chosen": 1}
    )
    monkeypatch.setattr(
        "coupling_design.report.files.chosen_case.chosen_case_text",
        lambda *_: "the case",
    )
    monkeypatch.setattr(
        "coupling_design.report.files.write.render_outcome", lambda _: "the report"
    )


@pytest.mark.usefixtures("small_report")
def test_a_design_is_exit_code_0(flow, outcomes, capsys):
    flow(outcomes[0])
    assert main([str(CASE)]) == 0
    out, err = capsys.readouterr()
    directory = Path("reports", "16v280")
    assert out.splitlines() == [
        "the report",
        f"Written: {directory / 'design.json'}",
        f"Written: {directory / 'report.txt'}",
        f"Written: {directory / 'chosen.yaml'}",
    ]
    assert err == ""
    assert json.loads((directory / "design.json").read_text()) == {"chosen": 1}
    assert (directory / "report.txt").read_text() == "the report\n"
    assert (directory / "chosen.yaml").read_text() == "the case"


@pytest.mark.usefixtures("small_report")
def test_no_design_is_exit_code_1(flow, outcomes):
    flow(outcomes[1])
    assert main([str(CASE), "--output", "elsewhere"]) == 1
    assert Path("elsewhere", "design.json").exists()
    assert not Path("elsewhere", "chosen.yaml").exists()


def test_bad_input_is_exit_code_2(flow, capsys):
    flow(CaseError([PROBLEM, "cases/bad.yaml:20: second [bold]problem"]))
    assert main([str(CASE)]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    lines = err.splitlines()
    assert "2 problems in the input" in lines[0]
    assert lines[1:4] == [PROBLEM, "", "cases/bad.yaml:20: second [bold]problem"]
    assert "Traceback" not in err


def test_a_missing_file(capsys):
    assert main(["no/such.yaml"]) == 2
    assert "no/such.yaml: there is no such file" in capsys.readouterr().err


def test_a_run_that_stops_says_why(flow, capsys):
    flow(DesignError("Ipopt cannot be loaded"))
    assert main([str(CASE)]) == 1
    assert "Ipopt cannot be loaded" in capsys.readouterr().err


def test_a_place_that_cannot_be_written_is_refused_before_the_work(flow, capsys):
    flow(AssertionError("the flow ran"))
    Path("taken").touch()
    assert main([str(CASE), "--output", "taken"]) == 2
    assert "taken: cannot be written" in capsys.readouterr().err


def test_interruption(flow, capsys):
    flow(KeyboardInterrupt())
    assert main([str(CASE)]) == 130
    assert capsys.readouterr().err == "Interrupted.\n"


def test_a_defect_of_ours_keeps_its_traceback(flow):
    flow(ZeroDivisionError())
    with pytest.raises(ZeroDivisionError):
        main([str(CASE)])


def test_version(capsys):
    assert main(["--version"]) == 0
    assert capsys.readouterr().out == f"coupling_design {__version__}\n"


def test_help_names_the_exit_codes(capsys):
    assert main(["--help"]) == 0
    assert "1 no design meets the limits" in capsys.readouterr().out


def test_no_case_is_a_usage_error(capsys):
    assert main([]) == 2
    assert "CASE" in capsys.readouterr().err


@pytest.mark.parametrize("arguments", [["--wrong"], [str(CASE), "another"]])
def test_usage_errors(capsys, arguments):
    assert main(arguments) == 2
    assert "Usage" in capsys.readouterr().err


def test_a_misspelt_command_is_named(capsys):
    assert main(["chek", str(CASE)]) == 2
    assert "Did you mean 'check'?" in capsys.readouterr().err


@pytest.mark.usefixtures("small_report")
@pytest.mark.parametrize(
    "arguments",
    [["design", str(CASE)], ["--output", "x", str(CASE)], [str(CASE), "--output=x"]],
)
def test_the_design_may_be_named_or_not(flow, outcomes, arguments):
    flow(outcomes[0])
    assert main(arguments) == 0


def test_starting_is_quick():
    script = (
        "import sys, coupling_design.__main__; "
        "sys.stdout.write(' '.join({'casadi', 'rich', 'pydantic'} & set(sys.modules)))"
    )
    done = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=True
    )
    assert done.stdout == ""

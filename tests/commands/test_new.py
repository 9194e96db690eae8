from pathlib import Path


def test_the_new_case_passes_check(run):
    code, out, _ = run("new", "mine.yaml")
    assert code == 0
    assert out.splitlines()[0] == "Written: mine.yaml"
    assert run("check", "mine.yaml")[0] == 0


def test_nothing_is_overwritten(run):
    Path("mine.yaml").write_text("mine")
    code, _, err = run("new", "mine.yaml")
    assert code == 2
    assert "--force" in err
    assert Path("mine.yaml").read_text() == "mine"


def test_unless_asked_for(run):
    Path("mine.yaml").write_text("mine")
    assert run("new", "mine.yaml", "--force")[0] == 0
    assert "driveline:" in Path("mine.yaml").read_text()


def test_every_key_of_the_form_is_shown(run):
    """The template has each section; only alternatives are left to its comments."""
    from coupling_design.case.edit.places import list_places
    from coupling_design.case.load import read_document
    from coupling_design.case.schema.machine import CaseSection

    run("new", "mine.yaml")
    document = read_document("mine.yaml")
    absent = {p[-1] for p in list_places(document) if document.raw(p) is None}
    text = Path("mine.yaml").read_text()
    assert set(CaseSection.model_fields) - set(document.data) <= absent
    assert [key for key in absent if str(key) not in text] == []

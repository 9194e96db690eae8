import json
import re
from dataclasses import replace

import pytest

from coupling_design.report.files.write import write_files
from coupling_design.report.page import library, page
from coupling_design.report.page.page import html_report

LIBRARY = "/* the library */"
EVIL = "</script><script>alert(1)</script><img src=x onerror=alert(1)>"
LARGEST = 6e6  # bytes


@pytest.fixture(autouse=True, scope="module")
def small_library():
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(page, "plotly_script", lambda: LIBRARY)
        yield


@pytest.fixture(scope="module")
def report(drawn, speed_map):
    return html_report(drawn, speed_map)


@pytest.fixture(scope="module")
def parsed(report, outline):
    return outline(report)


def texts(parsed, tag):
    return [" ".join(e.text.split()) for e in parsed.elements if e.tag == tag]


def test_every_element_is_closed(parsed):
    assert parsed.mismatches == []
    assert parsed.open == []


def test_sections_stand_in_order(parsed):
    ids = [e.attributes["id"] for e in parsed.elements if e.tag == "section"]
    assert ids == [
        "summary",
        "asked",
        "comparison",
        "step-1",
        "step-2",
        "step-3",
        "step-4",
        "step-5",
        "chosen-space",
        "run-down",
        "speed-range",
        "inputs",
        "validity",
    ]


def test_warnings_are_read_first_and_escaped(drawn, speed_map, outline):
    told = html_report(replace(drawn, warnings=(f"Cut off {EVIL}",)), speed_map)
    assert EVIL not in told
    page_of_it = outline(told)
    section = next(
        e for e in page_of_it.elements if e.attributes.get("id") == "summary"
    )
    first, _, _ = section.text.partition("against its limits")
    assert "Read first" in first
    assert "Cut off" in first


def test_the_first_table_is_the_summary(parsed, drawn):
    table = next(e for e in parsed.elements if e.tag == "table")
    for heading in ("criterion", "value", "limit", "margin %", "verdict"):
        assert heading in table.text
    assert all(criterion.name in table.text for criterion in drawn.chosen.criteria)
    assert table.text.count("PASS") == 3


def test_every_link_leads_somewhere_on_the_page(parsed):
    ids = {e.attributes.get("id") for e in parsed.elements}
    links = [e.attributes["href"] for e in parsed.elements if e.tag == "a"]
    assert links
    assert all(link[0] == "#" and link[1:] in ids for link in links)


def test_nothing_comes_from_elsewhere(parsed, report):
    assert not any("src" in element.attributes for element in parsed.elements)
    assert not re.search(r"https?:|url\(|@import", report)
    policy = next(e for e in parsed.elements if "content" in e.attributes and
                  "default-src" in e.attributes["content"])  # fmt: skip
    assert policy.attributes["content"].startswith("default-src 'none'")


def test_every_figure_has_data_a_caption_and_its_thinning(parsed, report):
    figures = [e.attributes["id"] for e in parsed.elements if e.tag == "figure"]
    assert figures == [
        "figure-comparison",
        "figure-plane-3-1",
        "figure-plane-chosen",
        "figure-speed",
        "figure-transmission-force",
        "figure-collision-force",
        "figure-loads",
        "figure-life",
        "figure-damage",
        "figure-campbell",
        "figure-vibration",
    ]
    blocks = re.findall(r'<script type="application/json">(.*?)</script>', report)
    assert len(blocks) == len(figures)
    assert all(json.loads(block)["data"] for block in blocks)
    assert len(texts(parsed, "figcaption")) == len(figures)


def test_a_verdict_is_a_word_and_not_only_a_colour(parsed):
    verdicts = [
        e for e in parsed.elements if "verdict" in e.attributes.get("class", "")
    ]
    assert verdicts
    for element in verdicts:
        word = element.text.strip()
        assert element.attributes["class"] == f"verdict {word.lower()}"
        assert word in ("PASS", "FAIL", "SKIPPED")


def test_each_step_has_question_findings_and_caveats(parsed, drawn):
    sections = {e.attributes["id"]: e for e in parsed.elements if e.tag == "section"}
    for step in drawn.steps:
        text = sections[f"step-{step.step}"].text
        for part in (
            step.question,
            *step.findings,
            *(a.name for a in step.alternatives),
        ):
            assert part.replace("sqrt 2", "√2") in text
    assert "KKT residual" in sections["step-4"].text
    assert "T_KW".replace("_", "") in sections["step-1"].text


def test_every_input_is_echoed_with_its_source(parsed, drawn):
    section = next(e for e in parsed.elements if e.attributes.get("id") == "inputs")
    for value in drawn.case.provenance:
        assert value.text in section.text
        assert value.note in section.text
    assert "490400 N·m/rad" in section.text


def test_limits_of_validity_and_strict_reading_are_told(parsed):
    sections = {e.attributes["id"]: e for e in parsed.elements if e.tag == "section"}
    assert "ISO 281" in sections["validity"].text
    assert "FAIL" in sections["summary"].text
    assert "28.90 kN" in sections["summary"].text


def test_numbers_read_as_on_the_console(parsed):
    summary, strict, *_ = (e.text for e in parsed.elements if e.tag == "table")
    assert "33.93" in summary
    assert "54.30" in strict


def test_two_reports_differ_in_run_time_only(drawn, speed_map, report):
    again = html_report(replace(drawn, run_time=99.0), speed_map)
    assert again != report
    assert again.replace("99.0 s", "43.3 s") == report


def test_without_a_design_the_nearest_is_shown(drawn_without_design, outline):
    parsed = outline(html_report(drawn_without_design))
    assert parsed.mismatches == []
    summary = next(e for e in parsed.elements if e.attributes.get("id") == "summary")
    assert "No design meets the limits." in summary.text
    assert "came nearest" in summary.text
    assert "Present against nearest" in texts(parsed, "h2")


def test_without_javascript_every_figure_says_so(parsed):
    assert len(texts(parsed, "noscript")) == len(texts(parsed, "figure"))


def evil(drawn):
    """Return the outcome of a case whose every name is an attack."""
    case = drawn.case
    named = replace(
        case,
        name=EVIL,
        description=EVIL,
        file=EVIL,
        bearings=tuple(replace(b, name=EVIL, designation=EVIL) for b in case.bearings),
        coupling_types=tuple(replace(t, description=EVIL) for t in case.coupling_types),
        provenance=tuple(replace(v, note=EVIL, text=EVIL) for v in case.provenance),
    )
    histories = tuple(replace(h, label=EVIL) for h in drawn.histories)
    steps = tuple(
        replace(s, findings=(EVIL,), caveats=(EVIL,), title=EVIL, question=EVIL)
        for s in drawn.steps
    )
    map_ = replace(drawn.chosen_map, name=EVIL)
    return replace(drawn, case=named, histories=histories, steps=steps, chosen_map=map_)


def test_no_text_of_the_case_becomes_markup(drawn, speed_map, report, outline):
    attacked = html_report(evil(drawn), speed_map)
    parsed = outline(attacked)
    assert parsed.mismatches == []
    assert "<script>alert" not in attacked
    assert not any(e.tag == "img" for e in parsed.elements)
    assert attacked.count("<script") == report.count("<script")
    assert any(e.text.strip() == EVIL for e in parsed.elements if e.tag == "dd")


def test_no_label_of_a_figure_becomes_markup(drawn):
    attacked = html_report(evil(drawn))
    blocks = re.findall(r'<script type="application/json">(.*?)</script>', attacked)
    decoded = " ".join(json.dumps(json.loads(block)) for block in blocks)
    assert "&lt;script&gt;" in decoded
    assert "<script" not in decoded


def test_the_real_report_is_small_enough(drawn, speed_map, tmp_path, monkeypatch):
    monkeypatch.setattr(page, "plotly_script", library.plotly_script)
    *_, written = write_files(drawn, tmp_path, speed_map)
    assert written.name == "report.html"
    assert 1e6 < written.stat().st_size < LARGEST


def test_the_library_cannot_end_its_own_script():
    script = library.plotly_script()
    assert "</script" not in script.lower()
    assert "<!--" not in script


def test_without_plotly_there_is_no_report_and_no_error(drawn, tmp_path, monkeypatch):
    monkeypatch.setattr(library, "find_spec", lambda name: None)
    written = write_files(drawn, tmp_path)
    assert [path.name for path in written] == ["design.json", "report.txt"]

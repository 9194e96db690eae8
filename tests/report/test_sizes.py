import json
import re

import pytest

from coupling_design.report.console.console import plain_text
from coupling_design.report.console.report import render_outcome
from coupling_design.report.files.json import build_document, document_text

WAYS = ["with_catalogue", "real_size", "no_size"]


def flat(text):
    """Return a report's words in one line, without borders and line breaks."""
    return " ".join(re.sub(r"[│╭╮╰╯─]", " ", text).split())


@pytest.fixture
def say(request):
    """Return a report's words at a width."""

    def words(name, width=100):
        return flat(plain_text(render_outcome(request.getfixturevalue(name)), width))

    return words


@pytest.mark.parametrize("name", WAYS)
@pytest.mark.parametrize("width", [80, 100, 120])
def test_fits_and_loses_nothing(name, width, request):
    text = plain_text(render_outcome(request.getfixturevalue(name)), width)
    assert max(map(len, text.splitlines())) <= width
    assert "…" not in text


@pytest.mark.parametrize(
    "fact",
    [
        "Catalogue sizes",
        "catalogue My [bold] sizes: catalogues/my.yaml",
        "connection tight fit",
        "best size DP 80 of series DP: T_KN 80 kN*m, T_Kmax 140 kN*m, T_KW 25 kN*m, "
        "P_KV 1200 W, n_max 1800 rpm, C_Tdyn 235 MN*m/rad, J driving 7.6 kg*m^2, "
        "J driven 3.4 kg*m^2",
        "its data invented (an example)",
        "the continuous optimum: not a size one can buy",
        "fails: natural frequency",
        # 2.7 / 2.5621 = 1.05382.
        "Best real size: DP 80, 5.38 % more damage than the ideal 192.8 MN*m/rad; its "
        "stiffness alone makes 0.131 % less, its own inertias and damping the rest.",
        "Limits of DP 80",
        "Each size was rolled out on its own.",
        "Take diaphragm (high stiffness plan), 192.8 MN*m/rad",
    ],
)
def test_both_are_named_with_the_price(fact, say):
    assert fact in say("with_catalogue")


def test_a_chosen_size_is_named_in_the_answer(say):
    text = say("real_size")
    assert "Take size DP 80 (high stiffness plan), 235.0 MN*m/rad, tight fit" in text
    assert "size DP 80 T_KN 80 kN*m" in text
    assert "Limits of DP 80" not in text  # they are the chosen design's own
    assert text.count("size DP 80 T_KN") == 1


def test_no_size_that_keeps_the_limits_is_said(say):
    text = say("no_size")
    assert text.count("No catalogue size keeps every limit: the design is the") == 3


def test_no_catalogue_says_nothing_of_it(outcome):
    text = plain_text(render_outcome(outcome))
    assert "Catalogue sizes" not in text
    assert "Not checked" not in flat(text)  # nothing is, of these criteria
    assert build_document(outcome)["catalogue_choice"] is None


def test_document(with_catalogue, no_size):
    document = json.loads(document_text(build_document(with_catalogue)))
    choice = document["catalogue_choice"]
    assert choice["selected"] == "DP 80"
    assert choice["ideal"]["torsional_stiffness"] == 192.8e6
    assert choice["price"] == pytest.approx(0.053823, rel=1e-4)
    assert choice["price_of_stiffness"] == -0.00131
    assert choice["files"][0]["file"] == "catalogues/my.yaml"
    soft, stiff = choice["sizes"]
    assert (soft["passes"], soft["performance"]) == (False, None)
    assert stiff["sheet"]["power_loss"] == 1200.0
    assert stiff["performance"]["damage"] == 2.7e-9
    assert [c["name"] for c in stiff["criteria"]][1] == "natural frequency"
    assert document["chosen"]["size"] is None
    assert build_document(no_size)["catalogue_choice"]["selected"] is None


def test_a_chosen_size_in_the_document(real_size):
    chosen = build_document(real_size)["chosen"]
    assert (chosen["size"], chosen["coupling_type"]) == ("DP 80", "DP")

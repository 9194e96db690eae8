"""The whole page: the template filled with tables, figures and the library."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from coupling_design.flow.outcome import DesignOutcome
from coupling_design.flow.size_choice import CatalogueChoice
from coupling_design.flow.speed_map import SpeedMap
from coupling_design.report.console.designs import chosen_facts, trust
from coupling_design.report.console.header import asked, identity
from coupling_design.report.console.sizes import catalogue_facts, tried_sizes
from coupling_design.report.console.steps import evidence
from coupling_design.report.console.validity import limits_of_validity
from coupling_design.report.page.comparison_figure import comparison_figure
from coupling_design.report.page.figure import Figure
from coupling_design.report.page.library import plotly_script
from coupling_design.report.page.plane_figures import plane_figure
from coupling_design.report.page.run_down_figures import run_down_figures
from coupling_design.report.page.speed_figures import speed_figures
from coupling_design.report.page.tables import (
    Table,
    alternatives_table,
    comparison_table,
    criteria_table,
    critical_speed_table,
    input_rows,
    map_table,
    optimum_table,
)
from coupling_design.report.page.typography import typeset
from coupling_design.report.words.chances import describe_at_once, describe_moves
from coupling_design.report.words.effort import effort_sentence
from coupling_design.report.words.prices import describe_price
from coupling_design.report.words.verdicts import answer, describe_strict
from coupling_design.search.design_map import DesignMap
from coupling_design.steps.step_result import StepResult

# What would end a script element, or a line of JavaScript, inside a JSON string.
_ESCAPES = {"<": "\\u003c", ">": "\\u003e", "&": "\\u0026",
            "\u2028": "\\u2028", "\u2029": "\\u2029"}  # fmt: skip


@dataclass(frozen=True)
class _Plane:
    """A map: its figure, and a table for who cannot draw it."""

    figure: Figure
    table: Table


@dataclass(frozen=True)
class _Step:
    """A step of the flow, its numbers as tables."""

    result: StepResult
    alternatives: Table | None
    optimum: Table | None
    evidence: tuple[tuple[str, str], ...]
    criteria: Table | None
    planes: tuple[_Plane, ...]


def html_report(outcome: DesignOutcome, speed_map: SpeedMap | None = None) -> str:
    """Return the report as one HTML page that needs no other file and no network."""
    from jinja2 import Environment, PackageLoader, StrictUndefined
    from markupsafe import Markup

    environment = Environment(
        loader=PackageLoader("coupling_design.report.page"),
        autoescape=True,  # every text of the case is escaped where it is put in
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters["json"] = _json
    environment.filters["typeset"] = lambda text: Markup(typeset(text))
    template = environment.get_template("report.html")
    page: str = template.render(_content(outcome, speed_map))
    return f"{page}\n"


def _content(outcome: DesignOutcome, speed_map: SpeedMap | None) -> dict[str, Any]:
    case, chosen, strict = outcome.case, outcome.chosen, outcome.strict_reading
    criteria = chosen.criteria if chosen else outcome.nearest_criteria
    return {
        "case": case,
        "outcome": outcome,
        "effort": effort_sentence(outcome),
        "answer": [sentence.plain for sentence in answer(outcome)],
        "summary": criteria_table(criteria) if criteria else None,
        "identity": list(identity(case)),
        "asked": list(asked(case)),
        "chosen": list(chosen_facts(case, chosen)) if chosen else [],
        "comparison": comparison_table(outcome),
        "comparison_figure": comparison_figure(outcome),
        "trust": list(trust(outcome.baseline)),
        "moves": describe_moves(chosen.sensitivity) if chosen else "",
        "bound": describe_at_once(case, chosen) if chosen else None,
        "steps": [_step(outcome, result) for result in outcome.steps],
        "catalogue": _catalogue(outcome.catalogue_choice),
        "chosen_plane": (
            _plane(outcome, outcome.chosen_map, "plane-chosen")
            if outcome.chosen_map
            else None
        ),
        "run_down": run_down_figures(outcome),
        "speed_figures": speed_figures(speed_map) if speed_map else (),
        "critical_speeds": list(_critical_speeds(speed_map)) if speed_map else [],
        "strict": describe_strict(strict) if strict else "",
        "strict_criteria": criteria_table(strict.criteria) if strict else None,
        "inputs": list(input_rows(case)),
        "validity": limits_of_validity(outcome),
        "plotly": plotly_script(),
    }


def _step(outcome: DesignOutcome, result: StepResult) -> _Step:
    optimum = result.optimum
    firm = optimum.conditioning if optimum else None
    return _Step(
        result=result,
        alternatives=(
            alternatives_table(result.alternatives) if result.alternatives else None
        ),
        optimum=optimum_table(optimum) if optimum else None,
        evidence=(
            tuple(evidence(optimum, firm.digits if firm else None)) if optimum else ()
        ),
        criteria=criteria_table(result.criteria) if result.criteria else None,
        planes=tuple(
            _plane(outcome, map_, f"plane-{result.step}-{n}")
            for n, map_ in enumerate(result.maps, start=1)
        ),
    )


def _catalogue(choice: CatalogueChoice | None) -> dict[str, Any] | None:
    if choice is None:
        return None
    selected = choice.selected
    return {
        "price": describe_price(choice),
        "facts": list(catalogue_facts(choice)),
        "tried": alternatives_table(tried_sizes(choice)),
        "criteria": criteria_table(selected.criteria) if selected else None,
        "findings": choice.findings,
    }


def _plane(outcome: DesignOutcome, map_: DesignMap, key: str) -> _Plane:
    return _Plane(plane_figure(outcome, map_, key), map_table(map_))


def _critical_speeds(speed_map: SpeedMap) -> Iterator[tuple[str, Table]]:
    for coupling in (speed_map.present, speed_map.chosen):
        if coupling is not None:
            yield f"{coupling.name}: {coupling.label}", critical_speed_table(coupling)


def _json(figure: Figure) -> Any:
    from markupsafe import Markup

    content = {"data": figure.traces, "layout": figure.layout}
    text = json.dumps(content, allow_nan=False, separators=(",", ":"))
    for character, escape in _ESCAPES.items():
        text = text.replace(character, escape)
    return Markup(text)

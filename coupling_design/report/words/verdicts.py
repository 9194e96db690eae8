"""The answer of a run in a few sentences."""

from __future__ import annotations

from collections.abc import Iterable

from rich.console import Group
from rich.text import Text

from coupling_design.flow.outcome import ChosenDesign, DesignOutcome, LoadReading
from coupling_design.flow.size_choice import CatalogueChoice
from coupling_design.parts.criterion import Criterion
from coupling_design.report.words.names import VERDICT_STYLES, words
from coupling_design.report.words.numbers import significant
from coupling_design.report.words.prices import describe_price
from coupling_design.report.words.units import display_unit, quantity, value_and_limit

_DIGITS_OF_REDUCTION = 3


def render_verdict(outcome: DesignOutcome) -> Group:
    """Return whether there is a design, what it saves, and the strict reading."""
    return Group(*answer(outcome))


def describe_reduction(chosen: ChosenDesign, present_digits: int) -> str:
    """Return by how much the damage falls or rises, with the digits that stand."""
    digits = min(_DIGITS_OF_REDUCTION, chosen.digits, present_digits)
    change = f"{significant(abs(chosen.damage_reduction) * 100, digits)} %"
    low, high = (f"{100 * end:.0f}" for end in chosen.reduction_range)
    reach = f" ({low} to {high} % when inputs move)"
    verb = "falls" if chosen.damage_reduction >= 0 else "rises"
    return f"{verb} by {change}{reach}"


def describe_strict(strict: LoadReading) -> str:
    """Return the verdict of the strict reading in one sentence."""
    limit = quantity(strict.permissible_transmission_force, "N")
    verdict = "PASS" if strict.passes else "FAIL"
    return (
        f"Load limit read strictly ({words(strict.reading)}): {verdict}; "
        f"F_c may then reach {limit} kN."
    )


def answer(outcome: DesignOutcome) -> Iterable[Text]:
    """Yield the answer sentence by sentence."""
    chosen = outcome.chosen
    if chosen is None:
        yield Text("No design meets the limits.", style=VERDICT_STYLES["FAIL"])
        misses = (_miss(c) for c in outcome.nearest_criteria if c.fails)
        yield from map(Text, outcome.reasons or misses)
    else:
        yield Text(_design(chosen), style=VERDICT_STYLES["PASS"])
        reduction = describe_reduction(chosen, outcome.baseline.digits)
        yield Text(f"Damage per run-down {reduction} against the present coupling.")
    if outcome.catalogue_choice is not None:
        yield _size(outcome.catalogue_choice)
    if outcome.strict_reading is not None and chosen is not None:
        strict = outcome.strict_reading
        style = "none" if strict.passes else VERDICT_STYLES["FAIL"]
        yield Text(describe_strict(strict), style=style)


def _miss(criterion: Criterion) -> str:
    value, limit = value_and_limit(criterion)
    unit = f" {display_unit(criterion.unit)}" if criterion.unit else ""
    return f"Nearest came: {criterion.name} {value}{unit}, wanted {limit}{unit}."


def _size(choice: CatalogueChoice) -> Text:
    style = "none" if choice.selected else VERDICT_STYLES["FAIL"]
    return Text(describe_price(choice), style=style)


def _design(chosen: ChosenDesign) -> str:
    stiffness = quantity(chosen.performance.torsional_stiffness, "N*m/rad")
    gap = quantity(chosen.performance.key_gap, "m")
    name = f"size {chosen.size}" if chosen.size else chosen.coupling_type
    return (
        f"Take {name} ({words(chosen.plan)} plan), {stiffness} "
        f"MN*m/rad, {words(chosen.connection)}, gap {gap} mm."
    )

"""The best real size of the catalogues beside the ideal stiffness, and its price."""

from __future__ import annotations

from collections.abc import Iterable

from rich.panel import Panel
from rich.text import Text

from coupling_design.flow.size_choice import CatalogueChoice
from coupling_design.machine.coupling_size import CouplingSize
from coupling_design.report.console.blocks import bullets, facts, panel
from coupling_design.report.console.limits import render_criteria
from coupling_design.report.console.performances import render_alternatives
from coupling_design.report.words.names import VERDICT_STYLES, words
from coupling_design.report.words.prices import describe_price
from coupling_design.report.words.units import as_given
from coupling_design.steps.step_result import Alternative


def render_catalogue(choice: CatalogueChoice) -> Panel:
    """Return the sizes that were tried, the best of them and its price."""
    selected = choice.selected
    limits = None
    if selected is not None and not choice.is_chosen:
        limits = render_criteria(f"Limits of {selected.size.name}", selected.criteria)
    return panel(
        "Catalogue sizes",
        (
            facts(catalogue_facts(choice)),
            render_alternatives(tried_sizes(choice)),
            Text(
                describe_price(choice),
                style="bold" if selected else VERDICT_STYLES["FAIL"],
            ),
            limits,
            bullets("How they were tried", choice.findings),
        ),
        style="green" if selected else "red",
    )


def tried_sizes(choice: CatalogueChoice) -> tuple[Alternative, ...]:
    """Return the ideal stiffness, then each size, as lines of one table."""
    ideal = Alternative(
        f"ideal stiffness, {choice.ideal_type}",
        passes=True,
        performance=choice.ideal,
        remark="the continuous optimum: not a size one can buy",
    )
    sizes = (
        Alternative(trial.size.name, trial.passes, trial.performance, trial.remark)
        for trial in choice.trials
    )
    return (ideal, *sizes)


def describe_size(size: CouplingSize) -> str:
    """Return a size's data as its sheet gives them."""
    limits = (
        ("T_KN", size.nominal_torque, "N*m", "kN*m"),
        ("T_Kmax", size.maximum_torque, "N*m", "kN*m"),
        ("T_Kmax2", size.rare_maximum_torque, "N*m", "kN*m"),
        ("T_KW", size.vibratory_torque, "N*m", "kN*m"),
        ("P_KV", size.power_loss, "W", "W"),
        ("n_max", size.maximum_speed, "rad/s", "rpm"),
        ("C_Tdyn", size.torsional_stiffness, "N*m/rad", "MN*m/rad"),
        ("J driving", size.driving_inertia, "kg*m^2", "kg*m^2"),
        ("J driven", size.driven_inertia, "kg*m^2", "kg*m^2"),
    )
    return ", ".join(
        f"{name} {as_given(value, unit)} {shown}"
        for name, value, unit, shown in limits
        if value is not None
    )


def catalogue_facts(choice: CatalogueChoice) -> Iterable[tuple[str, str]]:
    """Yield which catalogues were looked through, and the best size's data."""
    for file in choice.files:
        yield "catalogue", f"{file.name}: {file.file}"
        yield "", f"sha256 {file.sha256}"
    yield "plan", words(choice.plan)
    yield "connection", words(choice.connection)
    if choice.selected is not None:
        size = choice.selected.size
        yield "best size", f"{size.name} of series {size.series}: {describe_size(size)}"
        note = f" ({size.note})" if size.note else ""
        yield "its data", f"{size.source}{note}"

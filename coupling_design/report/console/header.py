"""The top of the report: which case, what was asked, and the answer in short."""

from __future__ import annotations

from collections.abc import Iterable

from rich.panel import Panel
from rich.text import Text

from coupling_design import __version__
from coupling_design.flow.outcome import DesignOutcome
from coupling_design.machine.machine import Case
from coupling_design.machine.words import LoadLimitReading
from coupling_design.report.console.blocks import bullets, facts, panel, titled
from coupling_design.report.words.units import as_given
from coupling_design.report.words.verdicts import render_verdict
from coupling_design.wear.chance import describe_start

READINGS = {
    LoadLimitReading.TRANSMISSION_FORCE: (
        "transmission_force: the force at the key against F_min less the static load "
        "(the paper's reading, without the lever of the overhang)"
    ),
    LoadLimitReading.COMBINED_LOAD: (
        "combined_load: the load at each bearing against F_min (the strict reading, "
        "with the lever of the overhang)"
    ),
}


def render_header(outcome: DesignOutcome) -> Panel:
    """Return what was asked of which machine, and the answer."""
    case = outcome.case
    return panel(
        f"Coupling design: {case.name}",
        (
            Text(case.description) if case.description else None,
            facts(identity(case)),
            bullets("Read first", outcome.warnings),
            titled("Asked", facts(asked(case))),
            titled("Answer", render_verdict(outcome)),
        ),
    )


def identity(case: Case) -> Iterable[tuple[str, str]]:
    """Yield which file and which program made the report."""
    yield "case file", case.file
    yield "sha256", case.sha256
    if case.overrides:
        yield "overrides", "\n".join(f"--set {each}" for each in case.overrides)
    yield "program", f"coupling_design {__version__}"


def asked(case: Case) -> Iterable[tuple[str, str]]:
    """Yield what was asked of which machine."""
    duty, shutdown = case.duty, case.shutdown
    lowest, highest = (as_given(speed, "rad/s") for speed in duty.working_speed)
    yield "working speed", f"{lowest} to {highest} rpm"
    yield (
        "torque",
        f"rated {as_given(duty.rated_torque, 'N*m')} kN*m x service factor "
        f"{duty.service_factor:g}; peak {as_given(duty.peak_torque, 'N*m')} kN*m",
    )
    orders = ", ".join(f"{order.order:g}" for order in case.driveline.excitation)
    yield "excitation orders", orders
    yield (
        "run-down",
        f"from {as_given(shutdown.initial_speed, 'rad/s')} rpm, "
        f"{shutdown.duration:g} s in steps of {shutdown.time_step:g} s",
    )
    yield "its start", describe_start(shutdown)
    bearings = (f"{bearing.name} {bearing.designation}" for bearing in case.bearings)
    yield "bearings", ", ".join(bearings)
    yield "reliability", f"{as_given(case.reliability * 100, '')} %"
    yield "load limit read as", READINGS[case.reading]
    yield "coupling types", "; ".join(t.name for t in case.coupling_types)

"""Critical speeds, forbidden speeds and steady vibration of couplings, as tables."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from rich.console import Group, RenderableType
from rich.panel import Panel
from rich.table import Table
from rich.text import Text

from coupling_design.flow.speed_map import CouplingSpeeds, ForbiddenBand, SpeedMap
from coupling_design.machine.machine import Case
from coupling_design.machine.words import Plan
from coupling_design.report.console.blocks import bullets, facts, panel, table, titled
from coupling_design.report.words.names import verdict, words
from coupling_design.report.words.numbers import percent, significant
from coupling_design.report.words.units import as_given, quantity
from coupling_design.speeds.vibration import OperatingPoint

_NOTES = (
    "Natural frequencies are undamped, with the gap closed. Swings about zero torque "
    "find an open gap softer, and resonate at a lower speed.",
    "The margin is the distance to the nearer end of the working range, over that end; "
    "PASS from 10 % (API 617 for turbomachines, a yardstick here).",
    "Forbidden speeds lie within sqrt 2 of the lowest mode (paper, steps 2 and 4): "
    "below the border for a soft coupling, above it for a stiff one.",
    "Vibratory torque is the amplitude T_W of DIN 740-2, half the peak-to-peak, steady "
    "and linear; the sum lets the crests of all orders meet.",
    "It comes from the orders of the case and no others. Where those are of an engine "
    "with its fuel off, add the gas torque before judging a coupling at load.",
    "The gap stays closed while the mean torque is larger than the vibratory torque at "
    "the connection; below that it rattles and these numbers do not hold.",
    "Dry friction does not depend on speed and so does not damp; viscous resistance "
    "does.",
)
_HEADINGS = ("lowest\nworking", "highest\nworking", "worst\nworking", "worst\nof all")


def render_speed_map(case: Case, speed_map: SpeedMap) -> Group:
    """Return the couplings of a case over its speed range."""
    return Group(*_parts(case, speed_map))


def _parts(case: Case, speed_map: SpeedMap) -> Iterable[RenderableType]:
    yield panel(
        f"Campbell diagram and steady vibration: {case.name}",
        (facts(_range(speed_map)),),
    )
    yield _coupling(speed_map.present, speed_map)
    if speed_map.chosen is not None:
        yield _coupling(speed_map.chosen, speed_map)
    yield panel("How to read it", [bullets("Read with this", _NOTES)])


def _range(speed_map: SpeedMap) -> Iterable[tuple[str, str]]:
    lowest, highest = (as_given(w, "rad/s") for w in speed_map.working_speed)
    yield "working speed", f"{lowest} to {highest} rpm"
    first, last = (as_given(float(w), "rad/s") for w in speed_map.speeds)
    yield "diagram", f"{first} to {last} rpm"
    yield "excitation orders", ", ".join(f"{order:g}" for order in speed_map.orders)


def _coupling(coupling: CouplingSpeeds, speed_map: SpeedMap) -> Panel:
    return panel(
        f"{coupling.name[:1].upper()}{coupling.name[1:]} coupling",
        (
            facts(_identity(coupling)),
            titled("Critical speeds", _critical_speeds(coupling)),
            titled("Forbidden speeds", _bands(coupling.forbidden_bands)),
            titled(
                "Steady vibration",
                _vibration(coupling.operating_points, tuple(speed_map.orders)),
            ),
        ),
        style="green" if coupling.separated and coupling.isolated else "red",
    )


def _identity(coupling: CouplingSpeeds) -> Iterable[tuple[str, str]]:
    yield "coupling", coupling.label
    yield "C_Tdyn", f"{quantity(coupling.torsional_stiffness, 'N*m/rad')} MN*m/rad"
    frequencies = (significant(float(f)) for f in coupling.natural_frequencies)
    yield "natural frequencies", f"{', '.join(frequencies)} Hz"


def _critical_speeds(coupling: CouplingSpeeds) -> Table:
    rows = table(
        [],
        ["order", "mode", "f_n\nHz", "speed\nrpm", "margin\n%"],
        ["working range", "verdict"],
    )
    for critical in coupling.critical_speeds:
        rows.add_row(
            f"{critical.order:g}",
            f"{critical.mode}",
            significant(critical.natural_frequency),
            quantity(critical.speed, "rad/s"),
            percent(critical.separation_margin),
            Text(words(critical.position)),
            verdict(critical.passes),
        )
    return rows


def _bands(bands: Sequence[ForbiddenBand]) -> Table:
    rows = table([], ["order", "border\nrpm"], ["forbidden", "plan", "verdict"])
    for band in bands:
        rows.add_row(
            f"{band.order:g}",
            quantity(band.border, "rad/s"),
            Text("below" if band.plan is Plan.ELASTIC else "above"),
            Text(words(band.plan)),
            verdict(not band.reaches_working_speed),
        )
    return rows


def _vibration(points: Sequence[OperatingPoint], orders: Sequence[float]) -> Table:
    rows = table(["quantity"], _HEADINGS, ["unit"])

    def add(label: str, values: Iterable[float], unit: str, shown: str) -> None:
        rows.add_row(Text(label), *(quantity(v, unit) for v in values), Text(shown))

    add("speed", (p.speed for p in points), "rad/s", "rpm")
    for i, order in enumerate(orders):
        torques = (p.vibratory_torque[i] for p in points)
        add(f"T_W of order {order:g}", torques, "N*m", "kN*m")
    add("T_W, sum", (p.vibratory_torque_sum for p in points), "N*m", "kN*m")
    add("T_W, rms", (p.vibratory_torque_rms for p in points), "N*m", "kN*m")
    transmitted = (p.transmission_torque_sum for p in points)
    add("at the connection, sum", transmitted, "N*m", "kN*m")
    add("power loss P_W", (p.power_loss for p in points), "W", "W")
    return rows

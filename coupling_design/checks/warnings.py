"""What a reader must know before anything else: implausible, unused, cut off."""

from __future__ import annotations

import math
from collections.abc import Iterator

from coupling_design.checks.usual_ranges import outside_usual_ranges
from coupling_design.line.modes import natural_angular_frequency
from coupling_design.line.parameters import ExcitationOrder, KeyedConnection
from coupling_design.machine.machine import Case
from coupling_design.parts.bearing.contact_stress import minimum_load
from coupling_design.parts.bearing.loads import static_loads
from coupling_design.wear.performance import Performance

_STIFF_CONTACT = 10.0  # times the coupling; softer, the key is the coupling
# ISO 281 holds up to half the dynamic rating.
_LARGEST_LOAD = 0.5
_HIGHEST_ORDER = 24.0
_COMPRESSION = (8.0, 24.0)
_FIRING_INTERVAL = (15.0, 360.0)
_RPM = 30 / math.pi


def case_warnings(case: Case) -> tuple[str, ...]:
    """Return what is implausible or unused in a case, known without a run-down."""
    return (
        *outside_usual_ranges(case),
        *_engine(case),
        *_orders(case),
        *_contact(case),
        *_no_passage(case),
        *weight_above_limit(case),
        *(f"{case.place(path)} is not used: {why}." for path, why in case.unused),
    )


def run_down_warnings(
    case: Case, performance: Performance, whose: str
) -> tuple[str, ...]:
    """Return what is implausible in what a coupling does, `whose` as in `present`."""
    return tuple(f"{whose}: {told}" for told in _of_performance(case, performance))


def stop_remark(case: Case, performance: Performance) -> str | None:
    """Return that the run-down ends before rest, None if everything rests by then."""
    spread = performance.spread
    rest = float(case.driveline.engine_resistance.transition_speed)
    if spread is None or spread.final_speed <= rest:
        return None
    return (
        f"the run-down ends at {spread.final_speed * _RPM:.3g} rpm, before rest "
        "(the fastest part, over all crank angles); what follows is not in the damage"
    )


def weight_above_limit(case: Case) -> Iterator[str]:
    """Yield each bearing whose share of the rotor's weight alone exceeds F_min."""
    for bearing, static in zip(case.bearings, static_loads(case.shaft), strict=True):
        limit = float(minimum_load(bearing))
        if float(static) >= limit:
            yield (
                f"The rotor's weight on {bearing.name} exceeds F_min: "
                f"{float(static) / 1e3:.4g} kN against {limit / 1e3:.4g} kN. No "
                "coupling can keep that load limit."
            )


def _of_performance(case: Case, performance: Performance) -> Iterator[str]:
    loads = zip(
        case.bearings, performance.peak_combined_load, performance.damages, strict=True
    )
    for bearing, peak, damage in loads:
        C, C_0 = bearing.dynamic_load_rating, bearing.static_load_rating
        if float(damage) >= 1.0:
            yield (
                f"{bearing.name} does not survive one stop: its damage is "
                f"{float(damage):.3g}, 1 is its whole life."
            )
        if float(peak) > float(C_0):
            yield (
                f"the largest load of {bearing.name}, {float(peak) / 1e3:.4g} kN, is "
                f"above its static rating C_0 = {float(C_0) / 1e3:.4g} kN."
            )
        elif float(peak) > _LARGEST_LOAD * float(C):
            yield (
                f"the largest load of {bearing.name}, {float(peak) / 1e3:.4g} kN, is "
                f"above half of C = {float(C) / 1e3:.4g} kN, where ISO 281 ends."
            )
    yield from _cut_off(case, performance)


def ends_above_resonance(case: Case, performance: Performance) -> bool:
    """Return whether the run-down ends before it passes the largest order's resonance.

    One that begins below it has been warned of already: there is no passage.
    """
    spread = performance.spread
    if spread is None:
        return False
    resonance = _resonance(case, performance)
    return resonance < spread.final_speed < float(case.shutdown.initial_speed)


def _resonance(case: Case, performance: Performance) -> float:
    """Return the speed at which the largest order meets the natural frequency."""
    frequency = 2 * math.pi * float(performance.natural_frequency)
    return frequency / float(_largest_order(case).order)


def _cut_off(case: Case, performance: Performance) -> Iterator[str]:
    """Yield that the set still turns above the resonance when the run-down ends."""
    spread, order = performance.spread, _largest_order(case)
    if spread is not None and ends_above_resonance(case, performance):
        resonance = _resonance(case, performance)
        yield (
            f"the run-down ends at {spread.final_speed * _RPM:.4g} rpm, above the "
            f"resonance with order {order.order:g} at {resonance * _RPM:.4g} rpm: the "
            "passage is in neither peaks nor damage. Write a longer shutdown.duration."
        )


def _no_passage(case: Case) -> Iterator[str]:
    frequency = float(natural_angular_frequency(case.driveline)) / (2 * math.pi)
    order, speed = _largest_order(case), float(case.shutdown.initial_speed)
    resonance = 2 * math.pi * frequency / order.order
    if speed < resonance:
        yield (
            f"{case.place('shutdown.initial_speed')}: the run-down does not pass the "
            f"natural frequency. Its largest order, {order.order:g}, meets the present "
            f"coupling's {frequency:.4g} Hz at {resonance * _RPM:.4g} rpm, and it "
            f"begins at {speed * _RPM:.4g} rpm."
        )


def _largest_order(case: Case) -> ExcitationOrder:
    return max(case.driveline.excitation, key=lambda order: abs(float(order.amplitude)))


def _contact(case: Case) -> Iterator[str]:
    connection = case.driveline.connection
    if not isinstance(connection, KeyedConnection):
        return
    stiffness = float(case.driveline.coupling.torsional_stiffness)
    ratio = float(connection.contact_stiffness) / stiffness
    if ratio < _STIFF_CONTACT:
        yield (
            f"{case.place('driveline.connection.contact_stiffness')}: the contact is "
            f"{ratio:.3g} times as stiff as the present coupling; below "
            f"{_STIFF_CONTACT:g} times the key is the coupling."
        )


def _orders(case: Case) -> Iterator[str]:
    excitations = (
        ("driveline.excitation", case.driveline.excitation),
        ("duty.excitation", case.working_excitation),
    )
    told = set()
    for path, orders in excitations:
        for i, each in enumerate(orders):
            odd = abs(each.order * 2 - round(each.order * 2)) > 1e-9
            if each.order in told or not (odd or each.order > _HIGHEST_ORDER):
                continue
            told.add(each.order)
            yield (
                f"{case.place(f'{path}[{i}].order')}: order {each.order:g} is none of "
                "an engine's: they come in halves of a turn, up to about "
                f"{_HIGHEST_ORDER:g}."
            )


def _engine(case: Case) -> Iterator[str]:
    values = {value.path: value.value for value in case.provenance}
    base = "driveline.excitation.engine"
    ratio = values.get(f"{base}.compression_ratio")
    low, high = _COMPRESSION
    if isinstance(ratio, float) and not low <= ratio <= high:
        yield (
            f"{case.place(f'{base}.compression_ratio')}: {ratio:g} is outside {low:g} "
            f"to {high:g}, what engines have: gas engines from 8, small diesels up to "
            "24."
        )
    written = values.get(f"{base}.firing_intervals")
    if isinstance(written, str):
        short, long = _FIRING_INTERVAL
        angles = [math.degrees(float(part)) for part in written.split(",")]
        strange = [angle for angle in angles if not short <= angle <= long]
        if strange:
            yield (
                f"{case.place(f'{base}.firing_intervals')}: {strange[0]:g} deg is "
                f"outside {short:g} to {long:g} deg, what engines have between firings."
            )

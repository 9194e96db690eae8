"""What must hold between the values of an engine in a case file."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np
from pydantic import ValidationError

from coupling_design.case.build.engine import (
    THRESHOLD,
    at_work,
    build_arrangement,
    build_engine,
    kept_orders,
)
from coupling_design.case.build.pressure_file import load_trace
from coupling_design.case.schema.engine import EngineMode, EngineSection, WorkingEngine
from coupling_design.case.schema.single_values import Values
from coupling_design.case.text.fault import Path, Problem, suggestion
from coupling_design.engine import Engine, engine_figures, firing_angles, list_orders
from coupling_design.engine.parameters import IndicatedCombustion, PressureTrace
from coupling_design.engine.pressure import pressure_rise
from coupling_design.errors import CaseError

_ENGINE: Path = ("driveline", "excitation", "engine")
_WORKING: Path = ("duty", "excitation", "engine")
_EVERY_ORDER = 1e4
_SHORTEST_ROD = 0.51  # of the stroke
# From firing dead centre [deg]: a motored peak lies just before it, the latest burning
# ends its rise well before the piston is half way down.
_PEAK_NEAR = (-30.0, 60.0)
_ROUNDED_WORK = 1e3  # mean pressure that a trace's steps may miss [Pa]


def check_engine(values: Values, case_file: str) -> Iterator[Problem]:
    """Yield what is wrong between the values of an engine whose form is right."""
    try:
        section = EngineSection.model_validate(values.raw(*_ENGINE))
    except ValidationError:
        return
    problems = [
        *_rod(section, values),
        *_fuel(section, case_file, _ENGINE),
        *_firing(section, values),
    ]
    yield from problems
    if not problems:
        engine = build_engine(section, case_file)
        yield from _pressure(engine, values, _ENGINE)
        yield from _trace_peak(engine, values, _ENGINE)
        yield from _orders(section, engine, values, _ENGINE)


def check_working_engine(values: Values, case_file: str) -> Iterator[Problem]:
    """Yield what is wrong with the engine at work, as what differs from the stop."""
    written = values.raw(*_WORKING)
    if written is None:
        return
    try:
        working = WorkingEngine.model_validate(written)
    except ValidationError:
        return
    if values.raw(*_ENGINE) is None:
        yield Problem(
            _WORKING,
            "found an engine, but driveline.excitation has none to take the rest from; "
            "write orders in a list here, or engine data there",
        )
        return
    if any(check_engine(values, case_file)):
        return
    section = at_work(EngineSection.model_validate(values.raw(*_ENGINE)), working)
    problems = [
        *_fuel(section, case_file, _WORKING),
        *_missing(section, _WORKING),
    ]
    yield from problems
    if not problems:
        engine = build_engine(section, case_file)
        yield from _pressure(engine, values, _WORKING)
        yield from _trace_peak(engine, values, _WORKING)
        yield from _orders(section, engine, values, _WORKING)


def _rod(section: EngineSection, values: Values) -> Iterator[Problem]:
    path = (*_ENGINE, "rod_length")
    if section.rod_length.value < _SHORTEST_ROD * section.stroke.value:
        yield Problem(
            path,
            f"found '{values.text(*path)}', allowed {_SHORTEST_ROD:g} of the stroke "
            f"'{values.text(*_ENGINE, 'stroke')}' or more, or the crank cannot turn; "
            "write the length between the eyes",
        )


def _fuel(section: EngineSection, case_file: str, place: Path) -> Iterator[Problem]:
    """Yield what keeps a fired engine from having one pressure over its cycle."""
    trace, pressure = section.pressure_trace, section.indicated_mean_pressure
    if section.mode.value is EngineMode.MOTORED:
        return
    if (trace is None) == (pressure is None):
        found = "neither" if trace is None else "both"
        yield Problem(
            (*place, "mode"),
            f"found 'fired' with {found} of indicated_mean_pressure and "
            "pressure_trace; give one of them, or write motored for fuel off",
        )
    elif trace is not None:
        try:
            load_trace(trace.value, case_file, section.cycle.value)
        except CaseError as error:
            for sentence in error.problems:
                yield Problem((*place, "pressure_trace"), sentence)


def _firing(section: EngineSection, values: Values) -> Iterator[Problem]:
    path = (*_ENGINE, "cylinders")
    if section.cylinders.value % 1:
        yield Problem(
            path, f"found '{values.text(*path)}', allowed are whole numbers, such as 16"
        )
        return
    if section.firing_intervals and section.crank_angles:
        yield Problem(
            (*_ENGINE, "crank_angles"),
            "found crank_angles and firing_intervals, which say the same; "
            "delete one of them",
        )
        return
    arrangement = build_arrangement(section)
    try:
        firing_angles(arrangement, section.cycle.value)
    except CaseError as error:
        key = "firing_order"
        key = "firing_intervals" if section.firing_intervals else key
        key = "crank_angles" if section.crank_angles else key
        yield Problem((*_ENGINE, key), str(error))
    yield from _missing(section, _ENGINE)


def _missing(section: EngineSection, place: Path) -> Iterator[Problem]:
    """Yield misfiring cylinders that the engine does not have."""
    missing, names = section.misfiring_cylinders, build_arrangement(section).names
    for name in missing.value if missing else ():
        if name not in names:
            yield Problem(
                (*place, "misfiring_cylinders"),
                f"found '{name}'; {suggestion(name, names)}allowed: {', '.join(names)}",
            )


def _trace_peak(engine: Engine, values: Values, place: Path) -> Iterator[Problem]:
    """Yield a trace whose peak is far from firing, or that does no work."""
    trace = engine.combustion
    if not isinstance(trace, PressureTrace):
        return
    path = (*place, "pressure_trace")
    at = math.degrees(trace.angles[int(np.argmax(trace.pressures))])
    half = math.degrees(engine.cycle.angle) / 2
    at = (at + half) % (2 * half) - half
    low, high = _PEAK_NEAR
    if not low <= at <= high:
        yield Problem(
            path,
            f"found '{values.text(*path)}', whose largest pressure lies {at:.4g} deg "
            f"after firing top dead centre; allowed {low:g} to {high:g} deg, where "
            "combustion is: let the crank angle count from firing top dead centre",
        )
    elif (work := engine_figures(engine).indicated_mean_pressure) < -_ROUNDED_WORK:
        yield Problem(
            path,
            f"found '{values.text(*path)}', by which a cycle does negative work, "
            f"{work / 1e5:.3g} bar of mean pressure: a fired engine drives; correct "
            "the trace, or write mode motored",
        )


def _pressure(engine: Engine, values: Values, place: Path) -> Iterator[Problem]:
    """Yield a mean pressure that would take combustion below nothing."""
    path = (*place, "indicated_mean_pressure")
    combustion = engine.combustion
    if isinstance(combustion, IndicatedCombustion):
        rise = pressure_rise(engine, combustion)
        if not 0 < rise < float("inf"):
            yield Problem(
                path,
                f"found '{values.text(*path)}', which this combustion cannot reach; "
                "it must begin early enough in the expansion to do work",
            )


def _orders(
    section: EngineSection, engine: Engine, values: Values, place: Path
) -> Iterator[Problem]:
    """Yield a problem if none is kept: the driveline would not be excited."""
    if kept_orders(section, engine):
        return
    path = (*place, "highest_order")
    share = section.threshold.value if section.threshold else THRESHOLD
    rows = (
        row.order for row in list_orders(engine, _EVERY_ORDER, share) if row.survives
    )
    first = next(rows, None)
    remedy = (
        f"the first that does is {first:g}: write that or more"
        if first is not None
        else "lower the threshold"
    )
    yield Problem(
        path,
        f"found '{values.text(*path)}', but no order survives up to there; {remedy}",
    )

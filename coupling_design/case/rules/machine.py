"""What must hold between the values of a case file.

Each rule reads the few values it needs straight from the data, so that it still
speaks when something else in the file is wrong; it is silent when they are.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from coupling_design.case.build.catalogue import NO_CATALOGUES, Catalogues
from coupling_design.case.rules.bearings import check_contacts
from coupling_design.case.rules.catalogue import check_catalogues
from coupling_design.case.rules.choices import GAPPED, check_choices
from coupling_design.case.rules.engine import check_engine, check_working_engine
from coupling_design.case.schema.single_values import (
    Values,
    check_ordered,
    check_unique,
)
from coupling_design.case.text.document import Document
from coupling_design.case.text.fault import Path, Problem
from coupling_design.case.values.kinds import (
    STRESS_COEFFICIENT,
    AngularSpeed,
    CrankAngles,
    Force,
    Gap,
    Length,
    Number,
    PositiveTorque,
    Reliability,
    Stiffness,
    Stress,
    StressCoefficient,
    Time,
)
from coupling_design.case.values.quantity import exceeds
from coupling_design.machine.words import LoadLimitReading
from coupling_design.parts.bearing.life import RELIABILITY_FACTORS

_MOST_STEPS = 10_000_000
_FEWEST_STEPS = 100  # fewer show no vibration, whatever its frequency


def check_relations(
    document: Document, catalogues: Catalogues = NO_CATALOGUES
) -> Iterator[Problem]:
    """Yield every broken relation whose values can be read."""
    values = Values(document)
    yield from _ordered_pairs(values)
    yield from _unique_entries(values)
    yield from _two_bearings(values)
    yield from _shutdown(values)
    yield from _chances(values)
    yield from _reliability(values)
    yield from _load_limit(values)
    yield from check_contacts(values)
    yield from check_engine(values, document.file)
    yield from check_working_engine(values, document.file)
    series = [series.name for series in catalogues.types]
    yield from check_choices(values, series if catalogues.is_sound else None)
    yield from check_catalogues(values, catalogues)


def _ordered_pairs(values: Values) -> Iterator[Problem]:
    pairs: list[tuple[Any, Path, Path]] = [
        (
            AngularSpeed,
            ("duty", "working_speed", "lowest"),
            ("duty", "working_speed", "highest"),
        ),
        (PositiveTorque, ("duty", "rated_torque"), ("duty", "peak_torque")),
    ]
    for kind in GAPPED:
        space = ("design_space", "connections", kind)
        pairs.append((Gap, (*space, "minimum_gap"), (*space, "maximum_gap")))
    for index in range(values.count("coupling_types")):
        entry: Path = ("coupling_types", index)
        low, high = (*entry, "stiffness", "lowest"), (*entry, "stiffness", "highest")
        pairs.append((Stiffness, low, high))
        low, high = (*entry, "nominal_torque"), (*entry, "maximum_torque")
        pairs.append((PositiveTorque, low, high))
    yield from check_ordered(values, pairs)


def _unique_entries(values: Values) -> Iterator[Problem]:
    yield from check_unique(values, ("driveline", "excitation"), "order", Number)
    yield from check_unique(values, ("coupling_types",), "name")
    yield from check_unique(values, ("bearings",), "name")


def _two_bearings(values: Values) -> Iterator[Problem]:
    count = values.count("bearings")
    if isinstance(values.raw("bearings"), list) and count != 2:
        yield Problem(
            ("bearings",),
            f"found a list of {count}, allowed are exactly 2: first the one next to "
            "the coupling, then the other",
        )


def _shutdown(values: Values) -> Iterator[Problem]:
    path: Path = ("shutdown", "time_step")
    step = values.read(Time, *path)
    duration = values.read(Time, "shutdown", "duration")
    if step is None or duration is None:
        return
    found = f"found '{values.text(*path)}'"
    if exceeds(step, duration):
        limit = values.text("shutdown", "duration")
        yield Problem(path, f"{found}, allowed at most the duration '{limit}'")
    elif duration / step < _FEWEST_STEPS * (1 - 1e-9):
        yield Problem(
            path,
            f"{found}, which makes {duration / step:.3g} steps; allowed are "
            f"{_FEWEST_STEPS} or more: write a shorter step or a longer duration",
        )
    elif duration / step > _MOST_STEPS:
        yield Problem(
            path,
            f"{found}, which makes {duration / step:.3g} steps; "
            f"allowed {duration / _MOST_STEPS:g} s or more",
        )
    elif abs(round(duration / step) * step - duration) > 1e-6 * duration:
        whole = duration / round(duration / step)
        yield Problem(
            path,
            f"{found}, which does not divide the duration; write {whole:.9g} s",
        )


def _chances(values: Values) -> Iterator[Problem]:
    path: Path = ("shutdown", "crank_angles")
    number = values.read(CrankAngles, *path)
    if number is not None and number % 1:
        yield Problem(
            path, f"found '{values.text(*path)}', allowed are whole numbers, such as 8"
        )


def _load_limit(values: Values) -> Iterator[Problem]:
    """Yield a bearing whose weight alone leaves nothing to a transmission force."""
    reading = values.read(LoadLimitReading, "reading")
    l_2, l_3, weight = (
        values.read(kind, "shaft", key)
        for kind, key in (
            (Length, "bearing_1_to_rotor"),
            (Length, "rotor_to_bearing_2"),
            (Force, "rotor_weight"),
        )
    )
    if reading is not LoadLimitReading.TRANSMISSION_FORCE or None in (l_2, l_3, weight):
        return
    statics = (weight * l_3 / (l_2 + l_3), weight * l_2 / (l_2 + l_3))
    for index, static in enumerate(statics):
        entry: Path = ("bearings", index)
        path: Path = (*entry, "stress_coefficient")
        K_1 = values.read(StressCoefficient, *path)
        S_min = values.read(Stress, *entry, "minimum_stress")
        if K_1 is None or S_min is None:
            continue
        is_line = STRESS_COEFFICIENT.unit_of(values.text(*path)) == "Pa/N^0.5"
        F_min = (S_min / K_1) ** (2 if is_line else 3)
        if F_min <= static:
            yield Problem(
                path,
                f"found '{values.text(*path)}': with its minimum_stress F_min is "
                f"{F_min:.4g} N, no more than the {static:.4g} N of the rotor's weight "
                "that this bearing carries, and no force at the coupling would be "
                "permitted; correct K1, S_min or the weight, or read the limit as "
                "combined_load",
            )


def _reliability(values: Values) -> Iterator[Problem]:
    path: Path = ("lubrication", "reliability")
    value = values.read(Reliability, *path)
    if value is None or any(abs(value - row) < 1e-9 for row in RELIABILITY_FACTORS):
        return
    rows = ", ".join(f"{100 * row:g}" for row in RELIABILITY_FACTORS)
    yield Problem(
        path,
        f"found '{values.text(*path)}', between the rows of ISO 281; "
        f"allowed, in %: {rows}",
    )

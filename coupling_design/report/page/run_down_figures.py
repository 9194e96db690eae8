"""Figures over the time of a run-down: speed, forces, loads, life, damage."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from coupling_design.flow.outcome import DesignOutcome
from coupling_design.report.page.envelope import (
    CLOSER_LOOK,
    Bins,
    bins_around,
    extremes,
)
from coupling_design.report.page.figure import (
    ROLE_COLOURS,
    ROLE_WIDTHS,
    Curve,
    Figure,
    Limit,
    Row,
    stack,
)
from coupling_design.report.words.units import displayed, quantity
from coupling_design.wear.signals import RundownHistory

Floats = NDArray[np.float64]
Signal = Callable[[RundownHistory], Floats]

PEAK_FORCE = "peak transmission force"
_TIME = "time since the shutdown began [s]"
_KAPPA_RANGE = (
    Limit("below 0.1 taken as 0.1", 0.1),
    Limit("above 4 taken as 4", 4.0),
)
_LIVES = (
    ("kappa [-]", "viscosity_ratio", _KAPPA_RANGE, True),
    ("e_C [-]", "contamination_factor", (), False),
    ("a_ISO [-]", "life_modification_factor", (), True),
    ("L_10 [rev]", "basic_rating_life", (), True),
    ("L_p [rev]", "modified_rating_life", (), True),
)


def run_down_figures(outcome: DesignOutcome) -> tuple[Figure, ...]:
    """Return the figures of the present run-down and of the one beside it."""
    if not outcome.histories:
        return ()
    pen = _Pen(outcome.histories)
    return (
        _speed(pen),
        _transmission_force(pen, outcome),
        _collision_force(pen),
        _loads(pen, outcome),
        _lives(pen, outcome),
        _damage(pen, outcome),
    )


@dataclass(frozen=True)
class _Pen:
    """Draws signals of the run-downs over one set of bins."""

    rundowns: Sequence[RundownHistory]

    @cached_property
    def bins(self) -> Bins:
        moments = [rundown.resonance for rundown in self.rundowns]
        return bins_around(self.rundowns[0].driveline.time, moments)

    def curve(
        self,
        rundown: RundownHistory,
        signal: Floats,
        unit: str = "",
    ) -> Curve:
        drawn = extremes(signal, self.bins)
        return Curve(
            f"{rundown.role}: {rundown.label}",
            rundown.driveline.time[drawn],
            displayed(signal[drawn], unit),
            ROLE_COLOURS[rundown.role],
            ROLE_WIDTHS[rundown.role],
        )

    def all_curves(self, signal: Signal, unit: str = "") -> tuple[Curve, ...]:
        return tuple(self.curve(r, signal(r), unit) for r in self.rundowns)

    def of_bearing(self, k: int, name: str, unit: str = "") -> tuple[Curve, ...]:
        """Return a signal of one bearing, by its name in `BearingHistory`."""
        return self.all_curves(lambda r: getattr(r.bearings[k], name), unit)

    def figure(self, key: str, title: str, caption: str, rows: Sequence[Row]) -> Figure:
        traces, layout, height = stack(rows, _TIME)
        time = self.rundowns[0].driveline.time
        layout["xaxis"]["range"] = [float(time[0]), float(time[-1])]
        reach = CLOSER_LOOK * float(time[-1] - time[0])
        middle = self.rundowns[0].resonance
        return Figure(
            key,
            title,
            caption,
            self.bins.note,
            height,
            traces,
            layout,
            (max(middle - reach, 0.0), middle + reach),
        )


def _speed(pen: _Pen) -> Figure:
    rows = (
        Row(
            "engine [rpm]",
            pen.all_curves(lambda r: r.driveline.engine_speed, "rad/s"),
        ),
        Row(
            "generator [rpm]",
            pen.all_curves(lambda r: r.driveline.generator_speed, "rad/s"),
        ),
    )
    caption = "Speed of both shafts from the shutdown on."
    return pen.figure("speed", "Run-down speed", caption, rows)


def _transmission_force(pen: _Pen, outcome: DesignOutcome) -> Figure:
    above = tuple(force_limits(outcome))
    below = tuple(Limit("", -limit.value) for limit in above)
    rows = [
        Row(
            f"F_c, {r.role} [kN]",
            (pen.curve(r, r.driveline.transmission_force, "N"),),
            above + below,
        )
        for r in pen.rundowns
    ]
    caption = (
        "Force between hub and generator shaft, and how large it may become either way."
    )
    return pen.figure("transmission-force", "Transmission force", caption, rows)


def _collision_force(pen: _Pen) -> Figure:
    rows = [
        Row(f"{r.role} [kN]", (pen.curve(r, r.collision_force, "N"),))
        for r in pen.rundowns
    ]
    caption = (
        "The fast part of the transmission force: what is left of it when its slow "
        "part, a parabola over each eighth of a period of the natural frequency, is "
        "taken away. A tight fit has no collisions; what is seen there is the error of "
        "this separation."
    )
    return pen.figure("collision-force", "Collision force", caption, rows)


def force_limits(outcome: DesignOutcome) -> Iterator[Limit]:
    """Yield what F_c may reach: as the case reads its limit, and strictly."""
    forces: dict[str, float] = {}
    for step in outcome.steps:
        for criterion in step.criteria:
            if criterion.name == PEAK_FORCE and criterion.limit is not None:
                forces["limit"] = criterion.limit
    if outcome.strict_reading is not None:
        strict = outcome.strict_reading.permissible_transmission_force
        forces["read strictly"] = strict
    for words, force in forces.items():
        text = f"{words} {quantity(force, 'N')} kN"
        yield Limit(text, float(displayed(force, "N")))


def _loads(pen: _Pen, outcome: DesignOutcome) -> Figure:
    rows = []
    for k, bearing in enumerate(outcome.case.bearings):
        least = pen.rundowns[0].bearings[k].minimum_load
        limit = Limit(f"F_min {quantity(least, 'N')} kN", float(displayed(least, "N")))
        curves = pen.of_bearing(k, "combined_load", "N")
        rows.append(Row(f"F_l, {bearing.name} [kN]", curves, (limit,)))
    caption = (
        "Rotating and static load of each bearing together, against F_min, the load "
        "at which the contact stress reaches S_min."
    )
    return pen.figure("loads", "Combined loads", caption, rows)


def _lives(pen: _Pen, outcome: DesignOutcome) -> Figure:
    first, second = outcome.baseline.performance.damages
    k = 0 if first >= second else 1
    rows = [
        Row(label, pen.of_bearing(k, signal), limits, is_logarithmic)
        for label, signal, limits, is_logarithmic in _LIVES
    ]
    caption = (
        f"Life after ISO 281:2007 of {outcome.case.bearings[k].name}, which suffers "
        "more: viscosity ratio kappa, contamination factor e_C, life modification "
        "factor a_ISO, basic rating life L_10 and modified rating life L_p, all for "
        "the load and speed of each moment."
    )
    return pen.figure("life", "Life indices", caption, rows)


def _damage(pen: _Pen, outcome: DesignOutcome) -> Figure:
    rows = [
        Row(f"D, {bearing.name} [-]", pen.of_bearing(k, "damage"))
        for k, bearing in enumerate(outcome.case.bearings)
    ]
    caption = (
        "Miner sum up to each moment. Its value at the end is the damage of the "
        "run-down in the tables."
    )
    return pen.figure("damage", "Accumulated damage", caption, rows)

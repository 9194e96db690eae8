"""The smoothing factor of the key's contact, which the paper gives without a unit."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping

import numpy as np
from matplotlib.figure import Figure

from coupling_design.arithmetic import FloatArray
from coupling_design.errors import CaseError
from coupling_design.line.contact import (
    contact_deflection,
    contact_slope,
    half_gap_angle,
)
from coupling_design.line.parameters import KeyedConnection
from coupling_design.machine.machine import Case
from coupling_design.steps.present import present_candidate
from coupling_design.wear.evaluator import Evaluator
from coupling_design.wear.performance import Performance
from studies.drawing import BLUE, GREY, ORANGE, RED, canvas
from studies.forces import change
from studies.judgement import Contrast
from studies.machine import present_performance, present_point

SIGMA = 1000.0


def keys(case: Case) -> Mapping[str, KeyedConnection]:
    """Return the present key with sigma per radian, per metre and per millimetre."""
    key = case.driveline.connection
    if not isinstance(key, KeyedConnection):
        raise CaseError([f"{case.file}: driveline.connection: this study needs a key"])
    smoothings = {
        "per radian": SIGMA / key.radius,
        "per metre": SIGMA,
        "per millimetre": SIGMA * 1e3,
    }
    return {
        name: dataclasses.replace(key, smoothing=value)
        for name, value in smoothings.items()
    }


def smoothing_unit(case: Case) -> list[Contrast]:
    """Return slope of the contact in the gap and its damage, by the unit of sigma."""
    readings = keys(case)
    per_mm = readings["per millimetre"]
    now = present_performance(case)
    found = []
    for name in ("per radian", "per metre"):
        key = readings[name]
        seat = dataclasses.replace(case.hub_seat, smoothing=key.smoothing)
        blunt = Evaluator(
            dataclasses.replace(case, hub_seat=seat), present_candidate(case)
        )
        other = blunt.performance(*present_point(case))
        found.append(
            Contrast(
                f"Sigma = {SIGMA:g} {name}: how stiff is the middle of the gap?",
                f"sigma {name}",
                float(contact_slope(0.0, key)),
                "sigma per millimetre",
                float(contact_slope(0.0, per_mm)),
                "of the contact's stiffness",
                "per millimetre, as the case says",
                f"Between the flanks the slope is negative over "
                f"{100 * negative_share(key):.1f} % of the gap (per millimetre "
                f"{100 * negative_share(per_mm):.1f} %), least "
                f"{least_slope(key):.3f} ({least_slope(per_mm):.3f}). Against the case "
                f"D changes by {change(other.damage, now.damage):+.2f} %, the peak of "
                f"Fc by {change(peak(other), peak(now)):+.2f} %.",
            )
        )
    return found


def slopes(key: KeyedConnection) -> FloatArray:
    """Return the contact's relative slope between the flanks."""
    b = float(half_gap_angle(key))
    found: FloatArray = contact_slope(np.linspace(-b, b, 20001), key)
    return found


def least_slope(key: KeyedConnection) -> float:
    """Return the least slope of f between the flanks [-]."""
    return float(slopes(key).min())


def negative_share(key: KeyedConnection) -> float:
    """Return the share of the gap over which the contact's slope is negative.

    A slope of less than a thousandth counts as none.
    """
    return float(np.mean(slopes(key) < -1e-3))


def peak(performance: Performance) -> float:
    """Return the peak of Fc [N]."""
    return float(performance.peak_transmission_force)


def draw(readings: Mapping[str, KeyedConnection]) -> Figure:
    """Return the contact over the gap for each reading of sigma."""
    figure, (axes,) = canvas(1, height=3.0)
    for (name, key), color in zip(readings.items(), (RED, ORANGE, BLUE), strict=True):
        b = float(half_gap_angle(key))
        x = np.linspace(-2 * b, 2 * b, 2001)
        deflection = contact_deflection(x, key)
        axes.plot(x / b, deflection / b, color=color, label=f"{SIGMA:g} {name}")
    axes.axvspan(-1, 1, color=GREY, alpha=0.15, linewidth=0)
    axes.set_xlabel("twist at the key, of half the gap")
    axes.set_ylabel("deflection f, of half the gap")
    axes.legend(title="sigma")
    return figure

"""What is to be said of a design as a whole: why there is none, how run-downs end."""

from __future__ import annotations

from collections.abc import Iterator

from coupling_design.bearing.contact_stress import minimum_load
from coupling_design.bearing.loads import static_loads
from coupling_design.case.case import Case
from coupling_design.design.endings import describe_ending, ending_warnings
from coupling_design.design.remarks import Remarks
from coupling_design.design.results import Baseline, ChosenDesign, Optimum

_REMEDY = "Correct its ratings, or take a larger bearing."


def remarks_on(
    case: Case,
    baseline: Baseline,
    chosen: ChosenDesign | None,
    nearest: Optimum | None,
) -> Remarks:
    """Return what is to be said of a result as a whole."""
    told = {"present": baseline.performance}
    if chosen is not None:
        told["chosen"] = chosen.performance
    return Remarks(
        reasons=() if chosen else reasons_for_none(case, nearest),
        warnings=ending_warnings(case, *told.values()),
        endings=tuple(
            (role, sentence)
            for role, performance in told.items()
            if (sentence := describe_ending(case, performance)) is not None
        ),
    )


def reasons_for_none(case: Case, nearest: Optimum | None) -> tuple[str, ...]:
    """Return the reasons in sentences, none where it is the coupling that fails."""
    static = tuple(_overloaded_at_rest(case))
    return static or tuple(_dies_within_a_stop(case, nearest))


def _overloaded_at_rest(case: Case) -> Iterator[str]:
    for bearing, weight in zip(case.bearings, static_loads(case.shaft), strict=True):
        limit = float(minimum_load(bearing))
        if float(weight) > limit:
            yield (
                f"The static load alone is above the limit: the rotor's weight on "
                f"{bearing.name}, {float(weight) / 1e3:.4g} kN, exceeds its F_min, "
                f"{limit / 1e3:.4g} kN. No coupling mends that: correct K1, S_min or "
                "the weight, or take a larger bearing."
            )


def _dies_within_a_stop(case: Case, nearest: Optimum | None) -> Iterator[str]:
    if nearest is None:
        return
    performance = nearest.performance
    if performance.damage >= 1.0:
        yield (
            f"The bearing does not survive one stop: its damage D is "
            f"{performance.damage:.3g}, and 1 is the end of its life. {_REMEDY}"
        )
    loads = zip(case.bearings, performance.peak_combined_load, strict=True)
    for bearing, load in loads:
        rating = float(bearing.static_load_rating)
        if float(load) > rating:
            yield (
                f"{bearing.name} does not survive one stop: its peak load, "
                f"{float(load) / 1e3:.4g} kN, is above its static rating C_0, "
                f"{rating / 1e3:.4g} kN. {_REMEDY}"
            )

"""The words a case file chooses from."""

from __future__ import annotations

from enum import StrEnum


class LoadLimitReading(StrEnum):
    """What the bearing's load limit is compared with.

    `transmission_force` is the paper's reading, the force at the key;
    `combined_load` the strict one, the load at the bearing.
    """

    TRANSMISSION_FORCE = "transmission_force"
    COMBINED_LOAD = "combined_load"


class StartWord(StrEnum):
    """What the line does when a run-down begins, where no fuel is cut."""

    SETTLED = "settled"
    QUASI_STEADY = "quasi_steady"


class Plan(StrEnum):
    """Soft coupling, or one stiff enough to lie above every excitation."""

    ELASTIC = "elastic"
    HIGH_STIFFNESS = "high_stiffness"


class ConnectionKind(StrEnum):
    """How the hub sits on the generator shaft."""

    KEY = "key"
    SPLINE = "spline"
    TIGHT_FIT = "tight_fit"


class Choice(StrEnum):
    """What the design settles on: the ideal stiffness, or the best real size."""

    OPTIMUM = "optimum"
    CATALOGUE = "catalogue"


class Source(StrEnum):
    """Where a value comes from."""

    PAPER = "paper"
    STANDARD = "standard"
    DERIVED = "derived"
    ASSUMED = "assumed"
    FITTED = "fitted"
    CATALOGUE = "catalogue"
    MEASURED = "measured"
    INVENTED = "invented"

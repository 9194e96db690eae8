"""What is to be said of a result beside its numbers: plain sentences."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Remarks:
    """Sentences on a result as a whole.

    Attributes
    ----------
    reasons : why there is no design, where that is no matter of the coupling
    warnings : what stands at the top of the report
    endings : run-downs that do not come to rest: present or chosen, and what that means
    """

    reasons: tuple[str, ...] = ()
    warnings: tuple[str, ...] = ()
    endings: tuple[tuple[str, str], ...] = ()

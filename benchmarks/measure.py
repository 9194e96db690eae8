"""Timing several things in turns, so that a busy computer slows all of them."""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass


@dataclass(frozen=True)
class Timings:
    """Seconds of each thing in each round."""

    rounds: dict[str, list[float]]

    def seconds(self, name: str) -> float:
        """Return the median."""
        return statistics.median(self.rounds[name])

    def ratio(self, name: str, peer: str) -> float:
        """Return the median of the ratios within each round."""
        pairs = zip(self.rounds[name], self.rounds[peer], strict=True)
        return statistics.median(one / other for one, other in pairs)

    def best_ratio(self, name: str, peer: str) -> float:
        """Return the ratio of the shortest times: for what needs all the cores."""
        return min(self.rounds[name]) / min(self.rounds[peer])


def time_in_turns(
    things: Mapping[str, Callable[[], object]], rounds: int, *, warm_up: bool = True
) -> Timings:
    """Return how long each thing takes, each once a round after one for warming up.

    What takes many seconds and has run before needs no warming up.
    """
    for thing in things.values() if warm_up else ():
        thing()
    taken: dict[str, list[float]] = {name: [] for name in things}
    for _ in range(rounds):
        for name, thing in things.items():
            began = time.perf_counter()
            thing()
            taken[name].append(time.perf_counter() - began)
    return Timings(taken)

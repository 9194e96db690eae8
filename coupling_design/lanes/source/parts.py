"""A step in three parts: its motion, what follows from it, and what adds up.

Only the motion has to be computed one step after another. What follows from it, such
as the wear of each step, waits for nothing and nothing waits for it; and a total only
takes in a number a step.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from coupling_design.lanes.graph.graph import Graph


@dataclass(frozen=True)
class Parts:
    """A step's values, each in one part, in an order to compute them in.

    Attributes
    ----------
    before : do not change from step to step
    motion : what the next state depends on, but for totals
    effects : follow from the motion, and act on totals only
    adding : depend on the totals
    totals : states that act on no others but totals
    """

    before: tuple[int, ...]
    motion: tuple[int, ...]
    effects: tuple[int, ...]
    adding: tuple[int, ...]
    totals: frozenset[int]


def in_parts(graph: Graph, outputs: list[int]) -> Parts:
    """Return the parts of a step that has these values as its next state."""
    acting = _states_behind(graph, outputs)
    totals = _totals([acting[place] for place in outputs])
    adds = sum(1 << state for state in totals)
    moved = [place for state, place in enumerate(outputs) if state not in totals]
    motion, needed = set(graph.needed(moved)), graph.needed(outputs)
    # Both halves of a pair stay together: only numbers go from part to part.
    halves = [place for place in needed if graph[place].kind in ("sine", "cosine")]
    motion |= {place for place in halves if graph[place].args[0] in motion}
    moving = [place for place in needed if graph[place].moves]
    adding = {place for place in moving if acting[place] & adds}
    return Parts(
        before=tuple(place for place in needed if not graph[place].moves),
        motion=tuple(place for place in moving if place in motion),
        effects=tuple(place for place in moving if place not in motion | adding),
        adding=tuple(place for place in moving if place in adding),
        totals=frozenset(totals),
    )


def used_by(graph: Graph, places: Iterable[int]) -> set[int]:
    """Return all arguments of some values."""
    return {arg for place in places for arg in graph[place].args}


def _states_behind(graph: Graph, outputs: list[int]) -> dict[int, int]:
    """Return a bit for each state that a value depends on, by its place."""
    acting: dict[int, int] = {}
    for place in graph.needed(outputs):
        value = graph[place]
        acting[place] = 1 << int(value.number) if value.kind == "state" else 0
        for arg in value.args:
            acting[place] |= acting[arg]
    return acting


def _totals(acting: list[int]) -> set[int]:
    """Return the states that act on themselves and on other totals only."""
    n = len(acting)
    acted_on = [{i for i in range(n) if acting[i] >> j & 1} - {j} for j in range(n)]
    totals: set[int] = set()
    while True:
        more = {state for state in range(n) if acted_on[state] <= totals} - totals
        if not more:
            return totals
        totals |= more

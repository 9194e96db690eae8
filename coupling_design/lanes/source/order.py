"""The order in which a part's values are computed.

A processor looks some hundred instructions ahead. Values that do not wait for each
other belong next to each other, so that one's waiting is the other's work.
"""

from __future__ import annotations

import heapq
from collections.abc import Iterable

from coupling_design.lanes.graph.graph import Graph

# Cycles until a value is there, as measured on several processors, roughly.
_WAIT = {
    "sin": 55,
    "cos": 55,
    "log": 100,
    "exp": 58,
    "div": 15,
    "sqrt": 25,
    "tanh": 90,
    "pressed": 90,
}
_USUAL_WAIT = 4

Task = tuple[int, ...]


def as_written(graph: Graph, places: Iterable[int]) -> list[Task]:
    """Return values in their own order, as far as groups allow.

    A task is one value, or a group of hyperbolic tangents that do not wait for each
    other.
    """
    return _sorted(graph, {place: place for place in places})


def earliest_first(graph: Graph, places: Iterable[int]) -> list[Task]:
    """Return the same with what can start first in front."""
    ready: dict[int, int] = {}
    start: dict[int, int] = {}
    for place in places:
        value = graph[place]
        start[place] = max((ready.get(arg, 0) for arg in value.args), default=0)
        ready[place] = start[place] + _WAIT.get(value.kind, _USUAL_WAIT)
    return _sorted(graph, start)


def _sorted(graph: Graph, priority: dict[int, int]) -> list[Task]:
    """Return tasks, each after those it needs, otherwise by priority."""
    task_of = {p: task for task in _tasks(graph, list(priority)) for p in task}
    tasks = set(task_of.values())
    needs = {
        task: {task_of[a] for p in task for a in graph[p].args if a in task_of} - {task}
        for task in tasks
    }
    needed_by: dict[Task, list[Task]] = {task: [] for task in tasks}
    for task in tasks:
        for other in needs[task]:
            needed_by[other].append(task)
    missing = {task: len(needs[task]) for task in tasks}

    def entry(task: Task) -> tuple[int, Task]:
        return max(priority[place] for place in task), task

    waiting = [entry(task) for task in tasks if not missing[task]]
    heapq.heapify(waiting)
    ordered: list[Task] = []
    while waiting:
        _, task = heapq.heappop(waiting)
        ordered.append(task)
        for other in needed_by[task]:
            missing[other] -= 1
            if not missing[other]:
                heapq.heappush(waiting, entry(other))
    return ordered


def _tasks(graph: Graph, places: list[int]) -> list[Task]:
    """Return single values, and together the tangents with as many others before."""
    depth: dict[int, int] = {}
    groups: dict[int, list[int]] = {}
    for place in places:
        value = graph[place]
        depth[place] = max((depth.get(arg, 0) for arg in value.args), default=0)
        if value.kind == "tanh":
            depth[place] += 1
            groups.setdefault(depth[place], []).append(place)
    single = [(place,) for place in places if graph[place].kind != "tanh"]
    return [*single, *(tuple(group) for group in groups.values())]

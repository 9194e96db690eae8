"""Sines and cosines of one angle's multiples, from a single sine and cosine.

An engine's torque is a sum of orders of its crank angle, and Runge-Kutta's stages ask
for it at angles that differ by a small turn. One sine and cosine are computed a step;
turns and multiples follow by the theorems of addition.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, field

from coupling_design.lanes.graph.algebra import Algebra
from coupling_design.lanes.graph.graph import Graph

_LARGEST_MULTIPLE = 64  # of the common divisor: errors grow with it
_DIVISORS = (1, 2, 3, 4, 5, 6)
_WHOLE = 1e-12


@dataclass(frozen=True)
class _Wave:
    """sin or cos of multiple times angle + phase; no place for a phase of zero."""

    kind: str
    multiple: float
    angle: int
    phase: int | None


@dataclass
class _Family:
    """Angles that differ from the first by small turns, and the multiples in use."""

    angle: int
    turns: dict[int, int] = field(default_factory=dict)
    multiples: set[float] = field(default_factory=set)
    waves: int = 0


def share_harmonics(graph: Graph, outputs: list[int]) -> tuple[Graph, list[int]]:
    """Return the graph with the waves of each angle made of one sine and cosine."""
    return _Sharer(graph, outputs).run(outputs)


class _Sharer:
    def __init__(self, graph: Graph, outputs: list[int]) -> None:
        self.old = graph
        self.order = graph.needed(outputs)
        self.waves = {p: wave for p in self.order if (wave := _wave(graph, p))}
        self.divisors = dict(_shared_angles(graph, self.waves))
        self.algebra = Algebra(Graph())
        self.new_places: dict[int, int] = {}
        self.harmonics: dict[tuple[int, int], tuple[int, int]] = {}

    def run(self, outputs: list[int]) -> tuple[Graph, list[int]]:
        """Rebuild every needed value."""
        for place in self.order:
            self.new_places[place] = self._rebuilt(place)
        return self.algebra.graph, [self.new_places[place] for place in outputs]

    def _rebuilt(self, place: int) -> int:
        value = self.old[place]
        wave = self.waves.get(place)
        if wave is not None and wave.angle in self.divisors:
            return self._wave(wave)
        return self.algebra.graph.copy_of(value, self.new_places)

    def _wave(self, wave: _Wave) -> int:
        """Return sin(k x + p) = sin k x cos p + cos k x sin p, or the cosine's like."""
        apply = self.algebra.apply
        divisor = self.divisors[wave.angle][0]
        sine, cosine = self._harmonic(wave.angle, round(wave.multiple / divisor))
        if wave.phase is None:
            return sine if wave.kind == "sin" else cosine
        sin_p, cos_p = self._of_phase(self.new_places[wave.phase])
        if wave.kind == "sin":
            return apply("add", apply("mul", sine, cos_p), apply("mul", cosine, sin_p))
        return apply("sub", apply("mul", cosine, cos_p), apply("mul", sine, sin_p))

    def _of_phase(self, phase: int) -> tuple[int, int]:
        graph = self.algebra.graph
        if not graph.is_constant(phase):
            return graph.place("sin", (phase,)), graph.place("cos", (phase,))
        number = graph[phase].number
        return graph.constant(math.sin(number)), graph.constant(math.cos(number))

    def _harmonic(self, angle: int, k: int) -> tuple[int, int]:
        """Return sine and cosine of k times the divisor times an angle."""
        if (angle, k) not in self.harmonics:
            self.harmonics[angle, k] = (
                self._fundamental(angle) if k == 1 else self._multiple(angle, k)
            )
        return self.harmonics[angle, k]

    def _multiple(self, angle: int, k: int) -> tuple[int, int]:
        apply, two = self.algebra.apply, self.algebra.graph.constant(2.0)
        if k % 2 == 0:
            s, c = self._harmonic(angle, k // 2)
            one = self.algebra.graph.constant(1.0)
            twice = apply("mul", two, s)
            return apply("mul", twice, c), apply("sub", one, apply("mul", twice, s))
        (s, c), (s_1, c_1) = self._harmonic(angle, k - 1), self._harmonic(angle, 1)
        return (
            apply("add", apply("mul", s, c_1), apply("mul", c, s_1)),
            apply("sub", apply("mul", c, c_1), apply("mul", s, s_1)),
        )

    def _fundamental(self, angle: int) -> tuple[int, int]:
        apply, graph = self.algebra.apply, self.algebra.graph
        number, first, turn = self.divisors[angle]
        divisor = graph.constant(number)
        full = apply("mul", divisor, self.new_places[angle])
        if turn is None:
            pair = graph.place("wave", (full,))
        else:
            by = self._scaled(number, self.new_places[turn])
            pair = graph.place("turned", (*self._harmonic(first, 1), by, full))
        return graph.place("sine", (pair,)), graph.place("cosine", (pair,))

    def _scaled(self, number: float, place: int) -> int:
        """Return a constant times a value, one product where that is a product too."""
        graph = self.algebra.graph
        value = graph[place]
        if value.kind == "mul":
            for factor, rest in (value.args, value.args[::-1]):
                if graph.is_constant(factor):
                    scale = graph.constant(number * graph[factor].number)
                    return self.algebra.apply("mul", scale, rest)
        return self.algebra.apply("mul", graph.constant(number), place)


def _wave(graph: Graph, place: int) -> _Wave | None:
    """Return a moving sine or cosine taken apart, None for any other value."""
    value = graph[place]
    if value.kind not in ("sin", "cos") or not value.moves:
        return None
    argument, phase = value.args[0], None
    if graph[argument].kind == "add":
        fixed = [arg for arg in graph[argument].args if not graph[arg].moves]
        if fixed:
            phase = fixed[0]
            argument = next(arg for arg in graph[argument].args if graph[arg].moves)
    if graph[argument].kind == "mul":
        for factor, angle in (graph[argument].args, graph[argument].args[::-1]):
            if graph.is_constant(factor) and graph[factor].number > 0:
                return _Wave(value.kind, graph[factor].number, angle, phase)
    return _Wave(value.kind, 1.0, argument, phase)


def _shared_angles(
    graph: Graph, waves: dict[int, _Wave]
) -> Iterator[tuple[int, tuple[float, int, int | None]]]:
    """Yield each angle with (divisor of its multiples, first angle, turn from it).

    Angles whose multiples have no common divisor, or that have one wave only, are
    left out.
    """
    for family in _families(graph, waves):
        divisor = _common_divisor(family.multiples)
        if divisor is not None and family.waves > 1:
            yield family.angle, (divisor, family.angle, None)
            for angle, turn in family.turns.items():
                yield angle, (divisor, family.angle, turn)


def _families(graph: Graph, waves: dict[int, _Wave]) -> list[_Family]:
    """Return the angles by the one that they are sums of: angle and turn."""
    angles = {wave.angle for wave in waves.values()}
    families: dict[int, _Family] = {}
    for wave in waves.values():
        first, turn = wave.angle, None
        if graph[first].kind == "add":
            for one, other in (graph[first].args, graph[first].args[::-1]):
                if one in angles and one != other:
                    first, turn = one, other
                    break
        family = families.setdefault(first, _Family(first))
        family.multiples.add(wave.multiple)
        family.waves += 1
        if turn is not None:
            family.turns[wave.angle] = turn
    return list(families.values())


def _common_divisor(multiples: set[float]) -> float | None:
    """Return the largest number of which all are small whole multiples, or None."""
    for part in _DIVISORS:
        divisor = min(multiples) / part
        ratios = [multiple / divisor for multiple in multiples]
        if all(abs(r / round(r) - 1) < _WHOLE for r in ratios) and (
            max(ratios) <= _LARGEST_MULTIPLE
        ):
            return divisor
    return None

"""Writing a graph as C: functions that take many steps, for any number of lanes."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field

from coupling_design.lanes.graph.graph import Graph
from coupling_design.lanes.source.expressions import VECTORS, Expressions
from coupling_design.lanes.source.order import Task, as_written, earliest_first
from coupling_design.lanes.source.parts import Parts, in_parts, used_by

# Two vectors side by side fill each other's waiting, while registers last: on a longer
# motion than this they do not.
_LONGEST_MOTION_OF_TWO = 400  # values

# Steps whose motion is computed before their effects: what is kept of them then stays
# in the first cache.
_ROOM, _FEWEST_STEPS, _MOST_STEPS = 3_000, 8, 32  # doubles for each lane

_FUNCTION = """
static void {name}(int64_t n_steps, int64_t width, int64_t stride,
    const double *constants, const double *parameters, const double *states,
    double *ends, double *history)
{{
    enum {{ STEPS = {steps}, ROW = (STEPS + 2) * {vectors} * LANES }};
    double rows[{rows} * ROW];
    memset(rows, 0, sizeof rows);
{before}
    for (int64_t first = 0; first < n_steps; first += STEPS) {{
        const int64_t steps = n_steps - first < STEPS ? n_steps - first : STEPS;
        for (int64_t at = 0; at < steps * width; at += width) {{
{recorded_motion}
{motion}
        }}
        for (int64_t at = 0; at < steps * width; at += {affected} * LANES) {{
{effects}
        }}
        for (int64_t at = 0; at < steps * width; at += width) {{
{recorded_totals}
{adding}
        }}
    }}
{after}
}}
"""

_MARCH = """
/* Marches `width` columns, at most `march_width`. Of a single one, the states at the
 * start of every step go to `history` (n_states, n_steps), unless it is NULL. */
void march(int64_t n_steps, int64_t width, int64_t stride, const double *constants,
           const double *parameters, const double *states, double *ends,
           double *history)
{{
{wider}    march_one(n_steps, width, stride, constants, parameters, states, ends,
              history);
}}
const int march_width = {width};
"""
_WIDER = """    if (SIDE_BY_SIDE && width > LANES) {
        march_two(n_steps, width, stride, constants, parameters, states, ends, NULL);
        return;
    }
"""


@dataclass
class Kernel:
    """C of a march, and the constants it is called with.

    Numbers are no part of the source, so that a step with other numbers finds its
    machine code ready.
    """

    source: str
    constants: list[float] = field(default_factory=list)


def write_kernel(graph: Graph, outputs: list[int]) -> Kernel:
    """Return the C function that repeats a step.

    Values that do not move are computed once, before the first step.
    """
    parts = in_parts(graph, outputs)
    writer = _Writer(graph, outputs, parts)
    source = writer.function("march_one", 1)
    if writer.is_long:
        source += _MARCH.format(wider="", width="LANES")
    else:
        two = writer.function("march_two", 2)
        source += f"\n#if SIDE_BY_SIDE{two}#else\n#define march_two march_one\n#endif\n"
        source += _MARCH.format(wider=_WIDER, width="LANES * (1 + SIDE_BY_SIDE)")
    return Kernel(source, writer.expressions.constants)


class _Writer:
    """Writes the loops of a march.

    What one loop leaves to the next lies in rows, one for each value, with an entry for
    each step and column. Their columns lie close together: `width` of them are needed,
    and a vector that is wider is partly overwritten by the next.
    """

    def __init__(self, graph: Graph, outputs: list[int], parts: Parts) -> None:
        self.graph, self.outputs, self.parts = graph, outputs, parts
        self.is_long = len(parts.motion) > _LONGEST_MOTION_OF_TWO
        self.expressions = Expressions(graph, outputs, parts)
        added = used_by(graph, parts.adding) | {outputs[i] for i in parts.totals}
        affecting = used_by(graph, parts.effects)
        motion, effects = set(parts.motion), set(parts.effects)
        fixed = {place for place in parts.before if not graph[place].is_shared}
        self.to_effects = sorted(affecting & (motion | fixed))
        self.to_adding = sorted(added & (motion | effects))
        self.from_motion = sorted((affecting & (motion | fixed)) | (added & motion))
        self.from_effects = sorted(added & effects)
        kept = [*self.from_motion, *self.from_effects]
        self.rows = {place: row for row, place in enumerate(kept)}

    def function(self, name: str, vectors: int) -> str:
        """Return the function that marches this many vectors side by side."""
        each = range(vectors)
        # Effects of two steps wait for nothing: as many again are side by side.
        affected = range(vectors if self.is_long else 2 * vectors)
        steps = _ROOM // max(len(self.rows), 1) // vectors // 8 * 8
        n_states = range(len(self.outputs))
        order = as_written if vectors > 1 else earliest_first
        return _FUNCTION.format(
            name=name,
            vectors=vectors,
            affected=len(affected),
            rows=max(len(self.rows), 1),
            steps=min(max(steps, _FEWEST_STEPS), _MOST_STEPS),
            recorded_motion=self._recorded(vectors, set(n_states) - self.parts.totals),
            recorded_totals=self._recorded(vectors, self.parts.totals),
            before=_lines(
                4,
                self._all(each, n_states, self._load_state),
                self._tasks(each, as_written(self.graph, self.parts.before)),
            ),
            motion=_lines(
                12,
                self._tasks(each, order(self.graph, self.parts.motion)),
                self._all(each, self.from_motion, self._keep),
                self._all(each, set(n_states) - self.parts.totals, self._next),
            ),
            effects=_lines(
                12,
                self._all(affected, self.to_effects, self._take),
                self._tasks(affected, earliest_first(self.graph, self.parts.effects)),
                self._all(affected, self.from_effects, self._keep),
            ),
            adding=_lines(
                12,
                self._all(each, self.to_adding, self._take),
                self._tasks(each, as_written(self.graph, self.parts.adding)),
                self._all(each, self.parts.totals, self._next),
            ),
            after=_lines(4, self._all(each, n_states, self._store_end)),
        )

    def _recorded(self, vectors: int, states: Iterable[int]) -> str:
        if vectors > 1:
            return ""
        row = "history[{i} * n_steps + first + at / width] = first_lane(s{i}a);"
        lines = [row.format(i=i) for i in sorted(states)]
        return _lines(12, ["if (history) {", *lines, "}"])

    def _tasks(self, vectors: range, tasks: list[Task]) -> list[str]:
        return [
            line
            for task in tasks
            for line in self.expressions.statements(task, vectors)
        ]

    def _all(
        self, vectors: range, numbers: Iterable[int], write: Callable[[int, int], str]
    ) -> list[str]:
        return [write(n, vector) for n in sorted(numbers) for vector in vectors]

    def _load_state(self, i: int, vector: int) -> str:
        state = f"s{i}{VECTORS[vector]}"
        return f"Real {state} = load(states + {i} * stride + {vector} * LANES);"

    def _store_end(self, i: int, vector: int) -> str:
        state = f"s{i}{VECTORS[vector]}"
        return f"store(ends + {i} * stride + {vector} * LANES, {state});"

    def _keep(self, place: int, vector: int) -> str:
        return f"store({self._row(place, vector)}, {self._name(place, vector)});"

    def _take(self, place: int, vector: int) -> str:
        name, row = self._name(place, vector), self._row(place, vector)
        return f"const Real {name} = load({row});"

    def _next(self, i: int, vector: int) -> str:
        return f"s{i}{VECTORS[vector]} = {self._name(self.outputs[i], vector)};"

    def _name(self, place: int, vector: int) -> str:
        return self.expressions.name(place, vector)

    def _row(self, place: int, vector: int) -> str:
        return f"rows + {self.rows[place]} * ROW + at + {vector} * LANES"


def _lines(indent: int, *groups: list[str]) -> str:
    return "\n".join(" " * indent + line for lines in groups for line in lines)

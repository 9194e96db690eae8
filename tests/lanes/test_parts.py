"""What of a step is motion, what follows from it, and what only adds up."""

import casadi as ca
import pytest

from coupling_design.lanes.graph.instructions import read_step
from coupling_design.lanes.source.order import as_written, earliest_first
from coupling_design.lanes.source.parts import in_parts
from coupling_design.lanes.source.tangents import grouped

WORN, WORST, UNUSED = 2, 3, 4


@pytest.fixture
def step():
    """An oscillator whose wear adds up; the largest angle; an entry of no use."""
    state, parameters = ca.SX.sym("state", 5), ca.SX.sym("parameters", 2)
    angle, speed, worn, worst, _ = ca.vertsplit(state)
    edge = 3 * parameters[1]
    push = ca.tanh(50 * (angle - edge)) + ca.tanh(50 * (angle + edge))
    drag = ca.tanh(speed / 0.2)
    wear = ca.exp(-ca.log(1 + speed**2) * parameters[0])
    following = ca.vertcat(
        angle + 0.1 * speed,
        speed - parameters[0] * ca.sin(angle) - push - drag,
        worn + wear,
        ca.fmax(worst, angle),
        wear,
    )
    return ca.Function("step", [state, parameters], [following])


def kinds(graph, places):
    return sorted(graph[place].kind for place in places)


def test_totals_act_on_no_other_state(step):
    assert in_parts(*read_step(step)).totals == {WORN, WORST, UNUSED}


def test_what_acts_back_is_motion_and_what_does_not_is_effect(step):
    graph, outputs = read_step(step)
    parts = in_parts(graph, outputs)
    assert {"sin", "tanh"} <= set(kinds(graph, parts.motion))
    assert {"exp", "log"} <= set(kinds(graph, parts.effects))
    assert not {"exp", "log"} & set(kinds(graph, parts.motion))
    assert kinds(graph, parts.adding) == ["add", "fmax", "state", "state"]


def test_every_needed_value_is_in_one_part(step):
    graph, outputs = read_step(step)
    parts = in_parts(graph, outputs)
    members = (*parts.before, *parts.motion, *parts.effects, *parts.adding)
    assert sorted(members) == graph.needed(outputs)


def test_two_states_that_act_on_each_other_are_no_totals():
    state, parameters = ca.SX.sym("state", 2), ca.SX.sym("p")
    turned = ca.vertcat(state[0] + state[1], state[1] - state[0])
    step = ca.Function("step", [state, parameters], [turned])
    assert in_parts(*read_step(step)).totals == set()


@pytest.mark.parametrize("order", [as_written, earliest_first])
def test_a_value_comes_after_what_it_needs(step, order):
    graph, outputs = read_step(step)
    parts = in_parts(graph, outputs)
    done = set(parts.before)
    for task in order(graph, parts.motion):
        assert {arg for place in task for arg in graph[place].args} <= done | set(task)
        done |= set(task)
    assert done == {*parts.before, *parts.motion}


def test_tangents_that_do_not_wait_for_each_other_are_one_group(step):
    graph, outputs = read_step(step)
    motion = in_parts(graph, outputs).motion
    tangents = [p for p in motion if graph[p].kind == "tanh"]
    group = next(t for t in as_written(graph, motion) if tangents[0] in t)
    assert sorted(group) == tangents


def test_the_two_edges_of_a_gap_are_a_pair(step):
    graph, outputs = read_step(step)
    tangents = tuple(
        p for p in in_parts(graph, outputs).motion if graph[p].kind == "tanh"
    )
    group = grouped(graph, tangents)
    assert len(group.pairs) == len(group.single) == 1
    edges = group.pairs[0]
    assert set(tangents) == {edges.minus, edges.plus, *group.single}
    assert graph[graph[graph[edges.minus].args[0]].args[1]].kind == "sub" or (
        graph[graph[graph[edges.minus].args[0]].args[0]].kind == "sub"
    )

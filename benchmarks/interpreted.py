"""CasADi's virtual machine and its own derivatives beside machine code."""

from __future__ import annotations

import casadi as ca

from benchmarks.measure import time_in_turns
from benchmarks.rollouts import both_marches, compared
from benchmarks.scale import Scale
from benchmarks.subject import Subject
from benchmarks.table import Row
from coupling_design.march.tower import march


def interpreted(subject: Subject, scale: Scale) -> list[Row]:
    """Return CasADi's virtual machine beside the machine code."""
    n_steps, batch = subject.case.shutdown.n_steps, subject.batch(1)
    value, gradient = both_marches(subject, n_steps)
    machine, joint = march(subject.step, n_steps), march(subject.joint_step, n_steps)
    times = time_in_turns(
        {
            "value": lambda: value(batch.starts, batch.points),
            "vm_value": lambda: machine(batch.starts, batch.points),
            "gradient": lambda: gradient(batch.joint_starts, batch.points),
            "vm_gradient": lambda: joint(batch.joint_starts, batch.points),
        },
        scale.rounds,
    )
    what = "CasADi's virtual machine, value against value"
    also = "the same, sensitivities in step against gradient"
    return [
        compared("vm_value", what, times, "value"),
        compared("vm_gradient", also, times, "gradient"),
    ]


def differentiated(subject: Subject, scale: Scale) -> list[Row]:
    """Return CasADi's own derivatives of a march beside sensitivities in its step.

    All on the virtual machine; fewer steps, to bear the memory.
    """
    n_steps, batch = subject.case.shutdown.n_steps // 10, subject.batch(1)
    start, point = ca.DM(batch.starts), ca.DM(batch.points)
    value, joint = march(subject.step, n_steps), march(subject.joint_step, n_steps)
    forward, reverse = value.forward(2), value.reverse(1)
    end = value(start, point)
    directions = ca.reshape(ca.DM(batch.joint_starts)[start.numel() :], -1, 2)
    times = time_in_turns(
        {
            "in step": lambda: joint(batch.joint_starts, point),
            "forward": lambda: forward(start, point, end, directions, ca.DM.eye(2)),
            "reverse": lambda: reverse(start, point, end, ca.DM.ones(end.shape)),
        },
        scale.rounds,
    )
    to = f"against sensitivities in step (virtual machine, {n_steps} steps)"
    return [
        compared("forward", f"CasADi forward, 2 directions {to}", times, "in step"),
        compared("reverse", f"CasADi reverse, 1 direction {to}", times, "in step"),
    ]

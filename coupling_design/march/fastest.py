"""The fastest marcher there is on this computer."""

from __future__ import annotations

from dataclasses import replace

import casadi as ca

from coupling_design.lanes.march import NotCompiled, compile_march
from coupling_design.march.marcher import Marcher, virtual_machine_marcher


def fastest_marcher(step: ca.Function, n_steps: int) -> Marcher:
    """Return a marcher of machine code, or else one on CasADi's virtual machine.

    Its `engine` says which, and in one line why it is not machine code.
    """
    compiled = compile_march(step, n_steps)
    if isinstance(compiled, NotCompiled):
        interpreted = virtual_machine_marcher(step, n_steps)
        reason = f"CasADi's virtual machine, 6 to 50 times slower: {compiled.reason}"
        return replace(interpreted, engine=reason)
    return Marcher(compiled, compiled.record, "machine code", is_compiled=True)

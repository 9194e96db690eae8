"""Run-downs of many candidate inputs at once, with the project's own driveline.

The lost inputs are parameters of one symbolic step, so that it is compiled once for
the key and once for the tight fit and serves every candidate.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import casadi as ca
import numpy as np

from coupling_design.arithmetic import FloatArray, Scalar, where
from coupling_design.events.shutdown import RunDown
from coupling_design.line.damping import coupling_damping
from coupling_design.line.motion import motion, reduced_inertia, state_names
from coupling_design.line.parameters import (
    Coupling,
    Driveline,
    KeyedConnection,
    ProportionalDamping,
    Resistance,
    Shutdown,
    TightFit,
)
from coupling_design.machine.machine import Case
from coupling_design.march.fastest import fastest_marcher
from coupling_design.march.marcher import Marcher
from coupling_design.parts.bearing.parameters import Cleanliness
from coupling_design.wear.quantities import TOTALS
from coupling_design.wear.step import joint_start, joint_step
from studies.identification.parameters import NAMES, Inputs
from studies.machine import high_stiffness, required_stiffness

# Beside TOTALS: what the coupling carries at most, how fast the generator turns then,
# and for how long it turns at all.
EXTRAS = ("peak_coupling_torque", "speed_at_peak", "turning_time")
_TURNING = 5 * math.pi / 30  # rad/s
_SPEED, _STIFFNESS, _DAMPING = (
    NAMES.index(name) for name in ("initial_speed", "stiffness", "damping_factor")
)
_GAP, _CRANK, _GRAVITY = (len(NAMES) + i for i in range(3))
BUILT_GAP = 0.28e-3


@dataclass(frozen=True)
class Variant:
    """What a candidate is rolled out with: `multiplier` of its stiffness, gap [m].

    `multiplier` None is the stiffest elastic coupling, see `stiffest_elastic`; gap
    None is a tight fit; `elastic` False the high-stiffness coupling.
    """

    multiplier: float | None = 1.0
    gap: float | None = BUILT_GAP
    elastic: bool = True


VARIANTS: Mapping[str, Variant] = {
    "present": Variant(),
    "half": Variant(0.5),
    "stiffer": Variant(1.1),
    "stiffest": Variant(None),
    "gap 0.1": Variant(gap=0.1e-3),
    "gap 0.3": Variant(gap=0.3e-3),
    "tight": Variant(gap=None),
    "high stiffness": Variant(gap=None, elastic=False),
}
MORE_VARIANTS: Mapping[str, Variant] = {
    **VARIANTS,
    "a little stiffer": Variant(1.05),
    "double": Variant(2.0),
    "threefold": Variant(3.0),
    "gap 0": Variant(gap=0.0),
    "gap 0.2": Variant(gap=0.2e-3),
    "half, tight": Variant(0.5, gap=None),
}


@dataclass(frozen=True)
class Rundowns:
    """What the variants of the candidates do, each total (n_candidates,)."""

    totals: Mapping[str, Mapping[str, FloatArray]]

    def __getitem__(self, at: tuple[str, str]) -> FloatArray:
        """Return a total of a variant."""
        variant, total = at
        return self.totals[variant][total]


def run(
    case: Case,
    candidates: Sequence[Inputs],
    refinement: int = 1,
    variants: Mapping[str, Variant] = VARIANTS,
) -> Rundowns:
    """Return what each variant of each candidate does, in the order given.

    `case` supplies what the paper prints; `refinement` divides its time step.
    """
    found: dict[str, dict[str, FloatArray]] = {name: {} for name in variants}
    for tight in (False, True):
        names = [name for name in variants if (variants[name].gap is None) == tight]
        if not names:
            continue
        blocks = [columns(case, candidates, variants[name]) for name in names]
        classes = [candidate.cleanliness for candidate in candidates] * len(names)
        ends = _march(case, np.hstack(blocks), classes, tight, refinement)
        for i, name in enumerate(names):
            part = slice(i * len(candidates), (i + 1) * len(candidates))
            found[name] = {total: row[part] for total, row in ends.items()}
    return Rundowns(found)


def columns(case: Case, candidates: Sequence[Inputs], variant: Variant) -> FloatArray:
    """Return the step's parameters (14, n_candidates) for a variant of each.

    The inputs, then the gap, the crank angle at the start and gravity's direction.
    """
    made = np.array([[*inputs.values, 0.0, *inputs.start] for inputs in candidates]).T
    made[_GAP] = variant.gap or 0.0
    if not variant.elastic:
        made[_STIFFNESS], made[_DAMPING] = _high_stiffness(case)
    elif variant.multiplier is None:
        made[_STIFFNESS] = stiffest_elastic(case, made[_SPEED])
    else:
        made[_STIFFNESS] *= variant.multiplier
    return made


def stiffest_elastic(case: Case, initial_speed: Scalar) -> Scalar:
    """Return the stiffness [N m/rad] that just isolates order 4 at idle, by sqrt 2."""
    frequency = 4 * initial_speed / math.sqrt(2)
    return frequency**2 * reduced_inertia(case.driveline)


@functools.cache
def _high_stiffness(case: Case) -> tuple[float, float]:
    """Return its stiffness, and the damping factor that amounts to its own law."""
    stiffness = required_stiffness(case)
    law = high_stiffness(case).candidate.coupling_type.damping_law
    inertia = reduced_inertia(case.driveline)
    damping = coupling_damping(Coupling(stiffness, law), inertia)
    return stiffness, damping * _characteristic_frequency(case) / stiffness


def _characteristic_frequency(case: Case) -> float:
    law = case.driveline.coupling.damping_law
    if not isinstance(law, ProportionalDamping):
        raise TypeError(f"{case.file}: the present coupling's damping must be its k's")
    return float(law.characteristic_frequency)


def _march(
    case: Case,
    parameters: FloatArray,
    classes: Sequence[Cleanliness],
    tight: bool,
    refinement: int,
) -> dict[str, FloatArray]:
    """Return each total at the end, per column."""
    ends: FloatArray = np.empty((len(TOTALS) + len(EXTRAS) + 1, parameters.shape[1]))
    for cleanliness in sorted(set(classes)):
        chosen = np.array([each is cleanliness for each in classes])
        start, march = _machinery(case, cleanliness, tight, refinement)
        inputs = np.ascontiguousarray(parameters[:, chosen])
        reached = march(np.asarray(start(inputs)), inputs)
        # Angles first, speeds after: the faster of engine and generator.
        turning = reached[[3, 5]] if not tight else reached[[2, 3]]
        totals = reached[-len(TOTALS) - len(EXTRAS) :]
        ends[:, chosen] = np.vstack([totals, turning.max(axis=0)])
    return dict(zip((*TOTALS, *EXTRAS, "final_speed"), ends, strict=True))


@functools.cache
def _machinery(
    case: Case, cleanliness: Cleanliness, tight: bool, refinement: int
) -> tuple[ca.Function, Marcher]:
    """Return the start of the state and what marches it."""
    case = replace(case, lubrication=replace(case.lubrication, cleanliness=cleanliness))
    p = ca.SX.sym("p", len(NAMES) + 3)
    line = driveline(case, p[: _GAP + 1], tight)
    shutdown = replace(
        case.shutdown,
        initial_speed=p[_SPEED],
        crank_angle=p[_CRANK],
        gravity_angle=p[_GRAVITY],
    )
    begin = joint_start(RunDown(line, shutdown), p)(p)[0]
    start = ca.Function("start", [p], [ca.vertcat(begin, ca.SX(len(EXTRAS), 1))])
    step = _step(line, case, case.shutdown.time_step / refinement, p, shutdown)
    return start, fastest_marcher(step, case.shutdown.n_steps * refinement)


def driveline(case: Case, parameters: ca.SX, tight: bool) -> Driveline:
    """Return the case's driveline with the lost inputs as symbols."""
    p = dict(zip((*NAMES, "gap"), ca.vertsplit(parameters), strict=True))
    now, joint = case.driveline, case.hub_seat
    law = ProportionalDamping(p["damping_factor"], _characteristic_frequency(case))
    keyed = KeyedConnection(
        radius=joint.radius,
        gap=p["gap"],
        contact_stiffness=p["contact_stiffness"],
        oil_damping=joint.oil_damping,
        smoothing=joint.smoothing,
    )
    four, eight = now.excitation
    return replace(
        now,
        coupling=Coupling(p["stiffness"], law),
        connection=TightFit(joint.radius) if tight else keyed,
        excitation=(
            replace(four, amplitude=p["order_4"]),
            replace(eight, amplitude=p["order_8"], phase=p["phase_8"]),
        ),
        engine_resistance=_resistance(
            now.engine_resistance, p["viscous"], p["friction"]
        ),
        generator_resistance=_resistance(
            now.generator_resistance, p["generator_viscous"], p["generator_friction"]
        ),
    )


def _resistance(now: Resistance, viscous: Scalar, friction: Scalar) -> Resistance:
    return replace(now, viscous=viscous, friction=friction)


def _step(
    line: Driveline, case: Case, time_step: float, p: ca.SX, shutdown: Shutdown
) -> ca.Function:
    """Return the joint step with EXTRAS carried along."""
    plain = joint_step(RunDown(line, shutdown), case, p, time_step)
    n, n_motion = plain.size1_in(0), len(state_names(line))
    state = ca.SX.sym("state", n + len(EXTRAS))
    now = motion(line, state[:n_motion])
    torque, speed = ca.fabs(now.coupling_torque), now.generator_speed
    peak, speed_at_peak, time = ca.vertsplit(state[n:])
    extras = ca.vertcat(
        ca.fmax(peak, torque),
        where(torque > peak, speed, speed_at_peak),
        time + time_step * (speed > _TURNING),
    )
    state_next = ca.cse(ca.vertcat(plain(state[:n], p), extras))
    return ca.Function("step", [state, p], [state_next])

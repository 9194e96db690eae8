"""An estimate of a crankshaft's first torsional mode, from bore, stroke and throws.

What a three-inertia model takes for one rigid mass swings in itself: this says from
which frequency on.

Sources
-------
[1] Ker Wilson, Practical Solution of Torsional Vibration Problems, vol. 1: a throw as a
    length of plain shaft of the journal's diameter.
[2] Mendes, Meirelles, Zampieri (2008), Proc. IMechE K J. Multi-body Dynamics, doi
    10.1243/14643193JMBD126, figure 4: six cylinders, bore 0.105 m, stroke 0.137 m,
    1.253e6 N m/rad and 0.0327 to 0.0487 kg m^2 a throw, first mode 216.58 Hz.
"""

from __future__ import annotations

import math

from coupling_design.engine.parameters import Engine

_SHEAR_MODULUS = 8.2e10  # of steel [Pa]
_DENSITY = 7850.0  # of steel [kg/m^3]
_JOURNAL = 0.70  # of the bore, usual
# Two constants fitted to [2]: the throw's length as plain shaft [1], over the bore, and
# its inertia with its share of piston and rod, over density x bore^3 x stroke^2.
_LENGTH, _INERTIA = 1.8, 0.235
# Of a throw with two rods side by side: longer, and with more to carry; our estimate.
_LONGER, _HEAVIER = 1.3, 1.6
# Engines' proportions spread: the truth lies within this factor either way.
UNCERTAINTY = 1.5


def first_crank_mode(engine: Engine, *, is_v: bool) -> float:
    """Return the estimated first mode of the crankshaft, its flywheel held [Hz].

    n equal throws on equal lengths from the flywheel on:
    omega = 2 sqrt(k / J) sin(pi / (2 (2 n + 1))). For [2]: 214 against 216.6 Hz.
    `is_v` has two cylinders on each throw. Good to a factor of `UNCERTAINTY`.
    """
    bore, stroke = engine.cylinder.bore, engine.cylinder.stroke
    n = len(engine.firing_angles) // (2 if is_v else 1)
    polar = math.pi / 32 * (_JOURNAL * bore) ** 4
    k = _SHEAR_MODULUS * polar / (_LENGTH * bore)
    J = _INERTIA * _DENSITY * bore**3 * stroke**2
    if is_v:
        k, J = k / _LONGER, J * _HEAVIER
    omega = 2 * math.sqrt(k / J) * math.sin(math.pi / (2 * (2 * n + 1)))
    return omega / (2 * math.pi)

"""Draw how a run-down starts: `python docs/tools/start_figure.py`.

The force at the key before and after t = 0, of the 16V280 with its stiff coupling in a
tight fit, as the program works it out. Needs the extra `studies`.
"""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

from coupling_design.arithmetic import FloatArray  # noqa: E402
from coupling_design.case import load_case  # noqa: E402
from coupling_design.events.recording import simulate  # noqa: E402
from coupling_design.events.settled_state import settled_state  # noqa: E402
from coupling_design.line.even_start import (  # noqa: E402
    all_resistances,
    quasi_steady_state,
)
from coupling_design.line.motion import motion  # noqa: E402
from coupling_design.line.parameters import (  # noqa: E402
    Driveline,
    FuelCutStart,
    QuasiSteadyStart,
    SettledStart,
    Shutdown,
    Start,
)
from studies.drawing import BLUE, GREY, canvas, save  # noqa: E402
from studies.machine import high_stiffness, required_stiffness  # noqa: E402

_BEFORE, _AFTER = 0.12, 0.36  # s
_SHOWN = (-36.0, 12.0)  # kN
# A four-stroke's working cycle, two turns.
_TURNS = 4 * np.pi


def main() -> None:
    """Write docs/figures/start.svg."""
    case = load_case(ROOT / "cases" / "16v280.yaml")
    line = high_stiffness(case).driveline(required_stiffness(case), 0.0)
    cycle = _TURNS / case.shutdown.initial_speed
    starts: dict[str, Start] = {
        "settled: turned without fuel for long": SettledStart(),
        "quasi_steady: even turning, no vibration": QuasiSteadyStart(),
        "fuel_cut: the mean torque goes over one cycle": FuelCutStart(cycle),
    }
    figure, axes = canvas(3, height=1.5)
    for each, (name, start) in zip(axes, starts.items(), strict=True):
        shutdown = replace(case.shutdown, start=start, duration=_AFTER)
        _draw(each, line, shutdown)
        each.set_title(name, loc="left", fontsize=9)
        each.set_ylabel("F_c [kN]")
        each.set_ylim(*_SHOWN)
    axes[-1].set_xlabel("time from the start of the run-down [s]")
    save(figure, ROOT / "docs" / "figures", "start")


def _draw(axes: Axes, line: Driveline, shutdown: Shutdown) -> None:
    found = simulate(line, shutdown)
    before = np.arange(-_BEFORE, 0.0, shutdown.time_step)
    axes.plot(before, _force_before(line, shutdown, before) / 1e3, color=GREY)
    axes.plot(found.time, found.transmission_force / 1e3, color=BLUE)
    axes.axvline(0.0, color=GREY, linestyle=":", linewidth=1)
    axes.set_xlim(-_BEFORE, _AFTER)


def _force_before(line: Driveline, shutdown: Shutdown, time: FloatArray) -> FloatArray:
    """Return F_c [N] at times before the start, (n,)."""
    omega = shutdown.initial_speed
    cuts = isinstance(shutdown.start, FuelCutStart)
    fuel = all_resistances(line, omega) if cuts else 0.0
    if isinstance(shutdown.start, QuasiSteadyStart):
        state = np.asarray(quasi_steady_state(line, omega, fuel)).ravel()
        silent = replace(line, excitation=())
        columns = np.repeat(state[:, np.newaxis], len(time), axis=1)
        return np.asarray(motion(silent, columns, fuel).transmission_force)
    columns = np.hstack(
        [np.asarray(settled_state(line, omega, omega * t, fuel)) for t in time]
    ).reshape(-1, len(time))
    mean = np.asarray(quasi_steady_state(line, omega, fuel)).ravel()
    crank = omega * time + mean[0]
    return np.asarray(motion(line, columns, fuel, crank).transmission_force)


if __name__ == "__main__":
    main()

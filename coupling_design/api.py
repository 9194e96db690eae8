"""The tool from Python: load a case, design its coupling, simulate, sweep.

>>> from coupling_design import api
>>> case = api.load("cases/small_genset.yaml", {"connection.gap": "0.15 mm"})
>>> case.driveline.connection.gap
0.00015
>>> case.overrides
('driveline.connection.gap=0.15 mm',)
"""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from pathlib import Path

    from coupling_design.explore.simulation import Simulation
    from coupling_design.flow.outcome import DesignOutcome
    from coupling_design.machine.machine import Case
    from coupling_design.search.workbench import Effort


def load(
    file: str | os.PathLike[str], overrides: Mapping[str, str] | None = None
) -> Case:
    """Return the case a file describes, with some of its values replaced.

    Parameters
    ----------
    file : the case file, YAML
    overrides : by path, or as much of its end as tells it from others, the value as
        one would write it in the file

    Raises
    ------
    CaseError
        With every problem of the file, each with its line.

    Examples
    --------
    >>> load("cases/small_genset.yaml").name
    'Small generator set'
    >>> load("cases/small_genset.yaml", {"gap": "3 kg"})
    Traceback (most recent call last):
        ...
    coupling_design.errors.CaseError: --set driveline.connection.gap=3 kg: found ...
    """
    from coupling_design.case import load_case

    return load_case(file, _assignments(overrides))


def design(
    case: Case,
    progress: Callable[[str], None] | None = None,
    effort: Effort | None = None,
) -> DesignOutcome:
    """Return the outcome of the five-step design of a case's coupling.

    Parameters
    ----------
    case : Case
    progress : takes a sentence whenever another piece of work begins
    effort : how closely to look; by default what the machine does in seconds

    Examples
    --------
    >>> outcome = design(load("tests/fixtures/quick.yaml"))
    >>> outcome.chosen.coupling_type
    'disc pack'
    """
    from coupling_design.flow.design import run_design, silent

    return run_design(case, progress or silent, effort)


def save_chosen(outcome: DesignOutcome, file: Path) -> None:
    """Write the chosen design as a case of its own, which runs to the same numbers."""
    from coupling_design.report.files.chosen_case import chosen_case_text
    from coupling_design.report.files.write import write_atomically

    write_atomically(file, chosen_case_text(outcome, file.parent))


def simulate(
    case: Case,
    stiffness: str | None = None,
    gap: str | None = None,
    coupling_type: str | None = None,
    connection: str | None = None,
    size: str | None = None,
) -> Simulation:
    """Return one coupling's run-down: totals in `performance`, signals over time.

    Totals are judged over all crank angles, signals are of the one with the largest
    peak.

    Parameters
    ----------
    case : Case
    stiffness, gap : with unit, `12 kN*m/rad`, or times the present one, `0.5x`
    coupling_type : one of the case's, by name
    connection : key, spline or tight_fit
    size : one of the case's catalogues, by name

    Examples
    --------
    >>> run = simulate(load("tests/fixtures/quick.yaml"), stiffness="0.5x")
    >>> run.performance.torsional_stiffness
    1000.0
    >>> run.signals.values("transmission_force").shape
    (2000,)
    >>> to_dataset(run.signals).coupling_torque.units
    'N*m'
    """
    from coupling_design.explore.points import find_point
    from coupling_design.explore.simulation import simulate_point

    point = find_point(case, stiffness, gap, coupling_type, connection, size)
    return simulate_point(case, point)


def sweep(
    file: str | os.PathLike[str],
    axes: Mapping[str, str],
    overrides: Mapping[str, str] | None = None,
    advance: Callable[[int], None] = lambda _: None,
) -> Any:
    """Return an xarray.Dataset with a run-down at every point of a grid.

    Parameters
    ----------
    file : the case file, YAML
    axes : what varies: `stiffness`, `gap` or a path of the case, and its values,
        `0.5..2x:31`, `0..0.3 mm:7`, `1..100 kN*m/rad:9log`, `high, normal`
    overrides : values that replace the file's, as in `load`
    advance : takes how many points are done since it was last called

    Examples
    --------
    >>> grid = sweep(
    ...     "tests/fixtures/quick.yaml", {"stiffness": "0.5..2x:3", "gap": "0..0.2mm:2"}
    ... )
    >>> dict(grid.sizes)
    {'stiffness': 3, 'gap': 2}
    >>> grid.stiffness.values.tolist(), grid.stiffness.units
    ([1000.0, 2500.0, 4000.0], 'N*m/rad')
    >>> bool((grid.damage.sel(gap=0) < grid.damage.sel(gap=0.2e-3)).all())
    True
    """
    from coupling_design.case.edit.overrides import override
    from coupling_design.case.load import case_of, read_document
    from coupling_design.explore.axes import parse_axes
    from coupling_design.explore.sweep import plan_sweep, run_sweep

    document = override(read_document(file), _assignments(overrides))
    case = case_of(document)
    plan = plan_sweep(document, case, parse_axes(document, case, _assignments(axes)))
    return to_dataset(run_sweep(plan, advance))


def to_dataset(grid: Any) -> Any:
    """Return the signals of a simulation as an xarray.Dataset with units."""
    from coupling_design.explore.files import to_dataset as convert

    return convert(grid)


def _assignments(values: Mapping[str, str] | None) -> tuple[str, ...]:
    return tuple(f"{path}={value}" for path, value in (values or {}).items())

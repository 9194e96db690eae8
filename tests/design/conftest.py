"""A small case whose rollouts take milliseconds, and damages made up by formula."""

import dataclasses
from pathlib import Path

import casadi as ca
import pytest

from coupling_design.case import load_case
from coupling_design.machine.candidate import Candidate
from coupling_design.machine.machine import ConnectionKind
from coupling_design.parts.criterion import Sense
from coupling_design.search.program import Constraint, DesignProblem, DesignSpace
from coupling_design.search.workbench import Effort, Workbench
from coupling_design.steps.flow import run_design, silent
from coupling_design.steps.present import evaluate_baseline
from coupling_design.steps.so_far import FlowState, connection_option
from coupling_design.wear.evaluator import Evaluator
from coupling_design.wear.performance import Performance

HERE = Path(__file__).parent
CASES = HERE.parents[1] / "cases"
INPUTS = HERE.parent / "inputs"
SMALL_EFFORT = Effort(
    stiffnesses=10, survey_gaps=2, stiffnesses_with_gap=4, gaps=2, starts=2
)
TINY_EFFORT = Effort(
    stiffnesses=3, survey_gaps=2, stiffnesses_with_gap=2, gaps=2, starts=1
)


@pytest.fixture(scope="session")
def quick():
    """The elastic type fails the load limit, the stiff one passes."""
    return load_case(HERE / "quick.yaml")


@pytest.fixture(scope="session")
def tiny():
    """Return a case of tests/inputs by its name, base having nothing to warn of."""
    return lambda name="base": load_case(INPUTS / f"{name}.yaml")


@pytest.fixture(scope="session")
def load_with():
    """Return a case of tests/inputs with values in place of its own."""
    return lambda name, *values: load_case(INPUTS / f"{name}.yaml", values)


@pytest.fixture(scope="session")
def calm(quick):
    """A third of the excitation: the elastic type passes."""
    excitation = tuple(
        dataclasses.replace(order, amplitude=order.amplitude / 3)
        for order in quick.driveline.excitation
    )
    driveline = dataclasses.replace(quick.driveline, excitation=excitation)
    return dataclasses.replace(quick, driveline=driveline)


@pytest.fixture(scope="session")
def hopeless(quick):
    """Bearings so sensitive that no coupling passes."""
    bearings = tuple(
        dataclasses.replace(bearing, minimum_stress=0.8 * bearing.minimum_stress)
        for bearing in quick.bearings
    )
    return dataclasses.replace(quick, bearings=bearings)


@pytest.fixture(scope="session")
def shipped():
    """Return a case that ships with the tool."""
    return lambda name: load_case(CASES / name)


@pytest.fixture(scope="session")
def paper(shipped):
    """The 16V280 set."""
    return shipped("16v280.yaml")


@pytest.fixture(scope="session")
def with_shutdown():
    """Return a case with another run-down."""

    def replaced(case, **changes):
        shutdown = dataclasses.replace(case.shutdown, **changes)
        return dataclasses.replace(case, shutdown=shutdown)

    return replaced


@pytest.fixture(scope="session")
def candidate():
    """Return a coupling type of a case, by its name, in a kind of connection."""

    def chosen(case, type_name, kind):
        coupling_type = next(t for t in case.coupling_types if t.name == type_name)
        return Candidate(coupling_type, connection_option(case, ConnectionKind(kind)))

    return chosen


@pytest.fixture(scope="session")
def evaluator(candidate):
    """Return a new evaluator of a case's candidate."""
    return lambda case, *names: Evaluator(case, candidate(case, *names))


@pytest.fixture(scope="session")
def tiny_effort():
    """As little as a search can do."""
    return TINY_EFFORT


@pytest.fixture(scope="session")
def bench():
    """Return a workbench that does not look too closely."""
    return lambda case: Workbench(case, silent, SMALL_EFFORT)


@pytest.fixture(scope="session")
def start_of(bench):
    """Return a case's flow before its first step."""

    def state(case):
        workbench = bench(case)
        return FlowState(case, workbench, evaluate_baseline(workbench))

    return state


@pytest.fixture(scope="session")
def outcomes(quick, calm, hopeless):
    """The whole flow on the small case and its variations."""
    return {
        "high_stiffness": run_design(quick, effort=SMALL_EFFORT),
        "elastic": run_design(calm, effort=SMALL_EFFORT),
        "none": run_design(hopeless, effort=SMALL_EFFORT),
    }


@pytest.fixture(scope="session")
def perform():
    """Return a performance of numbers."""

    def made(stiffness=1e3, gap=0.0, damage=1e-9, peak=1e3, frequency=5.0):
        return Performance(
            torsional_stiffness=stiffness,
            key_gap=gap,
            natural_frequency=frequency,
            damages=(damage, damage / 2),
            peak_transmission_force=peak,
            peak_combined_load=(peak, peak / 2),
        )

    return made


@pytest.fixture(scope="session")
def force_limit():
    """Return a limit on the peak transmission force."""

    def limit(newtons):
        return Constraint(
            name="peak",
            quantity=lambda performance: performance.peak_transmission_force,
            limit=newtons,
            sense=Sense.AT_MOST,
            unit="N",
            source="this test",
        )

    return limit


class Landscape(Evaluator):
    """Damage and peak by formula of (ln stiffness, gap in mm), without a rollout."""

    def __init__(self, case, candidate, log_damage, log_peak):
        super().__init__(case, candidate)
        point = ca.SX.sym("point", 2)
        place = ca.log(point[0]), 1e3 * point[1]
        damage, peak = ca.exp(log_damage(*place)), ca.exp(log_peak(*place))
        totals = ca.vertcat(damage, damage / 2, peak, peak, peak / 2)
        self._formula = ca.Function("formula", [point], [totals])
        self._slope = ca.Function("slope", [point], [ca.jacobian(totals, point)])

    @property
    def refined(self):
        return self

    @property
    def scan(self):
        return self

    @property
    def all_rollouts(self):
        return self.rollouts

    def performance(self, torsional_stiffness, key_gap, start_offset=0.0):
        return self.performances([(torsional_stiffness, key_gap)])[0]

    def performances(self, points, start_offset=0.0):
        self.rollouts += len(points)
        points = [tuple(map(float, point)) for point in points]
        totals = [self._formula(ca.DM(point)).full().ravel() for point in points]
        return tuple(
            self.read(*point, values.tolist())
            for point, values in zip(points, totals, strict=True)
        )

    def totals_and_jacobian(self, torsional_stiffness, key_gap):
        self.rollouts += 1
        point = [torsional_stiffness, key_gap]
        return self._formula(point).full().ravel(), self._slope(point).full()


@pytest.fixture
def landscape(quick, candidate):
    """Return a program over 1 to 100 N*m/rad (ln: 0 to 4.6) on formulas."""

    def program(log_damage, objective, constraints=(), log_peak=None, gap=(0.0, 0.0)):
        formulas = log_damage, log_peak or (lambda k, gap: 0.0 * k)
        made_up = Landscape(quick, candidate(quick, "rubber", "key"), *formulas)
        space = DesignSpace((1.0, 100.0), gap)
        return DesignProblem(made_up, space, objective, tuple(constraints))

    return program


@pytest.fixture(scope="session")
def with_sizes(tmp_path_factory):
    """Return the quick case with a catalogue, its text changed."""

    def load(*changes, sizes=()):
        folder = tmp_path_factory.mktemp("catalogue")
        text = (HERE / "quick.yaml").read_text(encoding="utf-8")
        text = "catalogue: [sizes.yaml]\n" + text
        for before, after in changes:
            text = text.replace(before, after, 1)
        (folder / "case.yaml").write_text(text, encoding="utf-8")
        catalogue = (HERE / "sizes.yaml").read_text(encoding="utf-8")
        for before, after in sizes:
            catalogue = catalogue.replace(before, after)
        (folder / "sizes.yaml").write_text(catalogue, encoding="utf-8")
        return load_case(folder / "case.yaml")

    return load


@pytest.fixture(scope="session")
def size_of():
    """Return a size of a case by its name, and its series."""

    def found(case, name):
        pairs = [
            (series, size) for series in case.coupling_types for size in series.sizes
        ]
        return next((series, size) for series, size in pairs if size.name == name)

    return found

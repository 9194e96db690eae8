import pytest

from coupling_design.line.parameters import LossFactorDamping
from coupling_design.machine.candidate import Candidate, candidate_driveline
from coupling_design.machine.words import ConnectionKind
from coupling_design.steps.so_far import connection_option

HALF = ("type: rubber\n", "type: rubber\n    driving_inertia: 0.15 kg*m^2\n")


@pytest.fixture
def driveline_of(size_of):
    def made(case, name):
        series, size = size_of(case, name)
        tight = connection_option(case, ConnectionKind.TIGHT_FIT)
        candidate = Candidate(series, tight, size)
        return candidate_driveline(case, candidate, 1e6, 0.0)

    return made


def test_a_size_brings_its_own_damping_and_driven_half(with_sizes, driveline_of):
    case = with_sizes()
    driveline = driveline_of(case, "D 4")
    assert driveline.coupling.torsional_stiffness == 1e6
    assert driveline.coupling.damping_law == LossFactorDamping(0.1)
    assert driveline.coupling_inertia == 0.6
    assert driveline.generator_inertia == case.driveline.generator_inertia


def test_its_driving_half_takes_the_present_ones_place(with_sizes, driveline_of):
    """2.5 - 0.15 + 0.2 = 2.55 kg m^2."""
    driveline = driveline_of(with_sizes(HALF), "D 3")
    assert driveline.engine_inertia == pytest.approx(2.55)
    assert driveline.coupling_inertia == 0.25


def test_the_engine_stays_where_the_present_half_is_not_stated(
    with_sizes, driveline_of
):
    assert driveline_of(with_sizes(), "D 3").engine_inertia == 2.5


def test_a_size_without_inertias_keeps_those_of_the_case(with_sizes, driveline_of):
    driveline = driveline_of(with_sizes(HALF), "D 2")
    assert (driveline.engine_inertia, driveline.coupling_inertia) == (2.5, 0.3)


def test_the_label_names_the_size(with_sizes, size_of):
    case = with_sizes()
    series, size = size_of(case, "D 4")
    key = connection_option(case, ConnectionKind.KEY)
    assert Candidate(series, key, size).label == "D 4, key"
    assert Candidate(series, key).label == "disc, key"

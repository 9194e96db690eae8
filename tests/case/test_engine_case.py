from pathlib import Path

import pytest

from coupling_design.case import load_case

CASE = Path(__file__).parents[2] / "cases" / "16v280_engine.yaml"


def test_the_16v280_from_its_engine_data():
    four, eight = load_case(CASE).driveline.excitation
    assert (four.order, eight.order) == (4.0, 8.0)
    # The project's reconstruction of the published machine: about 1.6 and 1.4 kN m.
    assert four.amplitude == pytest.approx(1.6e3, rel=0.03)
    assert eight.amplitude == pytest.approx(1.4e3, rel=0.03)


def test_all_but_the_excitation_is_as_in_the_shipped_case():
    case, shipped = load_case(CASE), load_case(CASE.with_name("16v280.yaml"))
    assert case.driveline.engine_resistance == shipped.driveline.engine_resistance
    assert case.driveline.coupling == shipped.driveline.coupling
    assert case.coupling_types == shipped.coupling_types
    assert case.bearings == shipped.bearings
    assert case.shutdown == shipped.shutdown

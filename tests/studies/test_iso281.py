import pytest

from studies import iso281, skf
from tests.verification.comparison import disagreements

pytestmark = pytest.mark.verification

GROUPS = (
    iso281.factors,
    iso281.continuity,
    iso281.reliabilities,
    iso281.dirt,
    iso281.viscosities,
    skf.comparisons,
)


@pytest.mark.parametrize("group", GROUPS)
def test_agrees_with_its_source(group):
    assert disagreements(group) == []


def test_no_one_factor_turns_skf_into_iso():
    ratios = [row.first / row.second for row in skf.contrasts() if row.unit == "-"]

    assert max(ratios) / min(ratios) > 1.3

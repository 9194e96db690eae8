import numpy as np
import pytest

from coupling_design.march.fastest import fastest_marcher
from coupling_design.wear.quantities import QUANTITIES, TOTALS, Gathering
from coupling_design.wear.run_downs import joint_states

SUMS = np.array([each.gathering is Gathering.ADDS_UP for each in QUANTITIES])


@pytest.mark.parametrize("share", [0.3, 0.8])
def test_an_event_cut_in_two_leaves_the_same(quick, evaluator, share):
    """The second part begins with nothing on record, where the first has stopped."""
    one = evaluator(quick, "rubber", "key")
    runs, n = one.run_downs, len(TOTALS)
    columns = runs.variables.columns([(2e3, 1e-4)], one.chances)
    states = joint_states(runs.starting()(columns, columns.shape[1]).states)
    whole = runs.march(states, columns)

    cut = int(share * runs.n_steps)
    first = fastest_marcher(runs.step, cut)(states, columns)
    again = first.copy()
    again[-n:] = 0.0
    second = fastest_marcher(runs.step, runs.n_steps - cut)(again, columns)

    assert np.array_equal(second[:-n], whole[:-n])
    together = np.where(
        SUMS[:, np.newaxis],
        first[-n:] + second[-n:],
        np.maximum(first[-n:], second[-n:]),
    )
    assert together == pytest.approx(whole[-n:], rel=1e-12)
    assert (first[-n:][SUMS] > 0).all()
    assert (second[-n:][SUMS] > 0).all()

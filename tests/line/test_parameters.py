import dataclasses

import pytest

from coupling_design.line.parameters import Shutdown


@pytest.mark.parametrize(
    ("duration", "time_step", "n_steps"),
    [(12.0, 1e-4, 120_000), (0.3, 1e-4, 3000), (1.0, 0.1, 10), (0.7, 0.1, 7)],
)
def test_number_of_steps(duration, time_step, n_steps):
    assert Shutdown(50.0, duration, time_step).n_steps == n_steps


def test_a_driveline_is_not_changed_in_place(keyed):
    with pytest.raises(dataclasses.FrozenInstanceError):
        keyed.engine_inertia = 1.0

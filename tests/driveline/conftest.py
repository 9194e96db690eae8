"""A driveline of round numbers that the tests of this folder work by hand."""

import dataclasses

import casadi as ca
import numpy as np
import pytest

from coupling_design.driveline.dynamics import motion, state_names
from coupling_design.driveline.parameters import (
    Coupling,
    Driveline,
    ExcitationOrder,
    KeyedConnection,
    ProportionalDamping,
    Resistance,
    TightFit,
)


@pytest.fixture(scope="session")
def key():
    """A key with b = 0.4 mm / (2 * 0.1 m) = 2 mrad and s b = 1e6 * 0.1 * 2e-3 = 200."""
    return KeyedConnection(
        radius=0.1,
        gap=0.4e-3,
        contact_stiffness=1e6,
        oil_damping=50.0,
        smoothing=1e6,
    )


@pytest.fixture(scope="session")
def keyed(key):
    return Driveline(
        engine_inertia=10.0,
        coupling_inertia=2.0,
        generator_inertia=20.0,
        coupling=Coupling(1e5, ProportionalDamping(0.5, 250.0)),  # c = 200 N m s/rad
        connection=key,
        excitation=(ExcitationOrder(2.0, 100.0, 0.0),),
        engine_resistance=Resistance(1.0, 30.0, 0.2),
        generator_resistance=Resistance(0.5, 10.0, 0.2),
    )


@pytest.fixture(scope="session")
def tight(keyed):
    return dataclasses.replace(keyed, connection=TightFit(radius=0.1))


@pytest.fixture(scope="session")
def closed(keyed, key):
    """The keyed driveline with its gap closed."""
    return dataclasses.replace(keyed, connection=dataclasses.replace(key, gap=0.0))


@pytest.fixture(scope="session")
def quiet():
    """Return a driveline that nothing drives or brakes."""

    def without_torques(driveline):
        none = Resistance(0.0, 0.0, 0.2)
        return dataclasses.replace(
            driveline, excitation=(), engine_resistance=none, generator_resistance=none
        )

    return without_torques


@pytest.fixture(scope="session")
def motion_at():
    """Return the motion of a driveline at a state, its values as floats or arrays."""

    def evaluate(driveline, state):
        symbol = ca.SX.sym("state", len(state_names(driveline)))
        now = motion(driveline, symbol)
        names = [field.name for field in dataclasses.fields(now)]
        compiled = ca.Function(
            "motion", [symbol], [ca.vertcat(getattr(now, name)) for name in names]
        )
        values = [np.asarray(value).ravel() for value in compiled(ca.DM(state))]
        numbers = {
            name: value if name == "state_rate" else float(value[0])
            for name, value in zip(names, values, strict=True)
        }
        return dataclasses.replace(now, **numbers)

    return evaluate

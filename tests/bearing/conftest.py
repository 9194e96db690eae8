"""The bearings, shaft and grease that the tests of this folder share."""

import dataclasses
import math

import casadi as ca
import numpy as np
import pytest

from coupling_design.bearing.parameters import (
    Bearing,
    BearingType,
    Cleanliness,
    Lubrication,
    ShaftGeometry,
)


@pytest.fixture(scope="session")
def nu2326():
    return Bearing(
        name="bearing 1",
        designation="NU2326",
        type=BearingType.RADIAL_ROLLER,
        dynamic_load_rating=920e3,
        static_load_rating=1230e3,
        pitch_diameter=0.205,
        stress_coefficient=3.62e6,
        minimum_stress=800e6,
    )


@pytest.fixture(scope="session")
def ball(nu2326):
    """A made-up ball bearing with round ratings and a pitch diameter of 144 mm."""
    return dataclasses.replace(
        nu2326,
        type=BearingType.RADIAL_BALL,
        dynamic_load_rating=100e3,
        static_load_rating=66e3,
        pitch_diameter=0.144,
    )


@pytest.fixture(scope="session", params=["nu2326", "ball"])
def bearing(request):
    return request.getfixturevalue(request.param)


@pytest.fixture(scope="session")
def shaft():
    return ShaftGeometry(
        hub_to_bearing_1=0.230,
        bearing_1_to_rotor=0.460,
        rotor_to_bearing_2=0.460,
        rotor_weight=25436.76,
    )


@pytest.fixture(scope="session")
def grease():
    return Lubrication(viscosity=39.6e-6, cleanliness=Cleanliness.SLIGHT_TYPICAL)


@pytest.fixture(scope="session")
def rpm():
    """Turn rpm into rad/s."""
    return lambda speed: speed * math.pi / 30


@pytest.fixture(scope="session")
def evaluations():
    """Evaluate a function of numbers as float, array, DM, SX and MX."""

    def evaluate(function, *arguments):
        yield float(function(*arguments))
        yield function(*(np.array([value, value]) for value in arguments))[1]
        yield float(function(*map(ca.DM, arguments)))
        for symbol in (ca.SX.sym, ca.MX.sym):
            symbols = [symbol(f"x{i}") for i in range(len(arguments))]
            compiled = ca.Function("f", symbols, [function(*symbols)])
            yield float(compiled(*arguments))

    return evaluate


@pytest.fixture(scope="session")
def derivatives():
    """Value, gradient and Hessian of a function at a point, from SX and from MX."""

    def evaluate(function, *arguments):
        for symbol in (ca.SX.sym, ca.MX.sym):
            x = symbol("x", len(arguments))
            value = function(*ca.vertsplit(x))
            hessian, gradient = ca.hessian(value, x)
            compiled = ca.Function("f", [x], [value, gradient, hessian])
            yield [np.array(part) for part in compiled(ca.DM(arguments))]

    return evaluate

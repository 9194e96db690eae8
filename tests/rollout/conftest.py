import casadi as ca
import pytest

from coupling_design.rollout.compiled.compiler import (
    VARIABLE,
    CompilerError,
    find_compiler,
)
from coupling_design.rollout.runge_kutta import rk4_step


def _use_cache(monkeypatch, directory):
    monkeypatch.delenv(VARIABLE, raising=False)
    monkeypatch.setenv("XDG_CACHE_HOME", str(directory))
    monkeypatch.setenv("HOME", str(directory))
    try:
        return find_compiler()
    except CompilerError as error:
        pytest.skip(f"machine code cannot be tested here: {error}")


@pytest.fixture(scope="session")
def _shared_cache(tmp_path_factory):
    return tmp_path_factory.mktemp("cache")


@pytest.fixture
def compiler(monkeypatch, _shared_cache):
    """A compiler, and a cache directory that is not the user's."""
    return _use_cache(monkeypatch, _shared_cache)


@pytest.fixture
def empty_cache(monkeypatch, tmp_path):
    """A compiler, and an empty cache directory."""
    return _use_cache(monkeypatch, tmp_path)


@pytest.fixture
def linear_step():
    """Return a function A, h -> step of x' = A x + B p."""

    def build(A, h, B=None):
        n = A.shape[0]
        m = 1 if B is None else B.shape[1]
        state, parameters = ca.SX.sym("state", n), ca.SX.sym("parameters", m)
        drive = 0 if B is None else ca.DM(B) @ parameters
        state_next = rk4_step(lambda y: ca.DM(A) @ y + drive, state, h)
        return ca.Function("step", [state, parameters], [ca.densify(state_next)])

    return build


@pytest.fixture
def pendulum_step():
    """A damped, driven pendulum with a soft stop: smooth, with most operations."""
    state, parameters = ca.SX.sym("state", 4), ca.SX.sym("parameters", 2)
    stiffness, stop = parameters[0], parameters[1]

    def rate(y):
        angle, speed, _, _ = ca.vertsplit(y)
        beyond = ca.fmax(ca.fabs(angle) - stop, 0) * ca.sign(angle)
        force = -stiffness * ca.sin(angle) - 50 * beyond - 0.1 * ca.tanh(speed / 0.2)
        wear = (ca.fabs(speed) + 0.5) ** 3.3 / (1 + ca.cos(angle) ** 2) ** 1.7
        heat = ca.if_else(speed > 0, ca.exp(-(speed**2)), ca.sqrt(1 + speed**2))
        return ca.vertcat(speed, force, wear, heat)

    return ca.Function("step", [state, parameters], [rk4_step(rate, state, 1e-3)])

from pathlib import Path

import pytest
from hypothesis import settings

# The same examples on every machine, and no deadline: the first call builds graphs.
settings.register_profile("repeatable", derandomize=True, deadline=None)
settings.load_profile("repeatable")

pytest_plugins = (
    "tests.fixtures.bearings",
    "tests.fixtures.designs",
    "tests.fixtures.drivelines",
    "tests.fixtures.steps",
)
VERIFICATION = Path(__file__).parent / "verification"
TERMINAL_VARIABLES = ("COLUMNS", "LINES", "FORCE_COLOR", "NO_COLOR", "TTY_COMPATIBLE")


def pytest_collection_modifyitems(items):
    for item in items:
        if VERIFICATION in item.path.parents:
            item.add_marker("verification")


@pytest.fixture(autouse=True, scope="session")
def _plain_terminal():
    """Keep the terminal of whoever runs the tests out of them."""
    with pytest.MonkeyPatch.context() as patch:
        for variable in TERMINAL_VARIABLES:
            patch.delenv(variable, raising=False)
        yield

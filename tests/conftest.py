"""What all tests share."""

from __future__ import annotations

from collections.abc import Iterator

import pytest


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--accept", action="store_true", help="rewrite what the tests expect")


@pytest.fixture(scope="session")
def accept(pytestconfig: pytest.Config) -> bool:
    """Whether a test writes its expectation instead of comparing with it."""
    return bool(pytestconfig.getoption("--accept"))


@pytest.fixture(scope="session", autouse=True)
def _cache_of_its_own(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """A folder for what verbs keep, so that no test sees what another run has left."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("FIELDSPEC_CACHE", str(tmp_path_factory.mktemp("cache")))
        yield

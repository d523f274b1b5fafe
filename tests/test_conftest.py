"""The list of slow tests names files that are there."""

from __future__ import annotations

import importlib.util
from pathlib import Path

TESTS = Path(__file__).parent


def slow() -> tuple[str, ...]:
    spec = importlib.util.spec_from_file_location("tests_conftest", TESTS / "conftest.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    names: tuple[str, ...] = module.SLOW
    return names


def test_every_slow_test_is_there() -> None:
    assert [name for name in slow() if not (TESTS / name).exists()] == []


def test_slow_tests_are_listed_in_order() -> None:
    assert list(slow()) == sorted(slow())

"""The list of slow tests names files that are there, and of a long proof an even share is run."""

from __future__ import annotations

import importlib.util
from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path
from types import ModuleType, SimpleNamespace

import pytest

import proofs

TESTS = Path(__file__).parent


def conftest() -> ModuleType:
    spec = importlib.util.spec_from_file_location("tests_conftest", TESTS / "conftest.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_every_slow_test_is_there() -> None:
    assert [name for name in conftest().SLOW if not (TESTS / name).exists()] == []


def test_slow_tests_are_listed_in_order() -> None:
    assert list(conftest().SLOW) == sorted(conftest().SLOW)


@dataclass(frozen=True, eq=False)
class Case:
    """A test that is collected."""

    nodeid: str
    marker: pytest.Mark | None = None

    def get_closest_marker(self, name: str) -> pytest.Mark | None:
        return self.marker


@dataclass
class Deselected:
    items: list[Case] = field(default_factory=list)

    def pytest_deselected(self, items: list[Case]) -> None:
        self.items += items


@pytest.mark.parametrize(
    ("is_whole", "numbers"), [(False, [0, 2, 5, 7]), (True, range(10))], ids=["a share", "the whole"]
)
def test_a_run_has_an_even_share_of_a_proof_and_every_other_test(
    is_whole: bool, numbers: Iterable[int], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(proofs, "IS_WHOLE", is_whole)
    proof = pytest.mark.proof(4).mark
    every = [Case("a"), *(Case(f"p[{number}]", proof) for number in range(10)), Case("z")]
    deselected = Deselected()
    module = conftest()
    items = [*every]
    module.pytest_collection_modifyitems(SimpleNamespace(hook=deselected), items)
    assert [item.nodeid for item in items] == ["a", *(f"p[{number}]" for number in numbers), "z"]
    assert [item for item in every if item not in items] == deselected.items


def test_a_case_that_is_named_is_run(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(proofs, "IS_WHOLE", False)
    items = [Case("p[7]", pytest.mark.proof(4).mark)]
    conftest().pytest_collection_modifyitems(SimpleNamespace(hook=Deselected()), items)
    assert [item.nodeid for item in items] == ["p[7]"]

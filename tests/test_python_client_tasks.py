"""What tasks of generated clients read, by the runtime of the compiler under test."""

from __future__ import annotations

from collections.abc import Generator
from typing import Any

import pytest

from python_package import runtime


class Tenths:
    """A place whose unit is ten counts."""

    def in_unit(self, value: int) -> float:
        return value / 10


def returned(work: Generator[Any, Any, Any]) -> Any:
    """What a generator returns that asks for nothing."""
    with pytest.raises(StopIteration) as end:
        next(work)
    return end.value.value


@pytest.mark.parametrize(("in_unit", "expected"), [(False, 125), (True, 12.5)])
def test_a_task_returns_the_value_that_it_reads(in_unit: bool, expected: float) -> None:
    class Task(runtime("_client_tasks").RegisterTask):  # type: ignore[misc]
        def __init__(self) -> None:
            """Needs no device."""

        def _read(self, place: Tenths) -> Generator[Any, Any, int]:
            yield from ()
            return 125

    assert returned(Task().read(Tenths(), in_unit)) == expected

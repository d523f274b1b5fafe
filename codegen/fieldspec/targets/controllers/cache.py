"""The result of the last layout, for outputs that ask for the same."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import TypeVar

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.caches import ByIdentity

Result = TypeVar("Result")


def cached(make: Callable[[DeviceLayout], Result]) -> Callable[[DeviceLayout], Result]:
    """A function of a layout that returns the result of its last call again, if it is called with the same layout.

    Layouts never change, and the outputs of one device are built one after the other.
    """
    results: ByIdentity[DeviceLayout, Result] = ByIdentity(limit=1)

    @wraps(make)
    def cached_result(layout: DeviceLayout) -> Result:
        return results.get_or_compute(layout, make)

    return cached_result

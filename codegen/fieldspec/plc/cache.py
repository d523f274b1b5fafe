"""The result of the last layout, for outputs that ask for the same."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

from fieldspec.layout.device import DeviceLayout

Result = TypeVar("Result")


def cached(make: Callable[[DeviceLayout], Result]) -> Callable[[DeviceLayout], Result]:
    """A function of a layout that gives again what it gave before, where it is asked for the same layout again.

    Layouts never change. The last one alone is kept, with what was made of it, since the outputs of one device are made
    behind each other; as it is held, no other layout can be taken for it.
    """
    last: tuple[DeviceLayout, Result] | None = None

    def asked(layout: DeviceLayout) -> Result:
        nonlocal last
        if last is None or last[0] is not layout:
            last = layout, make(layout)
        return last[1]

    asked.__doc__ = make.__doc__
    return asked

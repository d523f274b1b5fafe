"""What several outputs ask of one layout, worked out once."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

from fieldspec.layout.device import DeviceLayout

Made = TypeVar("Made")


def kept(make: Callable[[DeviceLayout], Made]) -> Callable[[DeviceLayout], Made]:
    """A function of a layout that gives again what it gave before, where it is asked for the same layout again.

    Layouts never change. The last one alone is kept, with what was made of it, since the outputs of one device are made
    behind each other; as it is held, no other layout can be taken for it.
    """
    last: tuple[DeviceLayout, Made] | None = None

    def asked(layout: DeviceLayout) -> Made:
        nonlocal last
        if last is None or last[0] is not layout:
            last = layout, make(layout)
        return last[1]

    asked.__doc__ = make.__doc__
    return asked

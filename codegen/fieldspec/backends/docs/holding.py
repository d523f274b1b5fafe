"""For which versions examples, notes and errata hold."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.backends.docs.document import Line, plain, styled
from fieldspec.layout.device import DeviceLayout


class Holding:
    """The versions of a device that have each of its examples, notes and errata."""

    def __init__(self, layouts: Sequence[DeviceLayout]) -> None:
        self.all = tuple(layout.device.version for layout in layouts)
        self._by_path: dict[str, list[str]] = {}
        for layout in layouts:
            device = layout.device
            for held in (device.examples.values(), device.notes, device.errata):
                for fact in held:
                    self._by_path.setdefault(fact.place.path, []).append(device.version)

    def of(self, path: str) -> tuple[str, ...]:
        """The versions that have a fact, the oldest first."""
        return tuple(self._by_path.get(path, ()))

    def badges(self, path: str) -> tuple[Line, ...]:
        """What is said of a fact that not all versions have; nothing of the others."""
        held = self.of(path)
        return () if held == self.all else ((styled(f"only {', '.join(held)}", "badge"),),)

    def lines(self, path: str) -> tuple[Line, ...]:
        """For which versions a fact holds; nothing where there is but one."""
        held = self.of(path)
        if len(self.all) < 2:
            return ()
        return ((plain("all"),),) if held == self.all else ((plain(", ".join(held)),),)

"""What versions have in common: for which of them examples, notes and errata hold, and sections that they share."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from fieldspec.backends.docs.document import Line, Section, plain, styled
from fieldspec.classes import replace
from fieldspec.layout.device import DeviceLayout


class Holding:
    """The versions of a device that have each of its examples, notes and errata, and the sections of their pages."""

    def __init__(self, layouts: Sequence[DeviceLayout]) -> None:
        self.all = tuple(layout.device.version for layout in layouts)
        self._by_path: dict[str, list[str]] = {}
        self._sections: dict[str, Section] = {}
        self._made: dict[str, tuple[object, Section]] = {}
        for layout in layouts:
            device = layout.device
            for held in (device.examples.values(), device.notes, device.errata):
                for fact in held:
                    self._by_path.setdefault(fact.place.path, []).append(device.version)

    def made(self, anchor: str, of: object, make: Callable[[], Section]) -> Section:
        """A section that is made of something; the one of the version before, where it was made of the same."""
        before = self._made.get(anchor)
        if before is None or before[0] != of:
            before = self._made[anchor] = of, make()
        return before[1]

    def same(self, section: Section) -> Section:
        """A section, or the same one of the version before it, where that has it too."""
        if len(self.all) < 2:
            return section
        before = self._sections.get(section.anchor)
        if before != section:
            before = self._sections[section.anchor] = replace(section, written={})
        return before

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

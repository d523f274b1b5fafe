"""Records at equal distances in the register space."""

from __future__ import annotations

from fieldspec.classes import dataclass
from fieldspec.model.fact import Citation, Fact
from fieldspec.model.handling import Handling
from fieldspec.model.place import Place


@dataclass(frozen=True, slots=True)
class PrintedElement:
    """What the manual prints of one element: its addresses and its words."""

    place: Place
    index: int
    first: int | None
    last: int | None
    words: int | None
    sources: tuple[Citation, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Table(Fact):
    """`count` records, the first at `base`, `stride` words apart, numbered from `index_from`.

    `space` is empty where the spec names none, which means the first one of the device.
    """

    title: str
    space: str
    base: int
    decimal: int | None
    stride: int
    count: int
    index_from: int
    record: str
    words: int | None
    access: str
    handling: Handling
    elements: tuple[PrintedElement, ...]

    def address(self, index: int) -> int:
        """The address of an element by its number."""
        return self.base + (index - self.index_from) * self.stride

    @property
    def indexes(self) -> range:
        """The numbers of the elements."""
        return range(self.index_from, self.index_from + self.count)

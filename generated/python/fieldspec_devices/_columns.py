"""The columns of many records: the place of each, and its numbers where NumPy has no type for them on the wire."""

from __future__ import annotations

from ._typing import TYPE_CHECKING

if TYPE_CHECKING:
    from typing import Any

    import numpy as np

_WIDTHS = {"b": 1, "B": 1, "h": 2, "H": 2, "i": 4, "I": 4, "q": 8, "Q": 8, "e": 2, "f": 4, "d": 8}
NUMPY_TYPES = {"b": "i1", "B": "u1", "h": "i2", "H": "u2", "i": "i4", "I": "u4", "q": "i8", "Q": "u8"}
NUMPY_TYPES |= {"e": "f2", "f": "f4", "d": "f8"}
"""The types of NumPy for the letters of `struct`."""


class Column:
    """The place of a field: the letter of `struct` for one element, and its offset in bytes.

    `size` is the bytes of a text, and of a number that has fewer bytes than its letter. `count` is the number of
    elements of a list, 0 for a single one. `swapped`: the 16-bit words are in the other order than the bytes in them.
    `tests` are the intervals outside of which a number is refused. `ratio` is (a, b, c) of value = (count * a + b) / c
    in the unit; `absent` are the counts that are not a quantity. A field without a name is only tested. `magnitude`:
    only the highest bit is the sign.
    """

    __slots__ = (
        "absent",
        "count",
        "letter",
        "magnitude",
        "name",
        "offset",
        "order",
        "ratio",
        "record",
        "size",
        "swapped",
        "tests",
        "text",
    )

    def __init__(
        self,
        name: str,
        letter: str,
        offset: int,
        *,
        size: int = 0,
        count: int = 0,
        order: str = "big",
        swapped: bool = False,
        record: type[Any] | None = None,
        tests: tuple[tuple[int, int], ...] = (),
        text: bool = False,
        magnitude: bool = False,
        ratio: tuple[int, int, int] | None = None,
        absent: tuple[int | range, ...] = (),
    ) -> None:
        self.name, self.letter, self.offset, self.count = name, letter, offset, count
        self.size = size or _WIDTHS[letter]
        self.order, self.swapped, self.record = order, swapped, record
        self.tests, self.text, self.ratio, self.absent = tests, text, ratio, absent
        self.magnitude = magnitude

    @property
    def half(self) -> int:
        """The bit that says that a number is below zero, as a number."""
        return 1 << (8 * self.size - 1)

    @property
    def padding(self) -> int:
        """The bytes that a number has fewer than its letter."""
        return 0 if self.letter in "s" else _WIDTHS[self.letter] - self.size

    def places(self, element: int = 0) -> list[int]:
        """The offsets of the bytes of an element, the least significant first."""
        width = self.size
        places = list(range(width))
        if self.order == "big":
            places.reverse()
        if self.swapped:
            places = [place for offset in range(0, width, 2) for place in places[width - 2 - offset : width - offset]]
        return [self.offset + element * width + place for place in places]


def straight(column: Column, values: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
    """A column with its numbers assembled where NumPy has no type for them: of words in the other order than their
    bytes, or of another number of bytes.
    """
    import numpy

    if column.padding:
        joined = _joined_bytes(column, values)
    elif column.swapped:
        words = values.astype(f"u{column.size}")
        shifts = numpy.arange(0, 8 * column.size, 16, dtype=words.dtype)
        if column.order == "little":
            shifts = shifts[::-1]
        joined = numpy.bitwise_or.reduce(words << shifts, axis=-1).astype(f"u{column.size}")
    elif column.magnitude:
        joined = values.astype(f"u{column.size}")
    else:
        return values
    numbers: np.ndarray[Any, Any]
    if column.magnitude:
        numbers = (joined & (column.half - 1)).astype(NUMPY_TYPES[column.letter])
        return numpy.where(joined >= column.half, -numbers, numbers)
    # A signed number repeats its sign in the bytes that it does not have.
    padding = 8 * column.padding
    numbers = (joined << numpy.array(padding, joined.dtype)).view(NUMPY_TYPES[column.letter])
    return numbers >> padding if padding else numbers


def _joined_bytes(column: Column, values: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
    """The bits of lists of bytes as numbers."""
    import numpy

    kind = f"u{column.size + column.padding}"
    places = [place - column.offset for place in column.places()]
    shifts = numpy.array([8 * places.index(offset) for offset in range(column.size)], dtype=kind)
    joined: np.ndarray[Any, Any] = numpy.bitwise_or.reduce(values.astype(kind) << shifts, axis=-1).astype(kind)
    return joined

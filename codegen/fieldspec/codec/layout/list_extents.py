"""The bytes of lists in some data, or why they are not known."""

from __future__ import annotations

from fieldspec.foundation.classes import dataclass


@dataclass(frozen=True, slots=True)
class ListExtent:
    """The bytes of a list in some data, and of each of its elements; `elements` is empty where all have the same.

    `numbers` is how many numbers are packed into the bytes.
    """

    size: int
    elements: tuple[int, ...] = ()
    numbers: int = 0


@dataclass(frozen=True, slots=True)
class ListFault:
    """Why some data have no image: the reason, and the byte at which it shows."""

    reason: str
    at: int

"""The codecs of packages: what reads and writes numbers, and computes checksums, that no other module can."""

from __future__ import annotations

from ._typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable

    from ._typing import Data

    Number = tuple[int, int, Callable[[bytes], "int | None"], Callable[[int], bytes]]

NUMBERS: dict[str, Number] = {}
"""The least and the greatest number, and the functions from bytes and to bytes, by the name of the form."""
CHECKSUMS: dict[str, Callable[[Data], int]] = {}


def add_number(
    name: str, low: int, high: int, decode: Callable[[bytes], int | None], encode: Callable[[int], bytes]
) -> None:
    """Adds the codec of a number."""
    NUMBERS[name] = low, high, decode, encode


def add_checksum(name: str, checksum: Callable[[bytes], int]) -> None:
    """Adds the codec of a checksum."""
    CHECKSUMS[name] = lambda data: checksum(bytes(data))

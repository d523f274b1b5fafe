"""The checksums of bytes, and their bytes in a frame."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

from fieldspec.language.model.checksums import checksum_named


@cache
def _function(algorithm: str, order: str) -> Callable[[bytes], int]:
    return checksum_named(algorithm).function(order)


def checksum(algorithm: str, data: bytes, order: str = "big") -> int:
    """The checksum of some bytes. `order` is that of the bytes which a sum or an xor takes as one number."""
    return _function(algorithm, order)(data)


def checksum_bytes(algorithm: str, digits: str, order: str, size: int, data: bytes) -> bytes:
    """The checksum of some bytes as it is sent: `size` bytes of its number, or as many `digits`."""
    number = checksum(algorithm, data, order)
    if not digits:
        return number.to_bytes(size, "little" if order == "little" else "big")
    text = f"{number:0{size}d}" if digits == "decimal" else f"{number:0{size}x}"
    return (text.upper() if digits == "upper_hex" else text).encode("ascii")

"""The checksums of bytes, and their bytes in a frame."""

from __future__ import annotations

from functools import cache

from fieldspec.language.model import codecs
from fieldspec.language.model.checksums import Checksum, checksum_named, combined


def checksum(algorithm: str, data: bytes, order: str = "big") -> int:
    """The checksum of some bytes. `order` is that of the bytes which a sum or an xor takes as one number."""
    kind = checksum_named(algorithm)
    if kind.codec:
        return codecs.computed(kind.codec, data)
    data += kind.suffix
    if kind.method == "crc":
        return kind.as_sent(_crc(kind, kind.arranged(data)))
    number = combined(kind, data, order)
    if kind.complement:
        number = -number if kind.complement == "twos" else ~number
    return kind.as_sent(number & kind.mask)


def checksum_bytes(algorithm: str, digits: str, order: str, size: int, data: bytes) -> bytes:
    """The checksum of some bytes as it is sent: `size` bytes of its number, or as many `digits`."""
    number = checksum(algorithm, data, order)
    if not digits:
        return number.to_bytes(size, "little" if order == "little" else "big")
    text = f"{number:0{size}d}" if digits == "decimal" else f"{number:0{size}x}"
    return (text.upper() if digits == "upper_hex" else text).encode("ascii")


def _crc(kind: Checksum, data: bytes) -> int:
    """A CRC by a table for each byte; the register of one that is not reflected begins at its highest bit."""
    table = crc_table(kind.width, kind.polynomial, kind.reflect_in)
    register = reflected(kind.initial, kind.width) if kind.reflect_in else kind.initial << 64 - kind.width
    for byte in data:
        if kind.reflect_in:
            register = register >> 8 ^ table[(register ^ byte) & 0xFF]
        else:
            register = (register << 8 & 0xFFFFFFFFFFFFFFFF) ^ table[register >> 56 ^ byte]
    number = register if kind.reflect_in else register >> 64 - kind.width
    return (number if kind.reflect_in == kind.reflect_out else reflected(number, kind.width)) ^ kind.final_xor


def reflected(number: int, width: int) -> int:
    """A number of `width` bits with its bits in the opposite order."""
    return int(f"{number:0{width}b}"[::-1], 2)


@cache
def crc_table(width: int, polynomial: int, is_reflected: bool) -> tuple[int, ...]:
    """The table of a CRC, with the term of each byte.

    The register of a reflected CRC has the lowest bit first; any other one has 64 bits, the highest first.
    """
    if is_reflected:
        term = reflected(polynomial, width)
        table = []
        for byte in range(256):
            for _ in range(8):
                byte = byte >> 1 ^ (term if byte & 1 else 0)
            table.append(byte)
        return tuple(table)
    term = polynomial << 64 - width
    table = []
    for byte in range(256):
        register = byte << 56
        for _ in range(8):
            register = (register << 1 & 0xFFFFFFFFFFFFFFFF) ^ (term if register >> 63 else 0)
        table.append(register)
    return tuple(table)

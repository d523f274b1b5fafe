"""The checksums of the reference codec, as the definitions have them; a CRC takes a byte at a time."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

from fieldspec.language.model import codecs
from fieldspec.language.model.checksums import DIGITS, Checksum, checksum_named


def checksum(algorithm: str, data: bytes, order: str = "big") -> int:
    """The checksum of some bytes; `order` is that of the bytes of the numbers that are added."""
    kind = checksum_named(algorithm)
    if kind.codec:
        return codecs.computed(kind.codec, data)
    methods = {"crc": _remainder, "fletcher": _two_sums}
    number = methods.get(kind.method, _total)(kind, data + kind.suffix, kind.unit_order or order)
    if not kind.avoided:
        return number
    substitutes = dict(zip(kind.avoided, kind.replacements, strict=True))
    shifts = [8 * place for place in range(kind.size)]
    return sum(substitutes.get(number >> shift & 0xFF, number >> shift & 0xFF) << shift for shift in shifts)


_MIRRORED = bytes(int(f"{byte:08b}"[::-1], 2) for byte in range(256))
"""Each byte with its bits in the opposite order."""


def _remainder(kind: Checksum, data: bytes, _order: str) -> int:
    """The remainder of the division of the data by the polynomial; numbers begin with the last of their bytes."""
    width = max(kind.width, 8)
    spare, mask = width - kind.width, (1 << width) - 1
    remainders = _remainders(width, kind.polynomial << spare)
    units = (data[place : place + kind.unit_size] for place in range(0, len(data), kind.unit_size))
    content = data if kind.unit_size == 1 else b"".join(unit.ljust(kind.unit_size, b"\0")[::-1] for unit in units)
    register = kind.initial << spare  # at least eight bits, so that a whole byte is divided at once
    for byte in content.translate(_MIRRORED) if kind.reflect_in else content:
        register = (register << 8 & mask) ^ remainders[register >> width - 8 ^ byte]
    register >>= spare
    if kind.reflect_out:
        register = int(f"{register:0{kind.width}b}"[::-1], 2)
    return register ^ kind.final_xor


@cache
def _remainders(width: int, polynomial: int) -> list[int]:
    """The remainders of all bytes with zeros after them, bit by bit as the definition has it."""
    remainders = []
    for byte in range(256):
        register = byte << width - 8
        for _ in range(8):
            is_divided = bool(register >> width - 1)
            register = (register << 1 & (1 << width) - 1) ^ (polynomial if is_divided else 0)
        remainders.append(register)
    return remainders


def _terms(kind: Checksum, data: bytes, order: str) -> Iterator[int]:
    for offset in range(0, len(data), kind.unit_size):
        unit = data[offset : offset + kind.unit_size].ljust(kind.unit_size, b"\0")
        yield int.from_bytes(unit if order == "big" else unit[::-1], "big")


def _two_sums(kind: Checksum, data: bytes, order: str) -> int:
    """The sum of the terms, and in the upper half the sum of each term times its distance from the end."""
    half = kind.width // 2
    terms = list(_terms(kind, data, order))
    upper, lower = kind.initial >> half, kind.initial & (1 << half) - 1
    if terms:
        upper += len(terms) * lower + sum(distance * term for distance, term in enumerate(reversed(terms), 1))
        lower += sum(terms)
        upper, lower = upper % kind.modulus, lower % kind.modulus
    return upper << half | lower


def _total(kind: Checksum, data: bytes, order: str) -> int:
    number = kind.initial
    for term in _terms(kind, data, order):
        number = (number + term if kind.method == "sum" else number ^ term) & kind.mask
    if kind.complement == "ones":
        return number ^ kind.mask
    return kind.mask + 1 - number & kind.mask if kind.complement == "twos" else number


def checksum_digits(number: int, digits: str, size: int) -> bytes:
    """A number as that number of digits, the most significant first."""
    characters = b"0123456789abcdef" if digits == "lower_hex" else b"0123456789ABCDEF"
    places = []
    for _ in range(size):
        number, digit = divmod(number, DIGITS[digits])
        places.append(characters[digit])
    return bytes(reversed(places))

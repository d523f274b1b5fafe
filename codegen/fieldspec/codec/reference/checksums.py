"""The checksums of the reference codec, bit by bit as the definitions have them."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.language.model import codecs
from fieldspec.language.model.checksums import DIGITS, Checksum, checksum_named


def checksum(algorithm: str, data: bytes, order: str = "big") -> int:
    """The checksum of some bytes; `order` is that of the bytes of the numbers that are added."""
    kind = checksum_named(algorithm)
    if kind.codec:
        return codecs.computed(kind.codec, data)
    methods = {"crc": _remainder, "fletcher": _two_sums}
    number = methods.get(kind.method, _total)(kind, data + kind.suffix, kind.unit_order or order)
    substitutes = dict(zip(kind.avoided, kind.replacements, strict=True))
    shifts = [8 * place for place in range(kind.size)]
    return sum(substitutes.get(number >> shift & 0xFF, number >> shift & 0xFF) << shift for shift in shifts)


def _remainder(kind: Checksum, data: bytes, _order: str) -> int:
    """The remainder of the division of the data by the polynomial; numbers begin with the last of their bytes."""
    top, register, mask = 1 << kind.width - 1, kind.initial, kind.mask
    for step in range(-(-len(data) // kind.unit_size) * kind.unit_size):
        place = step + kind.unit_size - 1 - 2 * (step % kind.unit_size)
        byte = data[place] if place < len(data) else 0
        for bit in range(8) if kind.reflect_in else reversed(range(8)):
            is_divided = bool(register & top) != bool(byte >> bit & 1)
            register = (register << 1 & mask) ^ (kind.polynomial if is_divided else 0)
    if kind.reflect_out:
        register = sum((register >> place & 1) << kind.width - 1 - place for place in range(kind.width))
    return register ^ kind.final_xor


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

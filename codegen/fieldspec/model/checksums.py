"""Checksum algorithms as data. A name says everything about an algorithm, so it is enough to compare names."""

from __future__ import annotations

import re
from functools import cache

from fieldspec.classes import dataclass, replace

MOST_BITS = 64


@dataclass(frozen=True, slots=True)
class Checksum:
    """An algorithm. Its `method` is `crc`, `sum` or `xor`; `width` is the number of bits of its result.

    The polynomial of a CRC is without its highest bit. `reflect_in` takes the lowest bit of each byte first, and
    `reflect_out` reverses the bits of the result. A sum or an xor takes `unit_size` bytes at a time as one number; a
    last number that is not complete is filled up with zeros behind its bytes. `complement` is `ones`, `twos` or empty.
    """

    method: str
    width: int
    polynomial: int = 0
    initial: int = 0
    reflect_in: bool = False
    reflect_out: bool = False
    final_xor: int = 0
    complement: str = ""
    unit_size: int = 1

    @property
    def size(self) -> int:
        """The bytes of the result."""
        return (self.width + 7) // 8

    @property
    def mask(self) -> int:
        """The greatest result."""
        return (1 << self.width) - 1


SIMPLE = {
    "crc16_modbus": Checksum("crc", 16, 0x8005, 0xFFFF, True, True),
    "lrc": Checksum("sum", 8, complement="twos"),
    "sum8": Checksum("sum", 8),
}
"""The algorithms that every output computes, and for which the codecs have shorter code."""

_DERIVED_CRC = re.compile(r"crc(\d+)_([0-9a-f]+)_([0-9a-f]+)_([fr])([fr])_([0-9a-f]+)")
_DERIVED_SUM = re.compile(r"(sum|xor)(\d+)(?:_of(\d))?(?:_from_([0-9a-f]+))?(?:_(ones|twos))?")


@cache
def _catalogue() -> dict[str, Checksum]:
    from fieldspec.model.crc_catalogue import CRC_CATALOGUE

    algorithms = {}
    for line in CRC_CATALOGUE.splitlines():
        name, width, polynomial, initial, reflect_in, reflect_out, final_xor, _ = line.split()
        algorithms[name] = Checksum(
            "crc",
            int(width),
            int(polynomial, 16),
            int(initial, 16),
            reflect_in == "reflected",
            reflect_out == "reflected",
            int(final_xor, 16),
        )
    return algorithms


@cache
def checksum_named(name: str) -> Checksum:
    """The algorithm with a name: a word of the schema, or what `algorithm_name` returns. Raises KeyError."""
    if name in SIMPLE:
        return SIMPLE[name]
    derived = _DERIVED_CRC.fullmatch(name)
    if derived is not None:
        width, polynomial, initial, reflect_in, reflect_out, final_xor = derived.groups()
        numbers = int(width), int(polynomial, 16), int(initial, 16)
        return Checksum("crc", *numbers, reflect_in == "r", reflect_out == "r", int(final_xor, 16))
    derived = _DERIVED_SUM.fullmatch(name)
    if derived is not None:
        method, width, unit_size, initial, complement = derived.groups()
        unit = int(unit_size) if unit_size else 1 if method == "sum" else int(width) // 8
        start = int(initial, 16) if initial else 0
        return Checksum(method, int(width), initial=start, complement=complement or "", unit_size=unit)
    return _catalogue()[name]


@cache
def catalogue_name(name: str) -> str:
    """The first name of an algorithm that has several."""
    if name in SIMPLE:
        return name
    from fieldspec.model.crc_catalogue import OTHER_NAMES

    return dict(line.split() for line in OTHER_NAMES.splitlines()).get(name, name)


def algorithm_name(checksum: Checksum) -> str:
    """The name of an algorithm: the public one where it has one, else one that states its parameters."""
    for algorithms in (SIMPLE, _catalogue()):
        for name, algorithm in algorithms.items():
            if algorithm == checksum:
                return name
    if checksum.method == "crc":
        reflected = ("r" if checksum.reflect_in else "f") + ("r" if checksum.reflect_out else "f")
        numbers = f"{checksum.polynomial:x}_{checksum.initial:x}_{reflected}_{checksum.final_xor:x}"
        return f"crc{checksum.width}_{numbers}"
    usual = 1 if checksum.method == "sum" else checksum.width // 8
    unit = f"_of{checksum.unit_size}" if checksum.unit_size != usual else ""
    start = f"_from_{checksum.initial:x}" if checksum.initial else ""
    complement = f"_{checksum.complement}" if checksum.complement else ""
    return f"{checksum.method}{checksum.width}{unit}{start}{complement}"


def preceded(checksum: Checksum, prefix: bytes, order: str) -> Checksum:
    """The algorithm whose result is that of some bytes behind a prefix: its computation begins where the prefix ends.

    `order` is that of the bytes which a sum or an xor takes as one number; the prefix has whole numbers.
    """
    number = checksum.initial
    if checksum.method == "crc":
        highest = checksum.width - 1
        for byte in prefix:
            for bit in range(8) if checksum.reflect_in else reversed(range(8)):
                feedback = number >> highest & 1 ^ byte >> bit & 1
                number = (number << 1 & checksum.mask) ^ (checksum.polynomial if feedback else 0)
        return replace(checksum, initial=number)
    size = checksum.unit_size
    for at in range(0, len(prefix), size):
        unit = int.from_bytes(prefix[at : at + size], "little" if order == "little" else "big")
        number = number + unit if checksum.method == "sum" else number ^ unit
    return replace(checksum, initial=number & checksum.mask)


DIGITS = {"decimal": 10, "upper_hex": 16, "lower_hex": 16}
"""The bases of the characters in which a checksum may be sent."""


def checksum_size(name: str, digits: str) -> int:
    """The bytes of a checksum in a frame: those of its number, or its characters."""
    checksum = checksum_named(name)
    if digits == "decimal":
        return len(str(checksum.mask))
    return (checksum.width + 3) // 4 if digits else checksum.size

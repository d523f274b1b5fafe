"""Checksum algorithms as data. A name says everything about an algorithm, so it is enough to compare names."""

from __future__ import annotations

import re
from functools import cache, partial

from fieldspec.foundation.classes import TYPE_CHECKING, dataclass, replace
from fieldspec.foundation.runtime._checksums import Avoiding, Crc, Fletcher, Followed, Sum, Swapped, Xor
from fieldspec.language.model import codecs

if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Literal


@dataclass(frozen=True, slots=True)
class Checksum:
    """An algorithm. Its `method` is `crc`, `sum`, `xor` or `fletcher`; `width` is the number of bits of its result.

    The method `codec` has only the width and the name of the `codec` of a package.
    The polynomial of a CRC is without its highest bit. `reflect_in` takes the lowest bit of each byte first, and
    `reflect_out` reverses the bits of the result. A sum or an xor takes `unit_size` bytes at a time as one number; a
    last number that is not complete is filled up with zeros after its bytes. The bytes of a number are in the order
    of the checksum, or in the `unit_order` where it is another one; a CRC takes them in the opposite order of the wire.
    `complement` is `ones`, `twos` or empty.
    A Fletcher checksum has two sums modulo `modulus`: the lower half of its bits is the sum of the numbers, the upper
    half the sum of all values that the lower one takes. The bytes of `suffix` come after those that it covers. Each
    byte of the result that is one of `avoided` is sent as the byte at the same place of `replacements`.
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
    modulus: int = 0
    suffix: bytes = b""
    unit_order: str = ""
    avoided: bytes = b""
    replacements: bytes = b""
    codec: str = ""

    @property
    def size(self) -> int:
        """The number of bytes of the result."""
        return (self.width + 7) // 8

    @property
    def has_order(self) -> bool:
        """Whether the order of its bytes, or that of the numbers that it takes, matters."""
        return self.size > 1 or self.unit_size > 1

    @property
    def mask(self) -> int:
        """The greatest result."""
        return (1 << self.width) - 1

    def function(self, order: str) -> Callable[[bytes], int]:
        """What computes it. `order` is that of the bytes which all but a CRC take as one number."""
        if self.codec:
            return partial(codecs.computed, self.codec)
        of_units: Literal["big", "little"] = "little" if (self.unit_order or order) == "little" else "big"
        function: Callable[[bytes], int]
        if self.method == "crc":
            flags = self.reflect_in, self.reflect_out
            function = Crc(self.width, self.polynomial, self.initial, *flags, self.final_xor)
            function = function if self.unit_size == 1 else Swapped(function, self.unit_size)
        elif self.method == "fletcher":
            function = Fletcher(self.width, self.initial, self.modulus, self.unit_size, of_units)
        else:
            method = Sum if self.method == "sum" else Xor
            function = method(self.width, self.initial, self.complement, self.unit_size, of_units)
        function = Followed(function, self.suffix) if self.suffix else function
        pairs = dict(zip(self.avoided, self.replacements, strict=True))
        return Avoiding(function, self.size, pairs) if pairs else function


SIMPLE = {
    "crc16_modbus": Checksum("crc", 16, 0x8005, 0xFFFF, True, True),
    "lrc": Checksum("sum", 8, complement="twos"),
    "sum8": Checksum("sum", 8),
}
"""The algorithms for which the codecs have shorter code."""

FLETCHER = {
    "adler32": Checksum("fletcher", 32, initial=1, modulus=65521),
    "fletcher16": Checksum("fletcher", 16, modulus=0xFF),
    "fletcher32": Checksum("fletcher", 32, unit_size=2, modulus=0xFFFF),
}
"""The Fletcher checksums with public names: from Fletcher's article, and from RFC 1950."""

_DERIVED_CRC = re.compile(r"crc(\d+)_([0-9a-f]+)_([0-9a-f]+)_([fr])([fr])_([0-9a-f]+)(?:_of(\d))?")
_DERIVED_SUM = re.compile(r"(sum|xor)(\d+)(?:_of(\d)([bl]?))?(?:_from_([0-9a-f]+))?(?:_(ones|twos))?")
_OF_CODEC = re.compile(r"codec(\d+)_(\w+)")
_SUFFIX = re.compile(r"(\w+)_then_((?:[0-9a-f]{2})+)")
_AVOIDED = re.compile(r"(\w+)_but_((?:[0-9a-f]{2})+)_as_((?:[0-9a-f]{2})+)")
_DERIVED_FLETCHER = re.compile(r"fletcher(\d+)_of(\d)([bl]?)_modulo_([0-9a-f]+)_from_([0-9a-f]+)")
_ORDERS = {"b": "big", "l": "little"}


@cache
def public_crcs() -> dict[str, Checksum]:
    """The CRCs of the public catalogue by name."""
    from fieldspec.language.schema.crc_catalogue import CRC_CATALOGUE

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
    own = _OF_CODEC.fullmatch(name)
    if own is not None:
        return Checksum("codec", int(own[1]), codec=own[2])
    avoiding = _AVOIDED.fullmatch(name)
    if avoiding is not None:
        avoided, replacements = bytes.fromhex(avoiding[2]), bytes.fromhex(avoiding[3])
        return replace(checksum_named(avoiding[1]), avoided=avoided, replacements=replacements)
    followed = _SUFFIX.fullmatch(name)
    if followed is not None:
        return replace(checksum_named(followed[1]), suffix=bytes.fromhex(followed[2]))
    for algorithms in (SIMPLE, FLETCHER):
        if name in algorithms:
            return algorithms[name]
    derived = _DERIVED_CRC.fullmatch(name)
    if derived is not None:
        width, polynomial, initial, reflect_in, reflect_out, final_xor, unit_size = derived.groups()
        numbers = int(width), int(polynomial, 16), int(initial, 16)
        reflected, final = (reflect_in == "r", reflect_out == "r"), int(final_xor, 16)
        return Checksum("crc", *numbers, *reflected, final, unit_size=int(unit_size or 1))
    derived = _DERIVED_SUM.fullmatch(name)
    if derived is not None:
        method, width, unit_size, unit_order, initial, complement = derived.groups()
        unit = int(unit_size) if unit_size else 1 if method == "sum" else int(width) // 8
        start = int(initial, 16) if initial else 0
        order = _ORDERS.get(unit_order, "")
        return Checksum(
            method, int(width), initial=start, complement=complement or "", unit_size=unit, unit_order=order
        )
    derived = _DERIVED_FLETCHER.fullmatch(name)
    if derived is not None:
        width, unit_size, unit_order, modulus, initial = derived.groups()
        start, order = int(initial, 16), _ORDERS.get(unit_order, "")
        unit, limit = int(unit_size), int(modulus, 16)
        return Checksum("fletcher", int(width), initial=start, unit_size=unit, modulus=limit, unit_order=order)
    return public_crcs()[name]


@cache
def catalogue_name(name: str) -> str:
    """The first name of an algorithm that has several."""
    if name in SIMPLE:
        return name
    from fieldspec.language.schema.crc_catalogue import OTHER_NAMES

    return dict(line.split() for line in OTHER_NAMES.splitlines()).get(name, name)


def algorithm_name(checksum: Checksum) -> str:
    """The name of an algorithm: the public one where it has one, else one that states its parameters."""
    if checksum.codec:
        return f"codec{checksum.width}_{checksum.codec}"
    if checksum.avoided:
        name = algorithm_name(replace(checksum, avoided=b"", replacements=b""))
        return f"{name}_but_{checksum.avoided.hex()}_as_{checksum.replacements.hex()}"
    if checksum.suffix:
        return f"{algorithm_name(replace(checksum, suffix=b''))}_then_{checksum.suffix.hex()}"
    for algorithms in (SIMPLE, FLETCHER, public_crcs()):
        for name, algorithm in algorithms.items():
            if algorithm == checksum:
                return name
    if checksum.method == "crc":
        reflected = ("r" if checksum.reflect_in else "f") + ("r" if checksum.reflect_out else "f")
        numbers = f"{checksum.polynomial:x}_{checksum.initial:x}_{reflected}_{checksum.final_xor:x}"
        unit = f"_of{checksum.unit_size}" if checksum.unit_size > 1 else ""
        return f"crc{checksum.width}_{numbers}{unit}"
    order = checksum.unit_order[:1]
    if checksum.method == "fletcher":
        parameters = f"of{checksum.unit_size}{order}_modulo_{checksum.modulus:x}_from_{checksum.initial:x}"
        return f"fletcher{checksum.width}_{parameters}"
    usual = 1 if checksum.method == "sum" else checksum.width // 8
    unit = f"_of{checksum.unit_size}{order}" if order or checksum.unit_size != usual else ""
    start = f"_from_{checksum.initial:x}" if checksum.initial else ""
    complement = f"_{checksum.complement}" if checksum.complement else ""
    return f"{checksum.method}{checksum.width}{unit}{start}{complement}"


def preceded(checksum: Checksum, prefix: bytes, order: str) -> Checksum:
    """The algorithm whose result is that of some bytes after a prefix: its computation begins where the prefix ends.

    `order` is that of the bytes which a sum, an xor or a Fletcher checksum takes as one number; the prefix has whole
    numbers.
    """
    begin = replace(checksum, final_xor=0, complement="", suffix=b"", avoided=b"", replacements=b"")
    return replace(checksum, initial=replace(begin, reflect_out=False).function(order)(prefix))


DIGITS = {"decimal": 10, "upper_hex": 16, "lower_hex": 16}
"""The bases of the characters in which a checksum may be sent."""


def checksum_size(name: str, digits: str) -> int:
    """The bytes of a checksum in a frame: its number, or its characters."""
    checksum = checksum_named(name)
    if digits == "decimal":
        return len(str(checksum.mask))
    return (checksum.width + 3) // 4 if digits else checksum.size

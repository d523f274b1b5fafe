"""A part of a frame with its offset."""

from __future__ import annotations

from typing import Literal

from fieldspec.codec.layout.checksums import checksum_bytes
from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.digits import digits_bytes, digits_number
from fieldspec.language.model.encoding import number_of, whole_bits, whole_number
from fieldspec.language.model.link import Part
from fieldspec.language.model.value import Value


@dataclass(frozen=True, slots=True)
class PartLayout:
    """A part of a frame. `offset` counts from the first part; after the body, it counts from the end and is negative.

    A checksum covers the bytes of the parts from `start` to `stop`, which are the bounds of a slice; negative ones
    count from the end, and None is the end. A length of n means that all parts together have `unit_size` * n + `base`
    bytes. `constant` is the value that is always sent. In a `reserved` part, anything may be received. A length or a
    checksum with `before_escape` is that of the original bytes, as it is for each one that is `escaped` itself.
    A part of some bits has the `size` and the `order` of the bytes that it shares with its neighbours; its number is
    the `width` bits from `shift` on.
    """

    part: Part
    name: str
    role: str
    offset: int
    size: int
    value: Value | None
    algorithm: str
    order: str
    start: int = 0
    stop: int | None = None
    unit_size: int = 1
    base: int = 0
    constant: int | None = None
    reserved: bool = False
    digits: str = ""
    escaped: bool = False
    before_escape: bool = False
    shift: int = 0

    @property
    def is_argument(self) -> bool:
        """Whether users supply its value."""
        return self.role in ("unit_address", "plain") and self.constant is None

    @property
    def width(self) -> int:
        """The bits of its number; 0 where it has whole bytes."""
        return self.value.packed_bits if self.value is not None else 0

    def at(self, length: int) -> int:
        """The offset of the part if all parts together have `length` bytes."""
        return self.offset if self.offset >= 0 else length + self.offset

    def checksum(self, data: bytes) -> bytes:
        """The bytes of the checksum over its part of all parts."""
        return checksum_bytes(self.algorithm, self.digits, self.order, self.size, data[self.start : self.stop])

    def number_text(self, number: int) -> str:
        """A number as manuals print a code: `0x03`, `0x1F` of two hexadecimal digits, `007` of three decimal digits."""
        if self.form == "decimal":
            return f"{number:0{self.size}d}"
        return f"0x{number:0{self.size if self.form else 2 * self.number_size}X}"

    @property
    def number_size(self) -> int:
        """The bytes of its number, or of its bits if it is part of an identifier."""
        return self.size if self.part.bits is None else (self.part.bits[1] - self.part.bits[0]) // 8 + 1

    def data(self, number: int) -> bytes:
        """The bytes, or the digits, of a number that they can express; other parts in the same bytes are 0."""
        assert self.value is not None
        if self.value.digits:
            return digits_bytes(self.value, number)
        order: Literal["big", "little"] = "little" if self.order == "little" else "big"
        whole = number_of(self.value.encoding)
        bits = number if whole is None else whole_bits(whole, number)
        return (bits << self.shift).to_bytes(self.size, order)

    def number(self, length: int) -> int | None:
        """The value of a length part if all parts together have `length` bytes; None if it cannot express that."""
        units, remainder = divmod(length - self.base, self.unit_size)
        return units if not remainder and self.value and self.value.low <= units <= self.value.high else None

    @property
    def form(self) -> str:
        """The form of the digits that its number is sent as; empty for a binary number, and for a checksum."""
        return self.value.digits if self.value is not None else ""

    def own_bytes(self, data: bytes) -> bytes:
        """The bytes of its number alone, where it shares them with other parts."""
        if not self.width:
            return data
        order: Literal["big", "little"] = "little" if self.order == "little" else "big"
        return (int.from_bytes(data, order) >> self.shift & (1 << self.width) - 1).to_bytes(len(data), order)

    def bytes_with(self, data: bytes, number: int) -> bytes:
        """Its bytes with a number in place of its own; other parts keep their bits."""
        if not self.width:
            return self.data(number)
        order: Literal["big", "little"] = "little" if self.order == "little" else "big"
        other_bits = int.from_bytes(data, order) & ~((1 << self.width) - 1 << self.shift)
        return (other_bits | number << self.shift).to_bytes(self.size, order)

    def read(self, data: bytes) -> int | None:
        """The number in exactly its bytes; None for bytes that are not its digits."""
        assert self.value is not None
        if self.value.digits:
            return digits_number(self.value, data) if len(data) == self.size else None
        bits = int.from_bytes(self.own_bytes(data), "little" if self.order == "little" else "big")
        whole = number_of(self.value.encoding)
        return bits if whole is None else whole_number(whole, bits)

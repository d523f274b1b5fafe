"""The slots of one field in a Struct: their letters, and the properties that reading and writing depend on.

A field takes one slot of its Struct for each element, and two or four for a number whose words are exchanged.
A number in another byte order than its Struct is a slot of bytes. Where another field decides the type of a field,
its slots are known only when that other field has been read.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal

from fieldspec.codec.layout.record import FieldLayout, RegisterLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import (
    Digits,
    Encoding,
    Octets,
    OfEncoding,
    Real,
    Sign,
    Text,
    Truth,
    Whole,
    bounds_of,
    is_array,
    is_exact,
    is_real,
    is_text,
    is_truth,
    struct_letter,
)
from fieldspec.language.model.enums import Bit
from fieldspec.language.model.ranges import Ranges
from fieldspec.language.model.raw_numbers import bytes_of_number
from fieldspec.language.model.value import Value
from fieldspec.targets.python.enums import EnumView


@dataclass(frozen=True, slots=True)
class Words:
    """The classes that fields refer to, by the names of the spec, and the registers with exponents of their scales.

    `device` says what is stated of values.
    """

    enums: Mapping[str, EnumView]
    flags: Mapping[str, str]
    records: Mapping[str, str]
    registers: tuple[RegisterLayout, ...]
    device: Device

    def bounded(self, flags: str) -> tuple[Bit, ...]:
        """The fields of bits with a range of a word; none where there is no word."""
        return self.device.flags[flags].bounded if flags else ()


@dataclass(frozen=True, slots=True)
class Slots:
    """A field in a Struct: the letters of one element, and how many there are, 0 where it is repeated to the end.

    `name` is the name of its attribute, `title` its name in the spec. `big`: the byte order of the Struct is big.
    `deferred`: the record stores the raw word, and converts it when the attribute is read.
    """

    field: FieldLayout
    name: str
    title: str
    letters: str
    count: int
    words: Words
    big: bool
    deferred: bool = False

    @property
    def slot(self) -> str:
        """The attribute that is filled from the wire."""
        return f"_word_{self.name}" if self.deferred else self.name

    @property
    def decided(self) -> bool:
        """Whether another field decides its type."""
        return bool(self.field.cases)

    @property
    def splits(self) -> bool:
        """Whether another field decides its type, and the data end with it, so that the Struct is another one too."""
        return self.field.splits_record

    @property
    def value(self) -> Value:
        """The value; for fields that are neither records nor decided by others."""
        assert self.field.value is not None
        return self.field.value

    @property
    def encoding(self) -> Encoding | None:
        """The encoding of its value; None for a record, and where another field decides the type."""
        return self.field.value.encoding if self.field.value else None

    @property
    def is_list(self) -> bool:
        """Whether the field has several elements."""
        return self.field.is_list

    @property
    def repeated(self) -> bool:
        """Whether it is repeated to the end of the data."""
        return self.field.count is None

    @property
    def in_room(self) -> bool:
        """Whether it is a list of free length or of packed numbers, a text beside lists, or a record of no one size."""
        own = self.field
        return self.repeated or own.in_room or (own.varies and (own.value is None or own.packing is not None))

    @property
    def constant(self) -> int | None:
        """The only raw value that the field may have; None where it may have several."""
        return self.value.const if self.whole else None

    @property
    def stored(self) -> bool:
        """Whether it has an attribute: constants, measures and reserved fields have none."""
        return not (self.field.field.reserved or self.field.field.measures or self.constant is not None)

    @property
    def whole(self) -> bool:
        """Whether it is a whole number on the wire."""
        return self.encoding is not None and is_exact(self.encoding)

    @property
    def parted(self) -> int:
        """The number of 16-bit slots of a number with exchanged words; 0 where it has one slot."""
        return len(self.letters) if self.whole and len(self.letters) > 1 and not self.letters.endswith("s") else 0

    @property
    def foreign(self) -> bool:
        """Whether it is a number that its Struct packs as bytes."""
        return self.encoding is not None and not is_array(self.encoding) and self.letters.endswith("s")

    @property
    def order(self) -> Literal["big", "little"]:
        """The byte order of its number."""
        return "big" if self.field.order == "big" else "little"

    def bytes_of(self, number: int) -> bytes:
        """The bytes of a number."""
        data = bytes_of_number(self.value, number)
        if (self.order == "big") == self.field.swapped:
            data = data[::-1]
        if not self.field.swapped:
            return data
        return b"".join(data[index : index + 2][::-1] for index in range(0, len(data), 2))

    @property
    def skipped(self) -> bool:
        """Whether the field is reserved and zero, so that its bytes are skipped."""
        return self.letters.endswith("x")

    @property
    def enum(self) -> EnumView | None:
        """The enum of its values."""
        return self.words.enums[self.value.enum] if self.field.value and self.value.enum else None

    @property
    def sentinels(self) -> tuple[tuple[int, int], ...]:
        """The intervals of the values beside the ranges, but for a NaN."""
        return self.value.special_intervals

    @property
    def is_raw(self) -> bool:
        """Whether the raw value is the value."""
        if self.encoding is None or self.parted or self.foreign or is_truth(self.encoding) or is_text(self.encoding):
            return False
        return not (self.value.enum or self.value.flags)

    @property
    def deferrable(self) -> bool:
        """Whether it is one word of bits, or one member of an open enum that is not a truth value.

        Every such word is valid when it is read, so it can be converted later.
        """
        if self.field.value is None or self.is_list or not self.stored or self.parted or self.foreign:
            return False
        if is_truth(self.value.encoding):
            return False
        return bool(self.value.flags) or (self.enum is not None and self.enum.open)

    @property
    def element_type(self) -> str:
        """The type of one element."""
        if self.field.record is not None:
            return self.words.records[self.field.record.name]
        if self.decided:
            return " | ".join(dict.fromkeys(value_type(case.value, self.words) for case in self.field.cases))
        return value_type(self.value, self.words)

    @property
    def type(self) -> str:
        """The type of the attribute. A tuple takes elements of one of several types, a list only of all of them."""
        if self.is_list and self.decided:
            return f"tuple[{self.element_type}, ...]"
        return f"list[{self.element_type}]" if self.is_list else self.element_type

    @property
    def accepted(self) -> str:
        """The type that the attribute accepts: a word of bits also as a number."""
        return f"{self.type} | int" if self.deferred and self.value.flags else self.type

    @property
    def ranges(self) -> Ranges | None:
        """The ranges for writing, where they are narrower than the type. A number of bytes has none in an image."""
        value = self.field.value
        ranges = value.writable_ranges if value is not None and not self.field.counts_sent else None
        if ranges is None or is_real(self.value.encoding):
            return ranges
        full = ranges.intervals == (bounds_of(self.value.encoding),)
        return None if full or not self.whole else ranges


_TYPES = OfEncoding(whole="int", digits="int", truth="bool", real="float", text="str", octets="bytes")


def value_type(value: Value, words: Words) -> str:
    """The type of the attribute for a value."""
    if value.flags:
        return words.flags[value.flags]
    if value.enum and value.const is None:
        enum = words.enums[value.enum]
        return f"{enum.name} | int" if value.sentinels else enum.type
    return _TYPES(value.encoding)


def native_order(fields: tuple[FieldLayout, ...]) -> str:
    """The byte order of a Struct that holds some fields: the order of the first number of several bytes."""
    for field in fields:
        if field.value is not None and field.size > 1 and struct_letter(field.value.encoding) != "s":
            return field.order
        if field.cases:
            return next((case.order for case in field.cases if case.value.size > 1), "big")
    return "big"


def slots(field: FieldLayout, name: str, words: Words, order: str) -> Slots:
    """The slots of a field in a Struct of a byte order; `name` is that of its attribute."""
    count = field.count if field.count is not None else 0
    return Slots(field, name, field.name, _letters(field, order), count, words, order == "big")


def _letters(field: FieldLayout, order: str) -> str:
    value = field.value
    if field.splits_record:
        return ""
    if value is None:
        return f"{field.size}{'x' if field.field.reserved else 's'}"
    reserved = field.field.reserved and not field.field.measures
    if reserved and not value.const and not (isinstance(value.default, int) and value.default):
        return f"{field.size}x"
    encoding = value.encoding
    is_native = field.size == 1 or (field.order == order and not field.swapped)
    letters = struct_letter(encoding) if is_native else ""
    match encoding:
        case Digits() | Text() | Octets():
            letters = ""
        case Whole():
            if field.swapped and field.order == order and not field.is_list:
                letters = _word_letters(encoding, order)
        case Real() | Truth():
            pass
        case _:
            assert_never(encoding)
    return letters or f"{field.size}s"


def _word_letters(whole: Whole, order: str) -> str:
    """The letters of the words of a number in the other order than its bytes: where these are big-endian, the least
    significant word comes first. Empty for a number that is read from its bytes.
    """
    match whole.sign:
        case Sign.NONE:
            last = "H"
        case Sign.COMPLEMENT:
            last = "h"
        case Sign.MAGNITUDE:
            return ""
        case _:
            assert_never(whole.sign)
    lower = "H" * (whole.bits // 16 - 1)
    return lower + last if order == "big" else last + lower

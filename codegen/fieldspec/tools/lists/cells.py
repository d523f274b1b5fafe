"""Reads the cells of a register list: addresses, types, accesses, numbers, ranges."""

from __future__ import annotations

import re
import unicodedata
from decimal import Decimal

from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.primitives import PRIMITIVES, Kind
from fieldspec.tools.lists.sheet import ListError

HEXADECIMAL, DECIMAL, REFERENCE = "hex", "decimal", "4xxxx"
BASES = (HEXADECIMAL, DECIMAL, REFERENCE)
"""How digits without a prefix are read. A reference is a digit for its table and an address from 1: 40001 is 0."""

HIGHEST = 0xFFFFFFFF

_HEX = re.compile(r"(?:0x|&h|\$)([0-9a-f]{1,8})|([0-9a-f]{1,8})h", re.IGNORECASE)
_TABLE = re.compile(r"[34]x[ -]?([0-9]{1,5})", re.IGNORECASE)
_DIGITS = re.compile(r"[0-9a-f]{1,10}", re.IGNORECASE)
_POINTLESS = re.compile(r"([0-9]+)\.0+")
_GROUPED = re.compile(r"[0-9]{1,3}(?:[,.' ][0-9]{3})+")
_SPAN = re.compile(r"\s*(?:\.\.+|~|\u2013|\u2014|-|至|to)\s*", re.IGNORECASE)
_REFERENCES = ((40001, 49999), (30001, 39999), (400001, 465536), (300001, 365536))


@dataclass(frozen=True, slots=True)
class AddressText:
    """An address: its digits, and how its prefix or suffix says to read them: `hex`, `4xxxx`, or empty."""

    digits: str
    mark: str = ""

    @property
    def lettered(self) -> bool:
        """Whether digits without a mark include letters, which makes them hexadecimal."""
        return not self.mark and not self.digits.isdecimal()

    def reference(self) -> int | None:
        """The address of a reference, counted from 0; None if the text is no reference."""
        if self.mark == REFERENCE:
            return int(self.digits) - 1
        number = int(self.digits) if not self.mark and self.digits.isdecimal() else 0
        return next((number - low for low, high in _REFERENCES if low <= number <= high), None)

    def number(self, base: str) -> int | None:
        """The address. Digits without a mark are read as `base` says; None if they cannot be."""
        if self.mark == HEXADECIMAL or (not self.mark and base == HEXADECIMAL):
            return int(self.digits, 16)
        if self.mark == REFERENCE or base == REFERENCE:
            return self.reference()
        return int(self.digits) if self.digits.isdecimal() else None


@dataclass(frozen=True, slots=True)
class AddressRange:
    """The addresses in a cell: one, or the first and the last of several."""

    first: AddressText
    last: AddressText | None = None


def address_text(text: str) -> AddressText | None:
    """The address in a text, None if it is none."""
    text = unicodedata.normalize("NFKC", text).strip()
    pointless = _POINTLESS.fullmatch(text)
    text = pointless[1] if pointless else text
    if marked := _HEX.fullmatch(text):
        return AddressText(marked[1] or marked[2], HEXADECIMAL)
    if table := _TABLE.fullmatch(text):
        return AddressText(table[1], REFERENCE)
    return AddressText(text) if _DIGITS.fullmatch(text) else None


def address_range(text: str, row: int) -> AddressRange | None:
    """The addresses in a cell, None if there are none. Raises ListError for a number with separators."""
    normalized = unicodedata.normalize("NFKC", text).strip()
    if _GROUPED.fullmatch(normalized):
        raise ListError(f"has the address `{text}` in row {row}, with thousands separators; remove them")
    whole = address_text(normalized)
    if whole is not None:
        return AddressRange(whole)
    parts = _SPAN.split(normalized)
    ends = [address_text(part) for part in parts]
    if len(ends) == 2 and ends[0] is not None and ends[1] is not None:
        first, last = ends[0], ends[1]
        if last.mark == HEXADECIMAL and not first.mark:
            first = AddressText(first.digits, HEXADECIMAL)
        if first.mark == HEXADECIMAL and not last.mark:
            last = AddressText(last.digits, HEXADECIMAL)
        return AddressRange(first, last)
    return None


def base_of_heading(heading: str) -> str:
    """The base that a heading names, empty if it names none."""
    normalized = unicodedata.normalize("NFKC", heading).casefold()
    if re.search(r"hex|\(h\)|十六|16\s*[进進]|0x", normalized):
        return HEXADECIMAL
    return DECIMAL if re.search(r"\bdec|\(d\)|十进|十進|10\s*[进進]", normalized) else ""


_TYPES: dict[str, str] = {
    **{name: name for name in PRIMITIVES},
    **dict.fromkeys(
        ("uint16", "ushort", "unsignedshort", "word", "uint", "unsigned16", "uint16t", "enum16", "bitfield16"), "u16"
    ),
    **dict.fromkeys(("int16", "short", "sint16", "s16", "signed16", "int16t", "sunssf"), "i16"),
    **dict.fromkeys(
        ("uint32", "dword", "udint", "ulong", "unsignedlong", "unsigned32", "uint32t", "acc32", "bitfield32"), "u32"
    ),
    **dict.fromkeys(("int32", "dint", "long", "sint32", "s32", "signed32", "int32t"), "i32"),
    **dict.fromkeys(("uint64", "ulint", "qword", "lword", "uint64t"), "u64"),
    **dict.fromkeys(("int64", "lint", "s64", "int64t"), "i64"),
    **dict.fromkeys(("uint8", "byte", "usint", "uchar", "uint8t"), "u8"),
    **dict.fromkeys(("int8", "sint", "s8", "sbyte", "int8t"), "i8"),
    **dict.fromkeys(("float", "float32", "real", "single", "浮点", "浮點"), "f32"),
    **dict.fromkeys(("string", "str", "ascii", "char", "字符串", "字串"), "text"),
}
_LOOSE: dict[str, tuple[Kind, bool | None]] = {
    **dict.fromkeys(("int", "integer", "signed", "有符号", "有符號", "带符号", "帶符號"), (Kind.INTEGER, True)),
    **dict.fromkeys(("unsigned", "无符号", "無符號"), (Kind.INTEGER, False)),
    **dict.fromkeys(("bool", "boolean", "bit", "coil", "布尔", "布爾"), (Kind.BOOLEAN, None)),
}
_ACCESSES: dict[str, str] = {
    **dict.fromkeys(("ro", "r", "read", "readonly", "只读", "唯讀", "唯读", "读", "讀", "只讀"), "ro"),
    **dict.fromkeys(
        ("rw", "wr", "readwrite", "readandwrite", "读写", "讀寫", "可读写", "可讀寫", "可读可写", "可讀可寫"), "rw"
    ),
    **dict.fromkeys(("wo", "w", "write", "writeonly", "只写", "唯寫", "只寫", "唯写", "写", "寫"), "wo"),
}
_NUMBER = re.compile(r"([-+]?)(?:0x([0-9a-f]{1,16})|([0-9a-f]{1,16})h|([0-9]{1,20}(?:\.[0-9]{1,20})?))", re.IGNORECASE)
_RANGE = re.compile(r"\s*(?:\.\.+|~|\u2013|\u2014|至|\bto\b|(?<=[0-9hH]) ?- ?(?=[-+0-9]))\s*", re.IGNORECASE)


@dataclass(frozen=True, slots=True)
class Typed:
    """A type as a list has it: the name of a type, or its kind and perhaps whether it is signed."""

    name: str = ""
    kind: Kind | None = None
    signed: bool | None = None

    def fits(self, name: str) -> bool:
        """Whether the type with a name agrees."""
        primitive = PRIMITIVES.get(name)
        if primitive is None or name == self.name:
            return name == self.name
        if self.name:
            return False
        return primitive.kind is self.kind and self.signed in (None, primitive.signed)

    def of_words(self, words: int | None) -> str:
        """The name of the type; if the list has only its kind, that of the type with so many words."""
        if self.name:
            return self.name
        if self.kind is Kind.BOOLEAN:
            return "bool16"
        letter = "i" if self.signed else "u"
        return {1: f"{letter}16", 2: f"{letter}32", 4: f"{letter}64"}.get(words or 1, "bytes")


def _folded(text: str) -> str:
    wide = unicodedata.normalize("NFKC", text).casefold()
    return "".join(sign for sign in wide if sign.isalnum())


def typed(text: str) -> Typed | None:
    """The type that a text names, None if it names none that is known."""
    word = re.sub(r"[\[(].*", "", text)
    name = _TYPES.get(_folded(word))
    if name:
        return Typed(name)
    loose = _LOOSE.get(_folded(word))
    return Typed("", *loose) if loose else None


def access(text: str) -> str:
    """`ro`, `rw`, `wo`, or empty if the text is no access."""
    return _ACCESSES.get(_folded(text), "")


def number(text: str) -> Decimal | None:
    """An exact number, decimal, or hexadecimal with a prefix or suffix; None if the text is none."""
    match = _NUMBER.fullmatch(unicodedata.normalize("NFKC", text).replace("\u2212", "-").strip())
    if match is None:
        return None
    sign, marked, ended, decimal = match.groups()
    magnitude = Decimal(decimal) if decimal else Decimal(int(marked or ended, 16))
    return -magnitude if sign == "-" else magnitude


def whole(text: str) -> int | None:
    """A whole number, None if the text is none."""
    value = number(text)
    return int(value) if value is not None and value == value.to_integral_value() else None


def bounds(text: str) -> tuple[Decimal, Decimal] | None:
    """The ends of a range such as `0~100`, `0-100`, `-5 to 5`, `0..0FFh`; None if the text is none."""
    ends = [number(part) for part in _RANGE.split(unicodedata.normalize("NFKC", text).strip())]
    if len(ends) != 2 or ends[0] is None or ends[1] is None or ends[0] > ends[1]:
        return None
    return ends[0], ends[1]

"""The bytes of a value as its number, its quantity, and the names that the spec has for it."""

from __future__ import annotations

import struct
from collections.abc import Iterator
from decimal import Context, Decimal

from fieldspec.classes import dataclass, replace
from fieldspec.layout.values import Raw
from fieldspec.model.device import Device
from fieldspec.model.enums import Bit, Enum, Flags, State
from fieldspec.model.value import Kind, Ranges, Value

# What is short enough to be written as it is, and how many digits are left of what is not.
_PLACES, _DIGITS, _ROUNDED = 6, 8, 6


@dataclass(frozen=True, slots=True)
class Meaning:
    """A name for a value, or for some of its bits: `bits` is empty, `3`, or `9..10`.

    `label` is the manual's word for it, `text` is in our own words. `kind` is `state` for what several bits show
    together, else empty.
    """

    name: str
    label: str
    text: str
    bits: str
    kind: str = ""


@dataclass(frozen=True, slots=True)
class DecodedValue:
    """What bytes say.

    `number` is the raw value, None where there are too few bytes. `text` is the value in its unit, as `in_unit`
    writes it. `verdict` is empty, `right`, or `wrong: should be ..`; `reason` is
    then the word of the codecs' errors. `facts` are the paths of enums, members and bits that took part.
    """

    number: Raw | None
    text: str = ""
    meanings: tuple[Meaning, ...] = ()
    verdict: str = ""
    reason: str = ""
    notes: tuple[str, ...] = ()
    facts: tuple[str, ...] = ()

    def judged(self, right: bool, should: object, reason: str) -> DecodedValue:
        """The same with a verdict, and with the reason for which a codec refuses a wrong value."""
        if right:
            return replace(self, verdict="right", reason="")
        return replace(self, verdict=f"wrong: should be {should}", reason=reason)


def whole(data: bytes, order: str) -> int:
    """Bytes as an unsigned number, in the order `big` or `little`."""
    return int.from_bytes(data, "big" if order == "big" else "little")


def number_of(value: Value, data: bytes, order: str, swapped: bool) -> Raw:
    """The raw value of bytes, as many as the value has; texts and bytes as they are.

    `swapped` says that the 16-bit words lie in the other order than the bytes of each.
    """
    kind = value.type.kind
    if kind in (Kind.TEXT, Kind.BYTES):
        return data
    if swapped:
        data = b"".join(data[at : at + 2][::-1] for at in range(0, len(data), 2))
    big = (order == "big") != swapped
    if kind is Kind.FLOAT:
        number: float = struct.unpack(">f" if big else "<f", data)[0]
        return number
    return int.from_bytes(data, "big" if big else "little", signed=value.type.signed)


def decimal_text(number: Decimal) -> str:
    """A number without an exponent: as it is where it is short, else rounded to six digits.

    Where these would look like another number in full, such as 25 for 24.9999999, there are as many as it takes.
    """
    short = number.normalize(Context(prec=200))
    if -_exponent(number) <= _PLACES:
        return format(number, "f")
    if -_exponent(short) <= _PLACES or len(short.as_tuple().digits) <= _DIGITS:
        return format(short, "f")
    for digits in range(_ROUNDED, len(short.as_tuple().digits)):
        rounded = Context(prec=digits).plus(short).normalize()
        if len(rounded.as_tuple().digits) == digits:
            return format(rounded, "f")
    return format(short, "f")


def _exponent(number: Decimal) -> int:
    exponent = number.as_tuple().exponent
    return exponent if isinstance(exponent, int) else 0


def in_unit(value: Value, number: int) -> str:
    """`20.00 mm`: the value with its unit, as `decimal_text` writes it.

    Empty where it has neither unit nor scale, and for a sentinel, which is no quantity.
    """
    if (not value.unit and not value.scaled) or value.sentinel(number) is not None:
        return ""
    return f"{decimal_text(value.in_unit(number))} {value.unit}".strip()


def range_in_unit(value: Value, ranges: Ranges) -> str:
    """`0.00..20.00, 30.00 mm`: intervals of counts in the value's unit."""

    def bound(count: int) -> str:
        return decimal_text(value.in_unit(count))

    text = ", ".join(bound(low) if low == high else f"{bound(low)}..{bound(high)}" for low, high in ranges.intervals)
    return f"{text} {value.unit}".strip()


def decode_value(
    device: Device, value: Value, data: bytes, order: str, swapped: bool, reserved: bool = False
) -> DecodedValue:
    """What the bytes of a value say; `data` must be exactly as long as the value. Never raises."""
    number = number_of(value, data, order, swapped)
    if reserved:
        return DecodedValue(number)
    kind = value.type.kind
    if kind is Kind.BOOLEAN:
        return _boolean(device, value, number)
    if kind is Kind.TEXT:
        if any(byte > 0x7F for byte in data):
            return DecodedValue(data).judged(False, "ASCII", "unknown_value")
        return DecodedValue(data.rstrip(b"\0").decode("ascii"))
    if isinstance(number, float):
        return _float(value, number)
    if not isinstance(number, int):
        return DecodedValue(number)
    return _whole(device, value, number)


def _float(value: Value, number: float) -> DecodedValue:
    """What a floating-point number says: it counts in the unit."""
    sentinel = value.sentinel(number)
    if sentinel is not None:
        return DecodedValue(number, meanings=(Meaning(sentinel.name, "", sentinel.doc, ""),))
    found = DecodedValue(number, f"{number!r} {value.unit}" if value.unit else "")
    if value.ranges is None or number in value.ranges:
        return found
    return found.judged(False, f"{value.ranges.text()} {value.unit}".strip(), "out_of_range")


def _boolean(device: Device, value: Value, number: Raw) -> DecodedValue:
    if number not in (0, 1):
        return DecodedValue(number).judged(False, "0 or 1", "unknown_value")
    named = _named(device, value, int(bool(number))) if value.enum else DecodedValue(number)
    return replace(named, number=bool(number))


def _whole(device: Device, value: Value, number: int) -> DecodedValue:
    """What a whole number says."""
    if value.const is not None and number != value.const:
        return DecodedValue(number).judged(False, value.const, "wrong_const")
    found = DecodedValue(number, verdict="" if value.const is None else "right")
    sentinel = value.sentinel(number)
    if sentinel is not None:
        return replace(found, meanings=(Meaning(sentinel.name, "", sentinel.doc, ""),))
    if value.enum:
        named = _named(device, value, number)
        found = replace(named, text=in_unit(value, number), verdict=named.verdict or found.verdict)
    elif value.flags:
        word = device.flags[value.flags]
        found = replace(found, meanings=tuple(_set_bits(device, word, number)), facts=(word.place.path,))
    else:
        found = replace(found, text=in_unit(value, number))
    if not found.reason and value.ranges is not None and number not in value.ranges:
        found = found.judged(False, range_in_unit(value, value.ranges), "out_of_range")
    return found


def _named(device: Device, value: Value, number: int) -> DecodedValue:
    """The member of the value's enum that has the number."""
    enum = device.enums[value.enum]
    member = enum.member(number)
    if member is None:
        if enum.open:
            return DecodedValue(number, notes=(f"{enum.name} does not list {number}.",), facts=(enum.place.path,))
        return DecodedValue(number).judged(False, _known(enum), "unknown_value")
    meaning = Meaning(member.name, member.label, member.problem or member.doc, "")
    found = DecodedValue(number, meanings=(meaning,), notes=member.notes, facts=(enum.place.path, member.place.path))
    if member.unavailable and not enum.open:
        notes = (*member.notes, f"{member.name} is listed as not available.")
        return replace(found, notes=notes).judged(False, _known(enum), "unknown_value")
    return found


def _known(enum: Enum) -> str:
    """`one of 1, 2, 5`"""
    return f"one of {', '.join(str(member.value) for member in enum.members if not member.unavailable)}"


def _set_bits(device: Device, word: Flags, number: int) -> Iterator[Meaning]:
    """The bits that are set, the fields of several bits that have names, and bits that nothing is known of."""
    number &= (1 << 8 * word.type.size) - 1
    unknown = number
    for bit in word.bits:
        held = (number & bit.mask) >> bit.first
        unknown &= ~bit.mask
        if held or (bit.enum and not bit.reserved):
            yield _bit(device, bit, held)
    for at in range(unknown.bit_length()):
        if unknown >> at & 1:
            yield Meaning("", "", "not listed", str(at))
    yield from (_state(state) for state in word.states if _shows(word, state, number))


def _shows(word: Flags, state: State, number: int) -> bool:
    """Whether the bits of a word are those of a state."""
    mask, value = word.masked(state)
    return number & mask == value


def _state(state: State) -> Meaning:
    return Meaning(state.name, state.label, f"state {state.printed_name}".strip(), "", "state")


def _bit(device: Device, bit: Bit, held: int) -> Meaning:
    bits = str(bit.first) if bit.width == 1 else f"{bit.first}..{bit.last}"
    if bit.enum:
        member = device.enums[bit.enum].member(held)
        if member is not None:
            return Meaning(f"{bit.name}={member.name}", member.label or bit.label, member.doc, bits)
    if bit.width > 1:
        return Meaning(f"{bit.name}={held}", bit.label, bit.doc, bits)
    said = bit.one or bit.doc
    if bit.edge:
        said = "; ".join(text for text in (said.removesuffix("."), f"acts at its {bit.edge} edge") if text)
    return Meaning(bit.name, bit.label, said, bits)

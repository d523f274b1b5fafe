"""Decodes a value: its raw value, its quantity, and the names that the spec gives it."""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Context, Decimal

from fieldspec.codec.explain import sentences
from fieldspec.codec.layout.accepted import (
    Equals,
    Fits,
    HasCharacters,
    HasDigits,
    IsBit,
    Known,
    PartWithin,
    RealWithin,
    Test,
    Within,
)
from fieldspec.codec.layout.value_texts import spec_text
from fieldspec.codec.layout.values import Raw
from fieldspec.codec.layout.widths import value_form
from fieldspec.codec.program.interpreter import Row, read_value
from fieldspec.codec.program.lowering import value_program
from fieldspec.foundation.classes import TYPE_CHECKING, dataclass, replace
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.device import Device
from fieldspec.language.model.digits import digits_text
from fieldspec.language.model.encoding import (
    Digits,
    Octets,
    Real,
    Text,
    Truth,
    Whole,
    is_array,
    is_real,
)
from fieldspec.language.model.enums import Bit, Enum, Flags, Member, State
from fieldspec.language.model.ranges import Ranges
from fieldspec.language.model.raw_numbers import number_in
from fieldspec.language.model.text_form import encoding_title, text_form_title
from fieldspec.language.model.value import Value

if TYPE_CHECKING:
    from fractions import Fraction

ACCEPTED = ("", "out_of_range")
"""Reasons with which a codec still accepts a value: the manual prints narrower bounds than the type has."""
_MOST_PLACES, _MOST_DIGITS, _ROUNDED_DIGITS = 6, 8, 6
"""Numbers with at most this number of places, or digits, are written in full; others are rounded to it."""
_EXACT = Context(prec=200)


@dataclass(frozen=True, slots=True)
class Meaning:
    """A name of a value, or of some of its bits: `bits` is empty, `3`, or `9..10`.

    `label` is the manual's word, `text` the description in our own words. `kind` is `state` for a state that several
    bits show together, else empty.
    """

    name: str
    label: str
    text: str
    bits: str
    kind: str = ""


@dataclass(frozen=True, slots=True)
class DecodedValue:
    """The meaning of the bytes of a value.

    `number` is the raw value, None if there are too few bytes. `text` is the quantity as `in_unit` writes it.
    `verdict` is empty, `right`, or `wrong: should be ..`, and `reason` then names the fault as the errors of the codecs
    do. `facts` are the paths of the enums, members and bits that give the value its meaning.
    """

    number: Raw | None
    text: str = ""
    meanings: tuple[Meaning, ...] = ()
    verdict: str = ""
    reason: str = ""
    notes: tuple[str, ...] = ()
    facts: tuple[str, ...] = ()

    def judged(self, right: bool, expected: object, reason: str) -> DecodedValue:
        """The same value with a verdict; of a wrong one, also the reason for which a codec refuses it."""
        if right:
            return replace(self, verdict="right", reason="")
        return replace(self, verdict=sentences.SHOULD_BE.format(expected=expected), reason=reason)


def repeated_value(read: DecodedValue, expected: Raw, value: Value | None) -> DecodedValue:
    """A value that repeats another one, judged by that one."""
    text = spec_text(
        float(expected) if value is not None and is_real(value.encoding) and isinstance(expected, int) else expected
    )
    return read.judged(read.number == expected, text, "")


def fault_of(verdict: str) -> str:
    """The fault of a wrong value by its verdict: `should be 5`."""
    return verdict.removeprefix(sentences.WRONG.format(fault=""))


def whole(data: bytes, order: str) -> int:
    """Bytes as an unsigned number. `order` is `big` or `little`."""
    return int.from_bytes(data, "big" if order == "big" else "little")


def number_of(value: Value, data: bytes, order: str, swapped: bool) -> Raw:
    """The raw value of all bytes of a value; texts, bytes, and bytes that are not the digits of a number, as bytes."""
    if is_array(value.encoding):
        return data
    number = number_in(value, data, order, swapped)
    return data if number is None else number


def decimal_text(number: Decimal, count: Decimal | Fraction) -> str:
    """A number without an exponent: in full if it is short, else rounded after the point.

    The last digit is worth less than a `count`, so that no two multiples of it, from any offset, have the same text.
    If the rounded number would look exact, as 25 for 24.9999999 does, more digits are written.
    """
    short = number.normalize(_EXACT)
    if -_exponent(number) <= _MOST_PLACES:
        return format(number, "f")
    if -_exponent(short) <= _MOST_PLACES or len(short.as_tuple().digits) <= _MOST_DIGITS:
        return format(short, "f")
    for places in range(max(_resolving_places(count), _ROUNDED_DIGITS - 1 - short.adjusted()), -_exponent(short)):
        rounded = short.quantize(Decimal(1).scaleb(-places), context=_EXACT)
        if rounded.as_tuple().digits[-1]:
            return format(rounded, "f")
    return format(short, "f")


def _resolving_places(count: Decimal | Fraction) -> int:
    """The fewest places, at least one, whose last digit is worth less than a count."""
    above, below = count.as_integer_ratio()
    places = 1
    while abs(above) * 10**places <= below:
        places += 1
    return places


def _exponent(number: Decimal) -> int:
    exponent = number.as_tuple().exponent
    return exponent if isinstance(exponent, int) else 0


def in_unit(value: Value, number: int) -> str:
    """The quantity of a raw value with its unit, as in `20.00 mm`, with the digits that `decimal_text` writes.

    Empty for a value without unit and scale, and for a sentinel, which is not a quantity.
    """
    if (not value.unit and not value.scaled) or value.sentinel(number) is not None:
        return ""
    return f"{decimal_text(value.in_unit(number), value.scale)} {value.unit}".strip()


def range_in_unit(value: Value, ranges: Ranges) -> str:
    """Intervals of raw values as quantities with their unit: `0.00..20.00, 30.00 mm`."""

    def bound(count: int) -> str:
        return decimal_text(value.in_unit(count), value.scale)

    text = ", ".join(bound(low) if low == high else f"{bound(low)}..{bound(high)}" for low, high in ranges.intervals)
    return f"{text} {value.unit}".strip()


def has_in_ranges(value: Value, number: int) -> bool:
    """Whether a value has ranges, and a number is in one of them."""
    return value.ranges is not None and number in value.ranges


def intervals_of(value: Value) -> tuple[tuple[int, int], ...]:
    """The intervals of the ranges of a value."""
    return value.ranges.intervals if value.ranges is not None else ()


def exponent_applied(value: Value, exponent: Value, number: Raw | None) -> Value:
    """A value with the scale that the number of its exponent makes; unchanged for a number that is not an exponent."""
    if not isinstance(number, int) or not has_in_ranges(exponent, number):
        return value
    return value.scaled_by(number) if exponent.sentinel(number) is None else value


def decode_value(
    device: Device, value: Value, data: bytes, order: str, swapped: bool, reserved: bool = False
) -> DecodedValue:
    """The meaning of the bytes of a value. `data` must have exactly the size of the value. Never raises."""
    return decoded_row(device, read_value(value_program(device, value, order, swapped, reserved), data), value)


def decoded_row(device: Device, row: Row, value: Value) -> DecodedValue:
    """The meaning of what a program says of some bytes; `value` is that of the variable, with a scale that is read."""
    failed = row.failed
    if row.variable.is_reserved:
        return DecodedValue(row.number)
    if failed is None:
        return _named(device, value, row)
    # What is not the constant stands for nothing.
    decoded = DecodedValue(row.number) if failed.reason == "wrong_const" else _named(device, value, row)
    return decoded.judged(False, _expected(device, value, row, failed.test), failed.reason)


def _expected(device: Device, value: Value, row: Row, test: Test) -> str:
    """What passes a test, as verdicts say it."""
    match test:
        case Equals():
            return str(test.number)
        case IsBit():
            return sentences.TRUTH_NUMBERS
        case HasDigits():
            return digits_text(value)
        case HasCharacters():
            return text_form_title(value) or encoding_title(value) if row.image is not None else value_form(value)
        case Known():
            return member_list(device.enums[test.enum])
        case Within():
            return range_in_unit(value, Ranges(test.intervals))
        case RealWithin():
            return f"{value.ranges.text() if value.ranges else ''} {value.unit}".strip()
        case PartWithin():
            part = test.bit.as_value
            return f"{test.bit.name} {range_in_unit(part, part.ranges or Ranges(()))}"
        case Fits():
            raise AssertionError("only writers refuse what does not fit")
        case _:
            assert_never(test)


def _named(device: Device, value: Value, row: Row) -> DecodedValue:
    """The quantity of a content, and the names that the spec gives it."""
    content, encoding = row.content, value.encoding
    match encoding:
        case Text() | Octets():
            return DecodedValue(row.number)
        case Truth():
            is_member = value.enum and content in (0, 1)
            decoded = _member_meaning(device, value, int(content == 1)) if is_member else DecodedValue(None)
            return replace(decoded, number=row.number)
        case Real():
            assert isinstance(content, float)
            return _float(value, content)
        case Whole() | Digits():
            return _whole(device, value, content) if isinstance(content, int) else DecodedValue(row.number)
        case _:
            assert_never(encoding)


def decode_answer(
    device: Device,
    value: Value,
    data: bytes,
    order: str,
    swapped: bool,
    reserved: bool = False,
    trigger: bool = False,
) -> DecodedValue:
    """The meaning of the bytes of a value that is read: one that is not its constant has a note. Never raises.

    A constant binds only what is written, so that codecs take such an answer. The answer of a `trigger` is wrong only
    if codecs refuse it, as `Value.as_answer` says.
    """
    arguments = data, order, swapped, reserved
    read = decode_value(device, value, *arguments)
    if read.reason == "wrong_const":
        answer = decode_value(device, value.as_answer(False), *arguments)
        read = replace(answer, notes=(*answer.notes, sentences.IT.format(statement=fault_of(read.verdict))))
    if not trigger or decode_value(device, value.as_answer(True), *arguments).reason == "unknown_value":
        return read
    return replace(read, verdict="", reason="")


def _float(value: Value, number: float) -> DecodedValue:
    """The meaning of a floating-point number, which is a quantity in the unit of the value."""
    sentinel = value.sentinel(number)
    if sentinel is not None:
        return DecodedValue(number, meanings=(Meaning(sentinel.name, "", sentinel.doc, ""),))
    return DecodedValue(number, f"{number!r} {value.unit}" if value.unit else "")


def _whole(device: Device, value: Value, number: int) -> DecodedValue:
    """The meaning of a whole number that a value has."""
    decoded = DecodedValue(number, verdict="" if value.const is None else "right")
    sentinel = value.sentinel(number)
    if sentinel is not None:
        return replace(decoded, meanings=(Meaning(sentinel.name, "", sentinel.doc, ""),))
    if value.enum:
        return replace(_member_meaning(device, value, number), text=in_unit(value, number), verdict=decoded.verdict)
    if not value.flags:
        return replace(decoded, text=in_unit(value, number))
    word = device.flags[value.flags]
    meanings = tuple(_set_bits(device, word, number))
    notes = (remark_on_bit_numbers(word),) if word.bit_0 == "most" and any(own.bits for own in meanings) else ()
    return replace(decoded, meanings=meanings, notes=notes, facts=(word.place.path,))


def _member_meaning(device: Device, value: Value, number: int) -> DecodedValue:
    """The meaning of a number that a member of the value's enum names."""
    enum = device.enums[value.enum]
    member = enum.member(number)
    if member is None:
        if enum.open:
            note = sentences.UNLISTED_MEMBER.format(enum=enum.name, number=number)
            return DecodedValue(number, notes=(note,), facts=(enum.place.path,))
        return DecodedValue(number)
    meaning = Meaning(member.name, member.label, member.problem or member.doc, "")
    facts = (enum.place.path, member.place.path)
    return DecodedValue(number, meanings=(meaning,), notes=member_notes(enum, member), facts=facts)


def member_notes(enum: Enum, member: Member) -> tuple[str, ...]:
    """The notes of a value that a member of an enum names."""
    is_refused = member.unavailable and not enum.open
    return (*member.notes, f"{member.name} is listed as not available.") if is_refused else member.notes


def member_list(enum: Enum) -> str:
    """The values of an enum that a codec accepts: `one of 1, 2, 5`."""
    values = (str(member.value) for member in enum.members if not member.unavailable)
    return sentences.PERMITTED_NAMES.format(names=", ".join(values))


def _set_bits(device: Device, word: Flags, number: int) -> Iterator[Meaning]:
    """The bits that are 1, fields of several bits with names, bits that the spec does not list, and states."""
    number &= (1 << 8 * word.type.size) - 1
    unknown = number
    for bit in word.bits:
        number_of_bits = bit.number_in(number)
        unknown &= ~bit.mask
        if shows_bit(bit, number_of_bits):
            yield _bit(device, bit, number_of_bits)
    for index in range(unknown.bit_length()):
        if unknown >> index & 1:
            yield Meaning("", "", sentences.UNLISTED_BIT, str(index))
    yield from (_state(state) for state in word.states if _shows(word, state, number))


def shows_bit(bit: Bit, number: int) -> bool:
    """Whether a number of some bits of a word has a meaning that people see."""
    return bool(number) or (bool(bit.enum or bit.is_number) and not bit.reserved)


def bit_name(device: Device, bit: Bit, number: int) -> str:
    """The name of a number of some bits of a word: `ready`, `state=running` or `level=5`."""
    member = device.enums[bit.enum].member(number) if bit.enum else None
    if member is not None:
        return f"{bit.name}={member.name}"
    return f"{bit.name}={number}" if bit.width > 1 else bit.name


def remark_on_bit_numbers(word: Flags) -> str:
    """How the manual numbers the bits of a word whose bit 0 is the most significant one."""
    text = "Bit 0 is the least significant one here. The manual counts from the most significant"
    return f"{text}: bit {8 * word.type.size - 1} is its bit 0."


def _shows(word: Flags, state: State, number: int) -> bool:
    """Whether the bits of a word show a state."""
    mask, value = word.masked(state)
    return number & mask == value


def _state(state: State) -> Meaning:
    return Meaning(state.name, state.label, state_text(state), "", "state")


def state_text(state: State) -> str:
    """How meanings call a state that several bits show together."""
    return f"state {state.printed_name}".strip()


def _bit(device: Device, bit: Bit, number: int) -> Meaning:
    bits = bit.number_text
    name = bit_name(device, bit, number)
    if bit.enum:
        member = device.enums[bit.enum].member(number)
        if member is not None:
            return Meaning(name, member.label or bit.label, member.doc, bits)
    if bit.width > 1:
        text = ": ".join(part for part in (in_unit(bit.as_value, number), bit.doc) if part)
        return Meaning(name, bit.label, text, bits)
    return Meaning(name, bit.label, bit_text(bit), bits)


def bit_text(bit: Bit) -> str:
    """The meaning of a single bit that is 1."""
    text = bit.one or bit.doc
    if bit.edge:
        text = "; ".join(part for part in (text.removesuffix("."), f"acts at its {bit.edge} edge") if part)
    return text

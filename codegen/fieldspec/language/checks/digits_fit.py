"""The `length` of a number that is sent as digits has room for the digits, and its type holds all numbers that they can
express. A signed hexadecimal number has the digits of its whole type. Reserved fields, selectors, and fields that read
or write registers are not sent as digits; a part of a frame may be any of these, and its digits have no sign. The
digits of a constant do not vary. The digits of a field that measures another one do not vary either, and have neither a
sign nor a point. `padding: space` needs decimal digits of a fixed width with room for a blank. On links with
`transmission: hex_ascii`, where every byte is sent as two characters anyway, digits are a warning.

Why: digits that the type cannot hold would be read as another number, and an output that expects binary numbers would
misread the characters as a number.

Example: `{name: flow, type: u8, digits: decimal, length: 3}`, as 999 does not fit a `u8`.

Fix: Use the next wider type with a `range`, or correct `length`. On a link with `transmission: hex_ascii`, state the
number as a binary one: its bytes become the hexadecimal digits.
"""

from __future__ import annotations

from itertools import chain

from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.checks.facts import layers, values
from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.diagnostics import Severity
from fieldspec.language.model.address_space import BIT
from fieldspec.language.model.device import Device
from fieldspec.language.model.digits import NIBBLES, NO_CHARACTERS, digit_bounds, digit_count, digits_text
from fieldspec.language.model.encoding import MACHINE_BITS, Octets, Real, Sign, Text, Truth, Whole, is_count, is_signed
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.link import Link, Part
from fieldspec.language.model.primitives import Primitive
from fieldspec.language.model.record import Field, Message, RegisterAccess
from fieldspec.language.model.sizes import messages_on
from fieldspec.language.model.value import Value

_MOST_BYTES = 8
"""The bytes of the greatest number in BCD that outputs take apart."""


def digits_fit(device: Device) -> Findings:
    binary_uses = _binary_fields(device)
    for link in device.links.values():
        yield from _sent_twice(device, link)
    for fact, value in values(device):
        if not value.digits:
            if value.places:
                text = f"{fact.name} is not sent as digits, so that no place follows a point"
                yield finding(fact.place, "places", text, "add `digits: decimal`, or use `scale`")
            continue
        yield from _of_form(fact, value)
        yield from _of_padding(fact, value)
        if isinstance(fact, Part):
            yield from _of_part(fact, value)
            continue
        use = binary_uses.get(id(fact)) or _use(fact, value)
        if use:
            text = f"{fact.name} {use}, and is sent {'by a codec' if value.codec else 'as digits'}"
            yield finding(fact.place, "codec" if value.codec else "digits", text, _binary_form(fact))


def _binary_form(fact: Fact) -> str:
    if isinstance(fact, Field) and fact.measures is not None:
        return "state it as a binary number, or remove `measures`, so that programs state it"
    return "state it as a binary number, or as the bytes of its characters"


def _sent_twice(device: Device, link: Link) -> Findings:
    """The first digits on a link that sends every byte as two characters."""
    if link.transmission != "hex_ascii":
        return
    bodies = (body for message in messages_on(device, link) for body in (message.request, message.response))
    facts: chain[Part | Field] = chain(link.request, link.response, *(body.fields for body in bodies))
    for fact in facts:
        digits = fact.digits if isinstance(fact, Part) and fact.value is None else fact.value and fact.value.digits
        if digits and digits not in NO_CHARACTERS:
            text = f"{fact.name} is sent as digits, each of which takes two characters on {link.name}"
            help = "state it as a binary number, whose bytes are hexadecimal digits there, or remove `transmission`"
            related_label = label(link.place, "transmission", "sends every byte as two characters")
            yield finding(fact.place, "digits", text, help, related_label, severity=Severity.WARNING)
            return


def _of_form(fact: Fact, value: Value) -> Findings:
    """The findings of the form of the digits, the first one of each value."""
    kind = value.type
    if isinstance(fact, Part) and (not is_count(kind.encoding) or is_signed(kind.encoding)):
        return  # the type is refused anyway, by `_of_part` or by other rules, and a wider one of its kind would be too
    if value.codec:
        yield from _of_codec(fact, value)
    elif not _has_digits(kind):
        text = f"{fact.name} is {kind.name}, but digits need a whole number of 8, 16, 32 or 64 bits"
        yield finding(fact.place, "digits", text, "use one of u8, i8, u16, i16, u32, i32, u64 and i64")
    elif value.places and value.digits != "decimal":
        text = f"{fact.name} has {value.places} places, which only decimal digits have"
        yield finding(fact.place, "places", text, "remove it, or use `digits: decimal`")
    elif value.digits in NIBBLES and value.size > _MOST_BYTES:
        text = f"{fact.name} is {kind.name} in {value.size} bytes; BCD has at most {_MOST_BYTES} bytes"
        yield finding(fact.place, "digits", text, "state the parts as values of their own")
    elif value.is_low_first and (value.size % 2 or value.width):
        text = f"{fact.name} begins with the digits of its low byte, but has no fixed number of whole bytes"
        yield finding(fact.place, "length", text, "state two digits for each byte, without `varies`")
    elif digit_count(value) <= value.places:
        text = f"{fact.name} has no room for a digit in {value.size} bytes"
        yield finding(fact.place, "length", text, "count the sign, the point and all digits")
    elif is_signed(kind.encoding) and value.digits.endswith("hex") and digit_count(value) != 2 * kind.size:
        text = f"{fact.name} is {kind.name}, which has {2 * kind.size} hexadecimal digits and not {value.size}"
        yield finding(fact.place, "length", text, "use the type with the same number of digits")
    elif value.width and value.const is not None:
        text = f"{fact.name} is a constant, whose digits do not vary"
        yield finding(fact.place, "varies", text, "remove it, and count the digits in `length`")
    elif digit_bounds(value)[1] > kind.high:
        text = f"{fact.name} is {kind.name}, which does not hold {digit_bounds(value)[1]}: {digits_text(value)}"
        yield finding(fact.place, "type", text, _wider(fact, value))


def _of_codec(fact: Fact, value: Value) -> Findings:
    """The finding of a number of a codec that its type does not have, or that has no digits to vary."""
    low, high = digit_bounds(value)
    if not _has_digits(value.type) or low < value.type.low or high > value.type.high:
        text = f"{fact.name} is {value.type.name}, and the codec {value.codec} has whole numbers from {low} to {high}"
        yield finding(fact.place, "type", text, "use one of u8, i8, u16, i16, u32, i32, u64 and i64 that has all")
    elif value.places or value.width:
        text = f"{fact.name} is sent by the codec {value.codec}, which has no digits"
        yield finding(fact.place, "places" if value.places else "varies", text, "remove it, or use `digits`")


def _has_digits(primitive: Primitive) -> bool:
    """Whether numbers of a type may be sent as digits: whole numbers of 8 to 64 bits, in two's
    complement below zero.
    """
    encoding = primitive.encoding
    match encoding:
        case Whole():
            return encoding.bits in MACHINE_BITS and encoding.sign is not Sign.MAGNITUDE
        case Real() | Truth() | Text() | Octets():
            return False
        case _:
            assert_never(encoding)


def _of_padding(fact: Fact, value: Value) -> Findings:
    """The finding of blanks where no leading zeros are, and of zeros, which are there anyway."""
    if isinstance(fact, Part):
        return  # it has no such key, which reading says
    if value.has_blanks and value.places + 1 == digit_count(value):
        text = f"{fact.name} has room for one digit{' before its point' * bool(value.places)}, and for no blank"
        help = "remove it, or count the blanks in `length`"
    elif value.has_blanks or "padding" not in fact.place:
        return  # defaults of a group are those of the rows that they apply to
    elif value.width or value.digits != "decimal":
        form = "varies in width" if value.width else f"is sent as {digits_text(value)}"
        text = f"{fact.name} {form}, and blanks are those before decimal digits of a fixed length"
        help = "remove it"
    else:
        text = f"{fact.name} is sent as decimal digits, which have leading zeros where `padding` is left out"
        help = "remove it, or use `padding: space`"
    yield finding(fact.place, "padding", text, help)


def _wider(fact: Fact, value: Value) -> str:
    """The narrowest type that has all numbers of the digits of a value, if it may have that type."""
    signed = is_signed(value.encoding)
    greatest = 32 if isinstance(fact, Part) and fact.role != "plain" else 64
    wide = (bits for bits in (16, 32, 64) if digit_bounds(value)[1] < 1 << bits - signed)
    bits = next(wide, 0)
    if not 0 < bits <= greatest:
        return "correct `length`: no type holds all numbers with this number of digits"
    return f"use `{'i' if signed else 'u'}{bits}`, with a range"


def _of_part(part: Part, value: Value) -> Findings:
    """The findings of a part of a frame, whose digits have no sign and are bytes of their own."""
    if part.role == "plain" and is_count(value.encoding) and is_signed(value.encoding):
        text = f"the part {part.name} is {value.type.name}, and the digits of a part have no sign"
        yield finding(part.place, "type", text, "use an unsigned type")
    if part.bits is not None:
        text = f"{part.name} is sent as digits, which some bits of a number are not"
        yield finding(part.place, "digits", text, "remove `digits` and `length`")


def _use(fact: Fact, value: Value) -> str:
    """The purpose of a value that outputs read as a binary number; empty for other values."""
    if value.const is not None and value.codec:
        return "is a constant"
    if isinstance(fact, Field) and fact.measures is not None:
        can_count = not (value.codec or value.width or value.places or is_signed(value.type.encoding))
        return "" if can_count else f"contains the size of {fact.measures.field}"
    return "is reserved" if getattr(fact, "reserved", False) else ""


def _binary_fields(device: Device) -> dict[int, str]:
    """The fields that outputs read as binary numbers, by their identity, with what they do."""
    uses: dict[int, str] = {}
    for layer in layers(device):
        for field in layer.fields:
            selector = layer.named(field.choice.by) if field.choice is not None else None
            if selector is not None:
                uses[id(selector)] = f"decides the type of {field.name}"
    for message in device.messages.values():
        for access in message.accesses:
            for field in (*message.request.fields, *message.response.fields):
                if field.name in access.names and not _may_have_digits(device, message, access, field):
                    uses[id(field)] = "is what reads or writes registers"
    return uses


def _may_have_digits(device: Device, message: Message, access: RegisterAccess, field: Field) -> bool:
    """Whether a message with one access may carry its address, its count or its words as characters, but not its bits.

    An address and a count have neither a sign nor a decimal point. `accesses_fit_space` says which characters words
    have.
    """
    value = field.value
    if message.single_access is None or value is None or not value.has_characters:
        return False
    if field.name == access.values:
        return device.space(access.space).unit != BIT
    return not value.places and not is_signed(value.type.encoding)

"""A value has only keys that apply to its type. Enums, bits and constants apply to whole numbers, and a truth value has
neither constant nor unit; its enum names 0 and 1, or is `open`. Numbers with names have no scale, and a bit field has
no enum, scale, unit or sign: its bits have them. A floating-point number has no scale. Texts and bytes have no range or
scale, bytes have no byte order, and only UTF-16 has `byte_order: big`. Only a number of several bytes has a byte order,
only a number of several words has a word order, and only a text, bytes and digits have a `length`.

Why: a key that no output can apply must not look as if it had an effect. A reader would rely on a limit or a name that
no codec applies.

Example: `enum: mode` on an `f32`, or `byte_order: little` on `bytes` or on a `u8`.

Fix: Remove the key, or correct the type.
"""

from __future__ import annotations

from functools import partial

from fieldspec.foundation.exhaustive import assert_never
from fieldspec.foundation.line_text import plural
from fieldspec.language.checks.finding import Findings, finding, range_key
from fieldspec.language.checks.settled import of_values
from fieldspec.language.model.address_space import BIT
from fieldspec.language.model.checksums import checksum_named
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import (
    Digits,
    Encoding,
    Octets,
    Real,
    Text,
    Truth,
    Whole,
    is_count,
    is_signed,
    is_truth,
)
from fieldspec.language.model.enums import Enum
from fieldspec.language.model.fact import Fact, Place
from fieldspec.language.model.link import Part
from fieldspec.language.model.value import Value

_NAMED = ("enum", "flags", "const")
_SCALED = ("scale", "offset")
_NONE_OF_ARRAYS = (*_NAMED, *_SCALED, "byte_order", "word_order", "write_word_order", "range", "sentinels", "unit")
_OF_BITS = ("const", "byte_order", "range", "unit")
_INTEGER_HELP = "remove it, or use an integer type"


def _unfit(encoding: Encoding) -> tuple[tuple[str, ...], str]:
    """The keys that do not apply to an encoding, and what to do about them."""
    match encoding:
        case Whole() | Digits():
            return (), _INTEGER_HELP
        case Real():
            return (*_NAMED, *_SCALED), _INTEGER_HELP
        case Truth():
            return ("flags", "const", *_SCALED, "sentinels", "unit"), _INTEGER_HELP
        case Text():
            help = "remove it; a text has no range or scale, and its bytes come in order but for `byte_order: little`"
            return _NONE_OF_ARRAYS, help
        case Octets():
            return _NONE_OF_ARRAYS, "remove it; text and bytes have no byte order, range or scale"
        case _:
            assert_never(encoding)


def keys_fit_type(device: Device) -> Findings:
    yield from of_values(device, partial(_of_value, device))
    yield from _ordered_checksums(device)


def _of_value(device: Device, fact: Fact, value: Value) -> Findings:
    unfit_keys, help = _unfit(value.encoding)
    bit_keys = _OF_BITS if value.type.name == BIT else ()
    for key in dict.fromkeys((*unfit_keys, *bit_keys)):
        if _has(value, key) and not (key == "byte_order" and value.has_order):
            text = f"{fact.name} is {value.type.name}, to which `{_key(fact.place, key)}` does not apply"
            yield finding(fact.place, _key(fact.place, key), text, help)
    if is_count(value.encoding):
        yield from _of_names(fact, value)
    if is_truth(value.encoding) and value.enum:
        yield from _of_truths(device.enums.get(value.enum), fact, value)
    if value.type.is_number and not value.digits and "length" in fact.place and "codec" not in fact.place:
        text = f"{fact.name} is {value.type.name}, whose size is fixed, so that `length` does not apply"
        yield finding(fact.place, "length", text, "remove it, or say how its `digits` are sent")
    if value.is_as_sent and value.byte_order and not (value.is_low_first and not isinstance(fact, Part)):
        manner = "as characters, the most significant digit first," if value.has_characters else "by a codec"
        text = f"{fact.name} is sent {manner} and has no byte order"
        yield finding(fact.place, "byte_order", text, "remove it, or use `digits: bcd`")
    elif (
        value.size == 1
        and not value.has_order
        and value.type.is_number
        and "byte_order" in fact.place
        and value.type.name != BIT
    ):
        text = f"{fact.name} is {value.type.name} in one byte, which has no byte order"
        yield finding(fact.place, "byte_order", text, "remove it, or correct the type")
    for key in ("word_order", "write_word_order"):
        if value.type.is_number and _has(value, key) and not value.has_words:
            text = f"{fact.name} is {value.type.name}, which does not consist of several words of 16 bits"
            yield finding(fact.place, key, text, "remove it, or correct the type")
    if is_count(value.encoding) and value.absent_nan:
        text = f"{fact.name} is {value.type.name}, but a special value has `bits` only in an f16, f32 or f64"
        yield finding(fact.place, "sentinels", text, "state the raw value under `value`")
    spread = next((sentinel for sentinel in value.sentinels if sentinel.last is not None), None)
    if spread is not None and not is_count(value.encoding):
        text = f"{fact.name} is {value.type.name}, but {spread.name} has a `range`, which only whole numbers have"
        yield finding(fact.place, "sentinels", text, "state each number under `value`")


def _of_names(fact: Fact, value: Value) -> Findings:
    """The keys that a number with an enum or a bit field cannot have."""
    keys = ("enum", *_SCALED, "unit") if value.flags else _SCALED if value.enum else ()
    names = "is a word of bits" if value.flags else f"has the names of {value.enum}"
    fix = (
        "state it at the bits that it concerns"
        if value.flags
        else "remove it; list a number with a special meaning under `sentinels`"
    )
    for key in keys:
        if _has(value, key):
            text = f"{fact.name} {names}, to which `{key}` does not apply"
            yield finding(fact.place, key, text, fix)
    if value.flags and is_signed(value.encoding):
        text = f"{fact.name} is {value.type.name}, and a word of bits has no sign"
        help = f"use u{value.type.name[1:]}; several adjacent bits can be `signed`"
        yield finding(fact.place, "type", text, help)


def _of_truths(enum: Enum | None, fact: Fact, value: Value) -> Findings:
    """The truth value that a closed enum lacks, although readers accept both truth values."""
    if enum is None or enum.open:
        return
    available = {member.value for member in enum.members if not member.unavailable}
    missing = [str(number) for number in (0, 1) if number not in available]
    if missing:
        text = f"{fact.name} is {value.type.name}, and {enum.name} does not list {' and '.join(missing)}"
        help = "list both values as available, or make the enum `open`"
        yield finding(fact.place, "enum", text, help)


def _ordered_checksums(device: Device) -> Findings:
    """The checksums of one byte with a byte order, which do not combine wider numbers."""
    for part in (part for link in device.links.values() for part in (*link.request, *link.response)):
        if part.role != "checksum" or "byte_order" not in part.place or part.digits:
            continue
        kind = checksum_named(part.algorithm)
        if not kind.has_order:
            text = f"{part.name} is a checksum of {plural(kind.width, 'bit')}, which has no byte order"
            yield finding(part.place, "byte_order", text, "remove it, or correct the checksum")


def _key(place: Place, key: str) -> str:
    return range_key(place) if key == "range" else key


def _has(value: Value, key: str) -> bool:
    values = {
        "enum": value.enum,
        "flags": value.flags,
        "const": value.const is not None,
        "scale": value.scale != 1,
        "offset": value.offset,
        "byte_order": value.byte_order,
        "word_order": value.word_order,
        "write_word_order": value.write_word_order,
        "range": value.ranges is not None,
        "sentinels": value.sentinels,
        "unit": value.quantity_unit,
    }
    return bool(values[key])

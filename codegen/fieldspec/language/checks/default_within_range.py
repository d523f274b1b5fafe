"""A default is a value that the fact can have: a text for a text, and a number within the range, the type and the
closed enum for any other value. Bytes have no default.

Why: the factory setting of a device is a setting that it accepts. If the two disagree, one of them is misprinted.

Example: a range of 1..127 with a default of -1.

Fix: Correct the range or the default, and write an erratum. If the default outside the range represents a state, list
it under `sentinels`.
"""

from __future__ import annotations

import re
from functools import partial

from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.checks.finding import Findings, default_key, finding, label, range_key
from fieldspec.language.checks.numbers import Legal
from fieldspec.language.checks.settled import of_values, of_words
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import Digits, Octets, Real, Text, Truth, Whole, is_real
from fieldspec.language.model.enums import Flags
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.value import Value

_DECIMAL = re.compile(r"-?\d+\.\d+")


def default_within_range(device: Device) -> Findings:
    legal = Legal(device)
    yield from of_values(device, partial(_of_value, device, legal))
    yield from of_words(device, partial(_of_word, legal))


def _of_word(legal: Legal, word: Flags) -> Findings:
    for bit in word.bits:
        reason = "" if bit.default is None else legal.objection(bit.as_value, bit.default)
        if reason:
            text = f"the default of {bit.name} is {bit.default}, which {reason}"
            labels = (label(bit.place, range_key(bit.place), "the range"),) if bit.ranges else ()
            yield finding(bit.place, default_key(bit.place), text, "correct one of them", *labels)


def _of_value(device: Device, legal: Legal, fact: Fact, value: Value) -> Findings:
    if value.default is None:
        return
    key = default_key(fact.place)
    wrong = _wrong_form(device, value, value.default)
    if wrong:
        text, help = wrong
        yield finding(fact.place, key, f"the default of {fact.name} is {text}", help)
        return
    reason = _outside(value, value.default) if isinstance(value.default, str) else legal.objection(value, value.default)
    if reason:
        text = f"the default of {fact.name} is {value.default}, which {reason}"
        help = "correct one of them, or list the value under `sentinels`"
        labels = (label(fact.place, range_key(fact.place), "the range"),) if value.ranges else ()
        yield finding(fact.place, key, text, help, *labels)


def _wrong_form(device: Device, value: Value, default: int | str) -> tuple[str, str] | None:
    """The fault of a default that the type cannot have, and its fix; None where it has the form of the value."""
    encoding = value.encoding
    match encoding:
        case Octets():
            return "that of bytes, which no output has", "remove it, and say it in `notes`"
        case Text():
            return None if isinstance(default, str) else ("a number", f'write the text in quotes: "{default}"')
        case Real():
            if isinstance(default, str) and not _DECIMAL.fullmatch(default):
                return f"`{default}`, but its values are numbers", "state it as a raw value"
            return None
        case Whole() | Digits() | Truth():
            return _wrong_count(device, value, default) if isinstance(default, str) else None
        case _:
            assert_never(encoding)


def _wrong_count(device: Device, value: Value, default: str) -> tuple[str, str]:
    """The fault of a text default of a whole number, and its fix."""
    help = "state the raw value: the value in the unit, less the offset, divided by the scale"
    if default.isdecimal():
        help = f"numbers have no leading zeros: write it as `{default.lstrip('0') or '0'}`"
    enum = device.enums.get(value.enum)
    member = enum.named(default) if enum is not None else None
    if member is not None:
        help = f"write the number of {default}: `{member.value}`"
    return f"`{default}`, but its raw values are whole numbers", help


def _outside(value: Value, default: str) -> str:
    """Why a floating-point value cannot be a number with a fraction, or an empty text."""
    if not is_real(value.encoding) or value.ranges is None or float(default) in value.ranges:
        return ""
    return f"is outside {value.ranges.text()}"

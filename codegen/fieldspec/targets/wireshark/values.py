"""Values, enums and words of bits as data of the dissector."""

from __future__ import annotations

from collections.abc import Sequence
from decimal import Decimal
from fractions import Fraction
from math import lcm

from fieldspec.codec.explain.errata import errata_at, errata_of_words
from fieldspec.language.model.device import Device
from fieldspec.language.model.digits import BCD, has_sign
from fieldspec.language.model.encoding import is_array, is_count, is_exact, is_signed
from fieldspec.language.model.enums import Enum, Flags
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.ranges import Ranges
from fieldspec.language.model.value import Value
from fieldspec.targets import runtime_values
from fieldspec.targets.fact_texts import sentence
from fieldspec.targets.wireshark.filters import title_of
from fieldspec.targets.wireshark.text import Data, line_text

_TEXTS = ("alarm", "error", "exception", "fault", "warning")
"""The kinds of enums whose members have texts that people look up."""

_MOST_PLACES = 6
"""The decimals that a quantity has even if they are zeros."""


def value_data(value: Value, order: str, swapped: bool, digits: Sequence[bytes] | None = None) -> dict[str, Data]:
    """A value with its byte and word order, and with the patterns of digits that are shown as bytes."""
    encoding, wide = value.encoding, is_wide(value)
    data: dict[str, Data] = {
        "kind": runtime_values.kind_of(encoding),
        "size": value.size,
        "order": order,
        "swapped": swapped,
        "signed": is_count(encoding) and runtime_values.sign_data(encoding),
        "unit": line_text(value.unit) or None,
    }
    if is_array(encoding):
        return data | {"digits": digits}
    if is_exact(encoding) and not wide:
        data |= {"low": value.type.low, "high": value.type.high}
    data |= {
        "enum": value.enum or None,
        "word": value.flags or None,
        "const": None if value.const is None else bound(value.const, wide),
        "ranges": intervals(value.ranges, wide),
        "write_ranges": intervals(value.write_ranges, wide),
        "special": {
            "NaN" if sentinel.is_nan else str(sentinel.value): sentinel.name
            for sentinel in value.sentinels
            if sentinel.last is None
        }
        or None,
        "special_ranges": [
            {"range": intervals(Ranges((sentinel.interval,)), wide), "name": sentinel.name}
            for sentinel in value.sentinels
            if sentinel.last is not None
        ]
        or None,
    }
    if is_count(encoding) and value.scaled:
        data["scale"] = scale_data(value.scale, value.offset)
    return data


def digit_patterns(value: Value) -> list[bytes]:
    """Patterns of Lua, one of which bytes match if they are the digits of a value.

    There are none for values without digits, for digits that vary, and for a sign in a nibble.
    """
    signed = is_signed(value.type.encoding)
    if value.digits == BCD and not signed:
        return [b"^[%b]+$" % b"".join(b"%c-%c" % (tens, tens + 9) for tens in range(0, 0xA0, 16))]
    if not value.has_characters or value.width:
        return []
    fraction = f"%.{'%d' * value.places}$" if value.places else "$"
    if value.has_blanks:
        sign = "%-?" if signed else ""
        return [f"^ *{sign}{whole}{fraction}".encode() for whole in ("0", "[1-9]%d*")]
    digit = {"upper_hex": "[%dA-F]", "lower_hex": "[%da-f]"}.get(value.digits, "%d")
    return [f"^{'[+-]' * has_sign(value)}{digit}+{fraction}".encode()]


def scale_data(scale: Decimal | Fraction, offset: Decimal | Fraction) -> dict[str, Data]:
    """quantity = (count * factor + shift) / divisor, in whole numbers, with at least `places` decimals."""
    divisor = lcm(Fraction(scale).denominator, Fraction(offset).denominator)
    places = max(_places(scale), _places(offset))
    return {
        "factor": int(Fraction(scale) * divisor),
        "shift": int(Fraction(offset) * divisor),
        "divisor": divisor,
        "places": places if places <= _MOST_PLACES else 0,
    }


def _places(number: Decimal | Fraction) -> int:
    if not isinstance(number, Decimal):
        return 0
    exponent = number.as_tuple().exponent
    return max(0, -exponent) if isinstance(exponent, int) else 0


def is_wide(value: Value | None) -> bool:
    """Whether a value is a whole number that a double cannot hold."""
    return value is not None and runtime_values.is_wide(value.encoding)


def bound(number: int, wide: bool) -> int | str:
    """A number; one of more than six bytes as 16 hexadecimal digits, which a double cannot hold."""
    return f"{number & (1 << 64) - 1:016x}" if wide else number


def code_data(code: int | None) -> int | str | None:
    """A code or a subcode; one of more than six bytes as a text, whatever part it is sent in."""
    return None if code is None else bound(code, code >> runtime_values.WIDEST_DOUBLE > 0)


def intervals(ranges: Ranges | None, wide: bool = False) -> Data:
    """Ranges as pairs; None where there are none."""
    return None if ranges is None else [[bound(low, wide), bound(high, wide)] for low, high in ranges.intervals]


def enum_data(device: Device, enum: Enum) -> dict[str, Data]:
    """An enum: the names of its numbers, their texts and errata, and the numbers that must not be sent."""
    texts: dict[str, Data] = {}
    errata: dict[str, Data] = {}
    for member in enum.members:
        text = member.problem or (member.doc if enum.kind in _TEXTS else "")
        if text:
            texts[str(member.value)] = line_text(sentence(text))
        ids = errata_of_words(device, (member.place.path,))
        if ids:
            errata[str(member.value)] = list(ids)
    return {
        "open": enum.open,
        "names": {member.value: member.name for member in reversed(enum.members)},
        "unavailable": {member.value: True for member in enum.members if member.unavailable},
        "texts": texts,
        "errata": errata,
    }


def word_data(device: Device, flags: Flags) -> list[Data]:
    """The bits of a word, lowest first."""
    return [
        {
            "name": bit.name,
            "title": title_of(bit),
            "first": bit.first,
            "width": bit.width,
            "runs": [[run.first, run.width] for run in bit.runs] if bit.pieces else None,
            "place": bit.number_text if bit.pieces else None,
            "zero": line_text(bit.zero) or None,
            "one": line_text(bit.one) or None,
            "enum": bit.enum or None,
            "signed": bit.signed,
            "ranges": intervals(bit.ranges, bit.width > 32) if bit.is_bounded else None,
            "unit": line_text(bit.unit) or None,
            "scale": scale_data(bit.scale, bit.offset) if bit.scale != 1 or bit.offset != 0 else None,
            "errata": list(errata_at(device, bit.place.path)) or None,
        }
        for bit in flags.bits
    ]


def errata_data(device: Device, fact: Fact) -> Data:
    """The ids of the errata of a fact; None without."""
    return list(errata_at(device, fact.place.path)) or None

"""Converts values as people write them to raw values: counts, quantities, enum members, bits, lists."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from decimal import Context, Decimal
from math import ceil, floor

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.needed_bits import needed_bits
from fieldspec.codec.layout.part import PartLayout
from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.foundation.classes import TYPE_CHECKING
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import (
    Digits,
    Octets,
    Precision,
    Real,
    Text,
    Truth,
    Whole,
    real_bits,
    real_number,
)
from fieldspec.language.model.quantity import count_of, number_of, point_text
from fieldspec.language.model.texts import Example
from fieldspec.language.model.value import Sentinel, Value

if TYPE_CHECKING:
    from fractions import Fraction
    from typing import Any, TypeAlias


Raw: TypeAlias = int | float | str | bytes | list["Raw"] | dict[str, "Raw"]


_EXACT = Context(prec=200)
_INFINITIES = ("inf", "-inf")
_DIGITS = re.compile("[-+]?(?:0x[0-9A-Fa-f]+|[1-9][0-9]*)")


class MeaningError(ValueError):
    """A value that has no raw value. `path` names it by field names joined by dots; `detail` says why."""

    def __init__(self, path: str, detail: str) -> None:
        super().__init__(f"{path}: {detail}")
        self.path, self.detail = path, detail


def body_of(layout: DeviceLayout, link: str, direction: str, message: str, error: bool) -> RecordLayout:
    """The record in the body of a frame. `error` selects the exception response."""
    exception_response = layout.links[link].link.exception_response
    if error and exception_response is not None:
        return layout.records[exception_response.record]
    return layout.messages[message].data(direction)


def raw_values(layout: DeviceLayout, example: Example) -> dict[str, Raw]:
    """The raw values of an example by name: the parts of its header, and the fields of its body.

    Raises MeaningError for a value that has no raw value.
    """
    parts = layout.links[example.link].frame(example.direction).header
    body: RecordLayout | None = None
    if example.message or example.exception_response:
        body = body_of(layout, example.link, example.direction, example.message, example.exception_response)
    return raw_of(layout.device, parts, body, example.values)


def raw_of(
    device: Device,
    parts: Iterable[PartLayout],
    body: RecordLayout | None,
    entered: Mapping[str, object],
) -> dict[str, Raw]:
    """The raw values, by name, of values that are entered for parts of a header and fields of a record.

    Raises MeaningError for a name that neither has, and for a value that has no raw value.
    """
    known_parts = {part.name: part for part in parts}
    known_fields = _decided(device, "", body, entered) if body is not None else {}
    raw: dict[str, Raw] = {}
    for name, value in entered.items():
        if name in known_parts:
            raw[name] = _raw_number(device, name, known_parts[name].value, value)
        elif name in known_fields:
            raw[name] = _field(device, name, known_fields[name], value)
        else:
            known_names = ", ".join([*known_parts, *known_fields])
            raise MeaningError(name, f"there is no such field; the fields are {known_names}")
    return raw


def _decided(device: Device, before: str, body: RecordLayout, entered: Mapping[str, object]) -> dict[str, FieldLayout]:
    """The fields of a record by name, with the types that the entered values of selectors decide."""
    numbers: dict[str, Raw] = {}
    for field in body.fields:
        selector = field.selector or (body.selector if field.cases else None)
        if selector is None or (field.forms and field.name not in entered):
            continue
        path = before + selector.name
        if selector.name in entered:
            numbers[selector.name] = _field(device, path, selector, entered[selector.name])
        elif selector.value is None or selector.value.const is None or not field.forms:
            raise MeaningError(path, f"is needed: it decides what {field.name} holds")
        if body.decided_by(numbers).fields[body.fields.index(field)].cases:
            raise MeaningError(path, f"`{entered.get(selector.name)}` leaves open what {field.name} holds")
    return {field.name: field for field in body.decided_by(numbers).fields}


def _field(device: Device, path: str, field: FieldLayout, entered: object) -> Raw:
    if not field.is_list:
        return _element_value(device, path, field, entered)
    if isinstance(entered, str) and field.record is None:
        entered = pieces(path, entered)
    if not isinstance(entered, list):
        raise MeaningError(path, "a list is expected")
    return [_element_value(device, f"{path}.{number}", field, item) for number, item in enumerate(entered)]


def pieces(path: str, text: str) -> list[str]:
    """The items of `1, 2,3` or `1 2 3`. Raises MeaningError where one is missing, as in `1,,3`: others would move."""
    text = text.strip(" ")
    items = re.split(r" *, *| +", text) if text else []
    if "" in items:
        raise MeaningError(path, f"`{text}` has a comma without a value")
    return items


def _element_value(device: Device, path: str, field: FieldLayout, entered: object) -> Raw:
    if field.record is None:
        return _raw_number(device, path, field.value, entered)
    entered = {} if entered == "" else entered  # as the command line has a record of constants
    if not isinstance(entered, dict):
        raise MeaningError(path, "a mapping of fields is expected")
    inner: dict[str, Raw] = {}
    known_fields = _decided(device, f"{path}.", field.record, entered)
    for name, value in entered.items():
        field_of = known_fields.get(name)
        if field_of is None:
            raise MeaningError(f"{path}.{name}", "there is no such field")
        inner[name] = _field(device, f"{path}.{name}", field_of, value)
    return inner


def raw_value(device: Device, path: str, value: Value, entered: object) -> Raw:
    """The raw value of an entered value. Raises MeaningError, which calls the value `path`."""
    return _raw_number(device, path, value, entered)


def _raw_number(device: Device, path: str, value: Value | None, entered: Any) -> Raw:
    """The raw value for a value that a person enters."""
    assert value is not None
    if isinstance(entered, dict) and value.flags:
        entered = [f"{name}={int(own) if isinstance(own, bool) else own}" for name, own in entered.items()]
    if isinstance(entered, dict) or (isinstance(entered, list) and not value.flags):
        raise MeaningError(path, "one value is expected, and neither members nor a list")
    if value.flags and isinstance(entered, list | str) and not _is_count(entered):
        return _word(device, path, value, entered)
    encoding = value.encoding
    match encoding:
        case Truth():
            if str(entered).lower() in ("true", "false", "1", "0"):
                return str(entered).lower() in ("true", "1")
            return _raw_count(device, path, value, entered)
        case Text():
            return str(entered)
        case Octets():
            try:
                return bytes.fromhex(str(entered))
            except ValueError:
                raise MeaningError(path, "bytes are written as pairs of hexadecimal digits") from None
        case Real():
            return _raw_real(device, path, value, encoding.precision, entered)
        case Whole() | Digits():
            return _raw_count(device, path, value, entered)
        case _:
            assert_never(encoding)


def _raw_real(device: Device, path: str, value: Value, precision: Precision, entered: Any) -> float:
    """The floating-point number for a number, a special value, or a quantity."""
    special = next((sentinel for sentinel in value.sentinels if sentinel.name == entered), None)
    if special is not None:
        return number_of_sentinel(value, special)
    quantity = device.entered_quantity(value, entered)
    if quantity is not None:
        return _present(path, value, precision, str(entered), float(quantity))
    if entered in _INFINITIES:
        return float(entered)
    number = entered if isinstance(entered, float) else number_of(str(entered))
    if number is None:
        raise MeaningError(path, f"`{entered}` is not a number; write it as `0.5` or `2.5e-3`")
    return number


def _raw_count(device: Device, path: str, value: Value, entered: Any) -> int:
    """The count for a count, a member, a special value, or a quantity."""
    if isinstance(entered, int) and not isinstance(entered, bool):
        return entered
    if isinstance(entered, float | Decimal) and value.scaled and not value.unit:
        entered = point_text(entered)
    if isinstance(entered, str):
        return _raw_of_text(device, path, value, entered)
    unit = "; with its unit it may be a fraction" if value.unit else ""
    raise MeaningError(path, f"`{entered}` is not a whole number of counts{unit}")


def number_of_sentinel(value: Value, sentinel: Sentinel) -> int | float:
    """The raw value of a sentinel: a count, or a floating-point number; that of a NaN has its bits."""
    encoding = value.encoding
    match encoding:
        case Real():
            return real_number(encoding.precision, sentinel.value) if sentinel.is_nan else float(sentinel.value)
        case Whole() | Digits() | Truth() | Text() | Octets():
            return sentinel.value
        case _:
            assert_never(encoding)


def _present(path: str, value: Value, precision: Precision, entered: str, number: float) -> float:
    """A quantity as a number of a precision. Raises MeaningError for one that would be sent as a sentinel."""
    try:
        sent_number = real_number(precision, real_bits(precision, number))
    except OverflowError:
        return number
    absent = value.sentinel(sent_number)
    if absent is not None:
        raise MeaningError(path, f"`{entered}` would be sent as {sent_number!r}, {_sentinel_help(absent)}")
    return number


def _sentinel_help(absent: Sentinel) -> str:
    return f"which stands for {absent.name}; write `{absent.name}` if you mean that"


def _nearest_text(value: Value, quantity: Fraction) -> str:
    """The quantities of the counts beside one that has none; these counts, where they are not decimal numbers."""
    from fractions import Fraction

    count = (quantity - Fraction(value.offset)) / Fraction(value.scale)
    if not isinstance(value.scale, Decimal):
        return f"; the nearest counts are {floor(count)} and {ceil(count)}"
    quantities = sorted(value.in_unit(whole).normalize(_EXACT) for whole in (floor(count), ceil(count)))
    below, above = (f"{neighbour:f}{value.unit}" if value.unit else point_text(neighbour) for neighbour in quantities)
    offset = f"; it has the offset {value.offset:f} {value.unit}".rstrip() if value.offset else ""
    return f"; the nearest ones are {below} and {above}{offset}"


def _example(value: Value) -> str:
    """The hint that a scaled number needs a decimal point; empty for a value without a scale."""
    return ", or the scaled number with a decimal point, such as 2.0" if value.scaled else ""


def _is_count(entered: object) -> bool:
    return isinstance(entered, str) and count_of(entered) is not None


def _raw_of_text(device: Device, path: str, value: Value, entered: str) -> int:
    """The raw value of a count, a member's name, a sentinel's name, or a quantity with its unit."""
    count = count_of(entered)
    if count is not None:
        return count
    if value.enum:
        member = device.enums[value.enum].named(entered)
        if member is not None:
            return member.value
    for sentinel in value.sentinels:
        if sentinel.name == entered:
            return sentinel.value
    quantity = device.entered_quantity(value, entered)
    if quantity is not None:
        raw = value.from_unit(quantity)
        if raw is None:
            text = f"`{entered}` is not a whole number of counts of {value.scale_number} {value.unit}".rstrip()
            raise MeaningError(path, f"{text}{_nearest_text(value, quantity)}")
        absent = value.sentinel(raw)
        if absent is not None:
            raise MeaningError(path, f"`{entered}` would be the count {raw}, {_sentinel_help(absent)}")
        return raw
    if value.enum:
        from difflib import get_close_matches

        names = [member.name for member in device.enums[value.enum].members]
        close = get_close_matches(entered, names, 1)
        known = f"did you mean {close[0]}?" if close else f"it has {', '.join(names)}"
        raise MeaningError(path, f"`{entered}` is not a member of {value.enum}; {known}")
    if value.scale_by:
        raise MeaningError(path, f"`{entered}` is not a count; its scale is in {value.scale_by}, so give a count")
    if _DIGITS.fullmatch(entered):
        raise MeaningError(path, f"`{entered}` has more than 64 bits, and no value has")
    unit = f", or with its unit {value.unit}" if value.unit else _example(value)
    raise MeaningError(path, f"`{entered}` is not a number; give a count{unit}")


def _word(device: Device, path: str, value: Value, entered: list[object] | str) -> int:
    """The word with the named bits set. `name=member` or `name=number` sets a field of several bits.

    Fields that are not named have their defaults, else 0. Raises MeaningError where 0 would mean something.
    """
    special = next((sentinel for sentinel in value.sentinels if sentinel.name == entered), None)
    if special is not None:
        return special.value
    flags = device.flags[value.flags]
    word, names = flags.initial, set()
    for item in entered if isinstance(entered, list) else [piece for piece in re.split(r"[, ]+", entered) if piece]:
        name, _, setting = str(item).partition("=")
        bit = flags.named(name)
        if bit is None:
            known = ", ".join(other.name for other in flags.bits if not other.reserved)
            raise MeaningError(path, f"`{name}` is not a bit of {value.flags}: {known}")
        if name in names:
            raise MeaningError(path, f"`{name}` has two values")
        names.add(name)
        number = 1
        if setting:
            number = _raw_of_text(device, f"{path}.{name}", bit.as_value, setting)
        if not bit.low <= number <= bit.high:
            raise MeaningError(path, f"{number} does not fit the {bit.width} bits of {name}")
        word = word & ~bit.mask | bit.placed(number)
    missing = next(
        (required for required in needed_bits(flags, device.enums) if names.isdisjoint(required.names)), None
    )
    if missing is not None:
        own = missing.bit.name
        raise MeaningError(path, f"`{own}` is not given, and its {missing.reason}; give `{own}=`, or the whole word")
    return word

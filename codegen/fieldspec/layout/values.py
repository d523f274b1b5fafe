"""Values as people write them, converted to raw values: counts, quantities, enum members, lists."""

from __future__ import annotations

import re
import struct
from collections.abc import Iterable, Mapping
from decimal import Decimal

from fieldspec.classes import TYPE_CHECKING
from fieldspec.layout.device import DeviceLayout
from fieldspec.layout.frame import PartLayout
from fieldspec.layout.record import FieldLayout, RecordLayout
from fieldspec.model.device import Device
from fieldspec.model.texts import Example
from fieldspec.model.value import Kind, Value

if TYPE_CHECKING:
    from typing import Any, TypeAlias


Raw: TypeAlias = int | float | str | bytes | list["Raw"] | dict[str, "Raw"]

_IN_UNIT = r"([-+]?[0-9]{1,30}(?:\.[0-9]{1,30})?)(?: (?=.)|(?=[^0-9 ]))(.*)"
_COUNT = r"[-+]?(0x[0-9A-Fa-f]{1,16}|0|[1-9][0-9]{0,19})"


class MeaningError(ValueError):
    """A written value that cannot be understood. `path` says which: field names joined by dots."""

    def __init__(self, path: str, detail: str) -> None:
        super().__init__(f"{path}: {detail}")
        self.path, self.detail = path, detail


def body_of(layout: DeviceLayout, link: str, direction: str, message: str, error: bool) -> RecordLayout:
    """The record in the body of a frame."""
    refusal = layout.links[link].link.exception_response
    if error and refusal is not None:
        return layout.records[refusal.record]
    return layout.messages[message].data(direction)


def raw_values(layout: DeviceLayout, example: Example) -> dict[str, Raw]:
    """The raw values of an example: those of the parts before the body, and of the body's fields.

    Raises MeaningError.
    """
    parts = layout.links[example.link].frame(example.direction).head
    body: RecordLayout | None = None
    if example.message or example.exception_response:
        body = body_of(layout, example.link, example.direction, example.message, example.exception_response)
    return raw_of(layout.device, parts, body, example.values)


def raw_of(
    device: Device,
    parts: Iterable[PartLayout],
    body: RecordLayout | None,
    written: Mapping[str, object],
) -> dict[str, Raw]:
    """Raw values by name, of the parts of a head and the fields of a record, from what is written.

    Raises MeaningError for a name that neither has, and for a value that cannot be understood.
    """
    fields = _decided(device, body, written).fields if body is not None else ()
    known_parts = {part.name: part for part in parts}
    known_fields = {field.name: field for field in fields}
    raw: dict[str, Raw] = {}
    for name, held in written.items():
        if name in known_parts:
            raw[name] = _number(device, name, known_parts[name].value, held)
        elif name in known_fields:
            raw[name] = _field(device, name, known_fields[name], held)
        else:
            have = ", ".join([*known_parts, *known_fields])
            raise MeaningError(name, f"there is no such field; there are {have}")
    return raw


def _decided(device: Device, body: RecordLayout, written: Mapping[str, object]) -> RecordLayout:
    """The record itself, or the one that the written value of its selector chooses."""
    by = body.selector
    if by is None:
        return body
    if by.name not in written:
        raise MeaningError(by.name, f"is needed: it decides what {body.fields[-1].name} holds")
    chosen = body.of_number(_field(device, by.name, by, written[by.name]))
    if chosen is None:
        raise MeaningError(by.name, f"`{written[by.name]}` leaves open what {body.fields[-1].name} holds")
    return chosen


def _field(device: Device, path: str, field: FieldLayout, held: object) -> Raw:
    if not field.is_list:
        return _element_value(device, path, field, held)
    if isinstance(held, str) and field.record is None:
        held = [piece for piece in re.split(r"[, ]+", held) if piece]
    if not isinstance(held, list):
        raise MeaningError(path, "a list is expected")
    return [_element_value(device, f"{path}.{number}", field, item) for number, item in enumerate(held)]


def _element_value(device: Device, path: str, field: FieldLayout, held: object) -> Raw:
    if field.record is None:
        return _number(device, path, field.value, held)
    if not isinstance(held, dict):
        raise MeaningError(path, "a mapping of fields is expected")
    inner: dict[str, Raw] = {}
    for name, value in held.items():
        field_of = field.record.named(name)
        if field_of is None:
            raise MeaningError(f"{path}.{name}", "there is no such field")
        inner[name] = _field(device, f"{path}.{name}", field_of, value)
    return inner


def raw_value(device: Device, path: str, value: Value, held: object) -> Raw:
    """One written value as a raw one. Raises MeaningError; `path` is what it calls the value."""
    return _number(device, path, value, held)


def _number(device: Device, path: str, value: Value | None, held: Any) -> Raw:
    """One written value as a raw one."""
    assert value is not None
    if value.flags and isinstance(held, list | str) and not _is_count(held):
        return _word(device, path, value, held)
    if value.type.kind is Kind.BOOLEAN and str(held).lower() in ("true", "false", "1", "0"):
        return str(held).lower() in ("true", "1")
    if value.type.kind is Kind.TEXT:
        return str(held)
    if value.type.kind is Kind.BYTES:
        try:
            return bytes.fromhex(str(held))
        except ValueError:
            raise MeaningError(path, "bytes are written as pairs of hexadecimal digits") from None
    if value.type.kind is Kind.FLOAT:
        named = next((sentinel for sentinel in value.sentinels if sentinel.name == held), None)
        if named is not None:
            return struct.unpack(">f", named.value.to_bytes(4, "big"))[0] if named.is_nan else float(named.value)
        try:
            return float(held)
        except (TypeError, ValueError):
            raise MeaningError(path, f"`{held}` is no number") from None
    if isinstance(held, int) and not isinstance(held, bool):
        return held
    if isinstance(held, str):
        return _text(device, path, value, held)
    raise MeaningError(path, f"`{held}` is no whole number of counts; with its unit it may be a fraction")


def _is_count(held: object) -> bool:
    return isinstance(held, str) and re.fullmatch(_COUNT, held) is not None


def _text(device: Device, path: str, value: Value, held: str) -> int:
    """A count, a member's name, a sentinel's name, or a quantity with its unit."""
    if re.fullmatch(_COUNT, held):
        return int(held, 0)
    if value.enum:
        member = device.enums[value.enum].named(held)
        if member is not None:
            return member.value
    for sentinel in value.sentinels:
        if sentinel.name == held:
            return sentinel.value
    match = re.fullmatch(_IN_UNIT, held)
    if match and match[2] == value.unit:
        raw = value.from_unit(Decimal(match[1]))
        if raw is None:
            raise MeaningError(path, f"`{held}` is no whole number of counts of {value.scale} {value.unit}")
        absent = value.sentinel(raw)
        if absent is not None:
            raise MeaningError(path, f"`{held}` would be the count {raw}, which stands for {absent.name}")
        return raw
    if value.enum:
        names = ", ".join(member.name for member in device.enums[value.enum].members)
        raise MeaningError(path, f"`{held}` is no member of {value.enum}: {names}")
    unit = f", or with its unit {value.unit}" if value.unit else ""
    raise MeaningError(path, f"`{held}` is no number; give a count{unit}")


def _word(device: Device, path: str, value: Value, held: list[object] | str) -> int:
    """The word with the named bits set; `name=member` or `name=number` sets a field of several bits."""
    flags = device.flags[value.flags]
    word = 0
    for item in held if isinstance(held, list) else [piece for piece in re.split(r"[, ]+", held) if piece]:
        name, _, setting = str(item).partition("=")
        bit = flags.named(name)
        if bit is None:
            names = ", ".join(other.name for other in flags.bits if not other.reserved)
            raise MeaningError(path, f"`{name}` is no bit of {value.flags}: {names}")
        number = 1
        if setting:
            member = device.enums[bit.enum].named(setting) if bit.enum else None
            if member is None and not setting.isdigit():
                raise MeaningError(path, f"`{setting}` is no value of {name}")
            number = member.value if member else int(setting)
        if number >> bit.width:
            raise MeaningError(path, f"{number} does not fit the {bit.width} bits of {name}")
        word |= number << bit.first
    return word
